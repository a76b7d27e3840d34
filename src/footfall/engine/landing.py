"""Where a swinging foot will come down: on one tread, not across an edge (part of stage 7).

The clips tell where their feet are at the end of the slot; their weighted mean is where the foot
is going to land. If an edge runs under the sole there, the foot is led to the nearest place
before or behind it where none does.
"""

from __future__ import annotations

import math

from footfall.adaptation.surface_record import SLOPE, Ground
from footfall.adaptation.surfaces import carry, probe
from footfall.arrays import SmallFloats
from footfall.compilation import small_kernel
from footfall.engine.feet import carries
from footfall.engine.moment import Moment
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf, key_at, read_points, travel
from footfall.engine.state import RUNNING
from footfall.geometry import transforms
from footfall.skeleton import BodyPart
from footfall.skeleton.rig import Rig

__all__ = ["STEEPEST", "foresee_landings"]

LEGS = int(BodyPart.LEGS)

STEEPEST = 0.75
"""Rise per meter beyond which ground is an edge, which no foot stands on or follows."""

FARTHEST = 0.2
"""How far a foot is led from where it would land, at most [m]."""

STEP = 0.01
"""Between the places that are tried [m]."""

GLANCES = 6
"""At how many places along a sole, less one, edges are looked for."""

MARGINS = ((0.09, 0.02), (0.02, 0.05), (0.015, 0.01))
"""How far behind heel and before toe an edge has to be, in the order in which they are tried
[m]: well behind the heel where the foot goes down, so that it can sink in time; before the toe
joint, for the toes; and at last just not under the sole."""

KEPT = (0.01, 0.01)
"""The same for a place that was found before [m]."""

DOWN = 0.05
"""A place lower than this under the foot that lands leads down [m]; and one that is farther than
this from where the slope leads is behind an edge."""


@small_kernel
def foresee_landings(
    shelf: Shelf, ground: Ground, rig: Rig, me: Character, moment: Moment, points: SmallFloats
) -> None:
    """Find where and when each swinging foot comes down, if that is in the next slot.

    Written: `me.landing` and `me.landing_time`.

    Args:
        shelf: The library.
        ground: What it stands on; where that is even, a foot lands anywhere.
        rig: The body.
        me: The character.
        moment: What this frame has found out of it.
        points: Memory for the foot points of one motion, shape (2, 2, 3).
    """
    if ground.even:
        for side in range(2):
            me.landing_time[side] = -1.0
            me.landing[side, 0] = me.landing[side, 1] = 0.0
        return
    left = (1.0 - me.slot_progress) * me.slot_duration
    known = False
    for side in range(2):
        lands = not carries(me.support, side) and carries(me.results[1], side)
        if not lands or left <= 0.0 or me.placed:
            me.landing_time[side] = -1.0
            me.landing[side, 0] = me.landing[side, 1] = 0.0
            continue
        me.landing_time[side] = left
        known = True
    if not known:
        return
    _foresee_points(shelf, me, moment, points)
    for side in range(2):
        if me.landing_time[side] >= 0.0:
            _choose_place(ground, rig, me, moment, side)


@small_kernel
def _foresee_points(shelf: Shelf, me: Character, moment: Moment, one: SmallFloats) -> None:
    """Write heel and toe of both feet at the end of the slot, relative to the root now."""
    foreseen = moment.foreseen_points
    foreseen[:] = 0.0
    for seat in range(SEATS + 1):
        weight = me.weights[seat, LEGS]
        if weight <= 0.0 or (seat < SEATS and me.status[seat] < RUNNING):
            continue
        step = (0.0, 0.0, 0.0)
        frame, fraction = shelf.keys.shape[0] - 1, 0.0
        if seat < SEATS:
            entry = shelf.entries[me.action[seat]]
            now, then = me.clip_time[seat], max(me.target[seat], me.clip_time[seat])
            step = travel(shelf.roots, entry, now, then)
            frame, fraction, _ = key_at(entry, then)
        read_points(shelf, frame, fraction, one)
        for side in range(2):
            for point in range(2):
                place = one[side, point]
                x, z = transforms.apply(step[0], step[1], step[2], place[0], place[2])
                foreseen[side, point, 0] += weight * x
                foreseen[side, point, 2] += weight * z


