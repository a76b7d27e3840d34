"""While nothing touches the ground: the body falls freely, however long that is made (S-27).

A flight that is stretched hangs in the air, and one that is mixed bends the parabola. With the
option on, the pelvis leaves at the speed that takes it to where the motions land, when they land,
and is pulled down by gravity alone; the body goes with it. What is then left between the two is
let go softly while the feet carry again.
"""

from __future__ import annotations

from typing import Literal

from footfall.adaptation.footprints import spring
from footfall.compilation import small_kernel
from footfall.engine.moment import Moment
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf, key_at, phase_end
from footfall.engine.state import RUNNING
from footfall.errors import ArgumentError
from footfall.octets import LANES
from footfall.skeleton import BodyPart
from footfall.skeleton.rig import Rig
from footfall.support import Support

__all__ = ["BALLISTIC", "FLIGHTS", "FREE_FLIGHT", "FROZEN", "Flight", "flight_of", "fly"]

Flight = Literal["played", "frozen", "ballistic"]
"""What happens in a flight: motions are played as they are; weights stay what they were at
take-off; and the body falls freely too."""

FREE_FLIGHT, FROZEN, BALLISTIC = 0, 1, 2
"""What `Character.flight` says."""

FLIGHTS: dict[str, int] = {"played": FREE_FLIGHT, "frozen": FROZEN, "ballistic": BALLISTIC}
"""The same by name."""

LEGS = int(BodyPart.LEGS)
NO_SUPPORT = int(Support.FLIGHT)

GRAVITY = 9.81
"""[m/s²]"""

SHORTEST_FLIGHT = 0.03
"""No flight is taken to be shorter than this when the speed of take-off is chosen [s]."""

LANDING = 12.0
"""Of the spring that lets go what is left after a landing [1/s]."""


def flight_of(name: str) -> int:
    """Return the number of a flight.

    Raises:
        ArgumentError: If there is none of this name.
    """
    if name not in FLIGHTS:
        raise ArgumentError(f"no flight {name!r}; there are {', '.join(FLIGHTS)}")
    return FLIGHTS[name]


@small_kernel
def fly(shelf: Shelf, rig: Rig, me: Character, moment: Moment, dt: float) -> None:
    """Move the blended body up or down so that it falls freely while nothing carries it."""
    leg = rig.leg_length
    blended = leg * moment.effectors[0]
    rise = (blended - me.pelvis[0]) / dt if dt > 0.0 else 0.0
    before = me.pelvis[0] + me.lift[0]
    me.pelvis[0] = blended
    if me.flight != BALLISTIC or not me.synchronized or me.fresh or me.placed or dt <= 0.0:
        me.aloft = False
        me.lift[0], me.lift[1] = (me.lift[0], me.lift[1]) if dt <= 0.0 else (0.0, 0.0)
        if me.flight != BALLISTIC:
            return
    elif me.support == NO_SUPPORT:
        if not me.aloft:
            me.aloft = True
            time, landing = _landing(shelf, leg, me)
            time = max(time + dt, SHORTEST_FLIGHT)
            me.pelvis[1] = (landing - before) / time + 0.5 * GRAVITY * time
        height = before + me.pelvis[1] * dt - 0.5 * GRAVITY * dt * dt
        me.pelvis[1] -= GRAVITY * dt
        me.lift[0], me.lift[1] = height - blended, me.pelvis[1] - rise
    else:
        me.aloft = False
        me.lift[0], me.lift[1] = spring(me.lift[0], me.lift[1], 0.0, LANDING, dt)
    # The feet go with the body; once they carry, their footprints bring them to the ground.
    lift = me.lift[0] / leg
    moment.effectors[0] += lift
    moment.effectors[2] += lift
    moment.effectors[5] += lift


@small_kernel
def _landing(shelf: Shelf, leg: float, me: Character) -> tuple[float, float]:
    """Return in how long the body lands [s], and how high the pelvis then is [m]."""
    last = 0
    left = (1.0 - me.slot_progress) * me.slot_duration
    while (
        last + 2 < me.results.shape[0]
        and me.results[last + 1] == NO_SUPPORT
        and me.durations[last + 1] > 0.0
    ):
        last += 1
        left += me.durations[last]
    height = me.weights[SEATS, LEGS] * _pelvis_height(shelf, shelf.keys.shape[0] - 1, 0.0)
    for seat in range(SEATS):
        if me.status[seat] < RUNNING or me.weights[seat, LEGS] <= 0.0:
            continue
        entry = shelf.entries[me.action[seat]]
        clip_time = me.clip_time[seat] + left
        if me.playing[seat] and not me.muted[seat]:
            clip_time = me.target[seat]
            if last > 0 and me.phases[seat, last] >= 0:
                clip_time = max(
                    clip_time, phase_end(entry, shelf.phase_starts, me.phases[seat, last])
                )
        frame, fraction, _ = key_at(entry, clip_time)
        height += me.weights[seat, LEGS] * _pelvis_height(shelf, frame, fraction)
    return left, leg * height


@small_kernel
def _pelvis_height(shelf: Shelf, frame: int, fraction: float) -> float:
    """Return how high the pelvis of a clip is over the ground, in leg lengths."""
    column = shelf.keys.shape[1] - LANES
    after = frame + 1 if fraction > 0.0 else frame
    one = float(shelf.keys[frame, column])
    return one + fraction * (float(shelf.keys[after, column]) - one)
