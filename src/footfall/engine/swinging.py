"""Where a swinging foot goes: over what lies ahead of it, and down behind it (part of stage 7)."""

from __future__ import annotations

from footfall.adaptation.footprints import LIFT_SPEED
from footfall.adaptation.surface_record import Ground
from footfall.adaptation.surfaces import probe
from footfall.compilation import small_kernel
from footfall.engine.landing import STEEPEST
from footfall.engine.record import Character

__all__ = ["rise_below", "swing_goal"]

AHEAD = 0.1
"""How far ahead a swinging foot looks for what it has to clear [s]."""

GLANCES = 5
"""At how many places on that way."""

SINK_SPEED = 40.0
"""Of the spring that lowers a foot to its place behind the last edge [1/s]."""

UNHURRIED = 6.0
"""A spring of this many over the time that is left [1] has come to its goal by then."""


@small_kernel
def rise_below(me: Character, side: int, dt: float) -> float:
    """Return how far the ground has risen under a swinging foot in this step [m], edges apart."""
    below = 0.5 * (me.foot_ground[side, 0] + me.foot_ground[side, 1])
    rise = below - me.ground_below[side]
    me.ground_below[side] = below
    vx, vz = me.toe_velocity[side]
    return rise if rise * rise <= STEEPEST * STEEPEST * (vx * vx + vz * vz) * dt * dt else 0.0


@small_kernel
def _highest_ahead(ground: Ground, me: Character, side: int) -> float:
    """Return how high the ground is under a swinging foot, edges ahead of it included [m].

    An even slope is no obstacle: what counts is by how much it rises beyond that.
    """
    if ground.even:
        return me.ground_below[side]
    offset, slope = me.foot_offset[side], me.ground_slope[side]
    below, toe = me.ground_below[side], me.world_points[side, 1]
    highest = 0.0
    longest = AHEAD
    if me.landing_time[side] >= 0.0:
        longest = min(AHEAD, 0.5 * me.landing_time[side])
    for glance in range(1, GLANCES + 1):
        ahead = longest * glance / GLANCES
        x, z = ahead * me.toe_velocity[side, 0], ahead * me.toe_velocity[side, 1]
        found = probe(ground, toe[0] + offset[0] + x, toe[2] + offset[2] + z, me.clock).height
        even = me.foot_ground[side, 1] + slope[0] * x + slope[1] * z
        highest = max(highest, found - even)
    return below + highest


@small_kernel
def swing_goal(
    ground: Ground, me: Character, side: int
) -> tuple[tuple[float, float, float], float]:
    """Return where a swinging foot's offset should go [m], and how fast it goes up or down [1/s].

    It rises at once to a place that is higher, and sinks to a lower one behind the last edge.
    """
    highest = _highest_ahead(ground, me, side) - me.level[0]
    left = me.landing_time[side]
    if left < 0.0:
        return (0.0, highest, 0.0), LIFT_SPEED
    landing = me.landing[side]
    goal = max(highest, landing[2] - me.level[0])
    speed = min(UNHURRIED / max(left, 1e-3), LIFT_SPEED)
    if goal < me.foot_offset[side, 1]:
        speed = SINK_SPEED
    return (landing[0], goal, landing[1]), speed