@small_kernel
def _choose_place(ground: Ground, rig: Rig, me: Character, moment: Moment, side: int) -> None:
    """Write how far a foot is led from where it would land, and how high that is."""
    leg, root, points = rig.leg_length, me.root, moment.foreseen_points[side]
    heel = transforms.apply(root[0], root[1], root[2], leg * points[0, 0], leg * points[0, 2])
    toe = transforms.apply(root[0], root[1], root[2], leg * points[1, 0], leg * points[1, 2])
    landing = me.landing[side]
    # What is stood on takes the root along until then, and other surfaces go their own way.
    when, taken = me.clock + me.landing_time[side], me.surface[1 - side]
    hx, rise, hz, _ = carry(ground, taken, heel[0], heel[1], me.clock, when)
    tx, _, tz, _ = carry(ground, taken, toe[0], toe[1], me.clock, when)
    heel, toe = (heel[0] + hx, heel[1] + hz), (toe[0] + tx, toe[1] + tz)
    dx, dz = toe[0] - heel[0], toe[1] - heel[1]
    length = math.sqrt(dx * dx + dz * dz)
    if length < 1e-6:
        dx, dz, length = math.sin(root[2]), math.cos(root[2]), 1.0
    way = (dx / length, dz / length)
    if ground.surfaces.shape[0] > 1 or ground.surfaces[0].kind != SLOPE:
        led = landing[0] * way[0] + landing[1] * way[1]
        led = _nearest_place(ground, me, side, when, heel, way, length, led)
        landing[0], landing[1] = led * way[0], led * way[1]
    x, z = landing[0], landing[1]
    one = probe(ground, heel[0] + x, heel[1] + z, when).height - rise
    other = probe(ground, toe[0] + x, toe[1] + z, when).height - rise
    landing[2] = 0.5 * (one + other)
    leads = _is_on_the_way(me, side, 0, heel, one) and _is_on_the_way(me, side, 1, toe, other)
    if x == 0.0 and z == 0.0 and leads:
        me.landing_time[side] = -1.0


@small_kernel
def _is_on_the_way(
    me: Character, side: int, point: int, lands: tuple[float, float], height: float
) -> bool:
    """Return whether the slope under heel or toe leads to where it lands: nothing is between."""
    place, offset, slope = me.world_points[side, point], me.foot_offset[side], me.ground_slope[side]
    x, z = lands[0] - place[0] - offset[0], lands[1] - place[2] - offset[2]
    rise = slope[0] * x + slope[1] * z
    return abs(me.foot_ground[side, point] + rise - height) < DOWN


@small_kernel
def _nearest_place(
    ground: Ground,
    me: Character,
    side: int,
    when: float,
    heel: tuple[float, float],
    way: tuple[float, float],
    length: float,
    led: float,
) -> float:
    """Return how far ahead of where it would land a foot finds a place without an edge [m]."""
    middle = (heel[0] + 0.5 * length * way[0], heel[1] + 0.5 * length * way[1])
    down = probe(ground, middle[0], middle[1], when).height < me.ground_below[side] - DOWN
    tries = int(FARTHEST / STEP)
    # A place that was found is kept as long as it will do: a foot that hesitates comes to neither.
    if led != 0.0 and _is_even(ground, when, heel, way, length, led, KEPT):
        return led
    for attempt in range(0 if down else 1, len(MARGINS)):
        margins = MARGINS[attempt]
        for step in range(2 * tries + 1):
            ahead = STEP * ((step + 1) // 2) * (1.0 if step % 2 == 1 else -1.0)
            if _is_even(ground, when, heel, way, length, ahead, margins):
                return ahead
    return 0.0


@small_kernel
def _is_even(
    ground: Ground,
    clock: float,
    heel: tuple[float, float],
    way: tuple[float, float],
    length: float,
    ahead: float,
    margins: tuple[float, float],
) -> bool:
    """Return whether no edge runs under a sole that is led so far ahead."""
    first, last = ahead - margins[0], ahead + length + margins[1]
    spacing = (last - first) / GLANCES
    before = 0.0
    for glance in range(GLANCES + 1):
        at = first + glance * spacing
        height = probe(ground, heel[0] + at * way[0], heel[1] + at * way[1], clock).height
        if glance > 0 and abs(height - before) > STEEPEST * spacing:
            return False
        before = height
    return True
