"""Feet on the ground: they hold where they came down, on whatever that is (stage 7)."""

from __future__ import annotations

import math

from footfall.adaptation.footprints import (
    GRIP_TIME,
    approach,
    gentle_spring,
    hold_foot,
    release_foot,
)
from footfall.adaptation.surface_record import Ground
from footfall.adaptation.surfaces import carry, is_level, probe
from footfall.blending.root import mix_point
from footfall.compilation import small_kernel
from footfall.engine.feet import carries
from footfall.engine.foot_turns import turn_foot
from footfall.engine.moment import Moment
from footfall.engine.record import Character
from footfall.engine.sole_points import move_points
from footfall.engine.swinging import rise_below, swing_goal
from footfall.skeleton.rig import Rig

__all__ = ["keep_footprints", "ride"]

LEVEL_SPEED = 12.0
"""Of the spring with which the root follows the ground under its feet [1/s]."""

LEVEL_HARDEST = 20.0
"""The most by which it is accelerated so [m/s²]."""

HIGHEST_OVER = 0.1
"""Most that it is over the lower of them, on level treads [m]."""

HIGHER_ON_SLOPES = 0.2
"""How much more that is for each meter that the ground rises per meter [m]."""

FASTEST_SWELL = 2.0
"""Ground that rises or sinks faster than this has been exchanged for another [m/s]."""

TILT_TIME = 0.04
"""Time constant with which a sole takes the slope of the ground [s]."""

TILT_HEIGHT = 0.25
"""Height over the ground from which a swinging foot is not tilted [m]."""


@small_kernel
def ride(ground: Ground, me: Character, dt: float) -> None:
    """Go with the surfaces that carry the feet, before the root makes its own way."""
    if ground.even:
        return
    x, y, z, turn, feet = 0.0, 0.0, 0.0, 0.0, 0
    for side in range(2):
        if carries(me.support, side) and not me.placed:
            dx, dy, dz, yaw = carry(
                ground, me.surface[side], me.root[0], me.root[1], me.clock - dt, me.clock
            )
            x, y, z, turn, feet = x + dx, y + dy, z + dz, turn + yaw, feet + 1
    if feet > 0:
        me.root[0] += x / feet
        me.root[1] += z / feet
        me.root[2] += turn / feet
        rise = y / feet
        me.level[0] += rise
        for side in range(2):
            if carries(me.support, side):
                me.foot_offset[side, 1] -= rise
            else:
                # A swinging foot goes along, as if the ground under it rose as much.
                me.ground_below[side] += rise


@small_kernel
def _raise_level(me: Character, rise: float) -> None:
    """Move the root's level; the feet stay where they are in the world."""
    me.level[0] += rise
    for side in range(2):
        me.foot_offset[side, 1] -= rise


@small_kernel
def keep_footprints(ground: Ground, rig: Rig, me: Character, moment: Moment, dt: float) -> None:
    """Hold the carrying feet where they are, let go of the others (stage 7)."""
    for side in range(2):
        planted = carries(me.support, side)
        if me.twisted:
            turn_foot(me, moment, side, planted, _grip(me, side), dt)
        slide_x, slide_z = move_points(rig, me, moment, side, dt)
        me.planted_time[side] = me.planted_time[side] + dt if planted else 0.0
        dx, dy, dz = _taken(ground, me, side, dt)
        below = me.foot_ground[side, me.on_toes[side]]
        _feel(ground, rig, me, moment, side, planted, dt)
        if not me.printed or me.placed:
            continue
        offset, velocity = me.foot_offset[side], me.foot_velocity[side]
        needed = _needed_height(rig, me, moment, side)
        if planted:
            offset[1] += dy + _swelled(ground, me, side, below + dy, dt)
            slide = (slide_x - dx, slide_z - dz)
            hold_foot(offset, velocity, slide, needed, _grip(me, side), dt)
        else:
            offset[1] += rise_below(me, side, dt)
            goal, speed = swing_goal(ground, me, side)
            release_foot(offset, velocity, goal, needed, speed, dt)
    _follow_ground(me, dt)
    if me.placed and me.printed and not is_level(ground):
        _put_down(ground, rig, me, moment)


@small_kernel
def _put_down(ground: Ground, rig: Rig, me: Character, moment: Moment) -> None:
    """Put the feet of a character that was put somewhere on the ground there, tilted as it is."""
    for side in range(2):
        planted = carries(me.support, side)
        move_points(rig, me, moment, side, 0.0)
        _feel(ground, rig, me, moment, side, planted, 0.0)
        move_points(rig, me, moment, side, 0.0)
    _follow_ground(me, 0.0)
    for side in range(2):
        height = _needed_height(rig, me, moment, side)
        if not carries(me.support, side):
            height = max(height, me.ground_below[side] - me.level[0])
        me.foot_offset[side, 1] = height


@small_kernel
def _taken(ground: Ground, me: Character, side: int, dt: float) -> tuple[float, float, float]:
    """Return how far the surface under a carrying foot has taken it in this step [m]."""
    if me.placed or ground.even:
        return 0.0, 0.0, 0.0
    share, offset = me.toe_shares[side], me.foot_offset[side]
    x = mix_point(me.world_points, side, share, 0) + offset[0]
    z = mix_point(me.world_points, side, share, 2) + offset[2]
    dx, dy, dz, _ = carry(ground, me.surface[side], x, z, me.clock - dt, me.clock)
    me.carried[side, 0] += dx
    me.carried[side, 1] += dy
    me.carried[side, 2] += dz
    return dx, dy, dz


@small_kernel
def _swelled(ground: Ground, me: Character, side: int, below: float, dt: float) -> float:
    """Return how far ground whose heights change has risen under a foot that carries [m].

    Args:
        ground: The ground as it is now.
        me: The character.
        side: Which foot.
        below: How high the ground under the point that carries would be, had it not changed [m].
        dt: Time step [s].
    """
    if ground.even or me.planted_time[side] <= dt:
        return 0.0
    rise = me.foot_ground[side, me.on_toes[side]] - below
    return rise if abs(rise) <= FASTEST_SWELL * dt else 0.0


@small_kernel
def _feel(
    ground: Ground, rig: Rig, me: Character, moment: Moment, side: int, planted: bool, dt: float
) -> None:
    """Find the ground under heel and toe, and tilt the sole towards its slope."""
    offset = me.foot_offset[side]
    slope_x, slope_z, surface = 0.0, 0.0, -1
    for point in range(2):
        place = me.world_points[side, point]
        found = probe(ground, place[0] + offset[0], place[2] + offset[2], me.clock)
        me.foot_ground[side, point] = found.height
        if (point == 1) == (me.on_toes[side] != 0):
            slope_x, slope_z, surface = found.slope_x, found.slope_z, found.surface
    # A foot that comes to carry stays on its surface until it lets go.
    if not planted:
        me.surface[side] = -1
    elif me.surface[side] < 0:
        me.surface[side] = surface
    me.ground_slope[side, 0], me.ground_slope[side, 1] = slope_x, slope_z
    share = 1.0
    if planted or me.placed:
        me.ground_below[side] = 0.5 * (me.foot_ground[side, 0] + me.foot_ground[side, 1])
    if not planted:
        low = rig.leg_length * min(moment.heights[side, 0], moment.heights[side, 1])
        share = min(max(1.0 - low / TILT_HEIGHT, 0.0), 1.0)
    goal_x, goal_z = share * slope_x, share * slope_z
    if me.placed:
        me.foot_slope[side, 0], me.foot_slope[side, 1] = goal_x, goal_z
    me.foot_slope[side, 0] = approach(me.foot_slope[side, 0], goal_x, TILT_TIME, dt)
    me.foot_slope[side, 1] = approach(me.foot_slope[side, 1], goal_z, TILT_TIME, dt)


@small_kernel
def _needed_height(rig: Rig, me: Character, moment: Moment, side: int) -> float:
    """Return how far a foot must be raised for its lowest point to touch the ground [m]."""
    needed = 0.0
    for point in range(2):
        own = me.level[0] + rig.leg_length * moment.heights[side, point] + me.tilt_rise[side, point]
        rise = me.foot_ground[side, point] - own
        needed = rise if point == 0 else max(needed, rise)
    return needed


@small_kernel
def _grip(me: Character, side: int) -> float:
    """Return how firmly a carrying foot is held: less where its span begins or ends."""
    grip = min(1.0, me.planted_time[side] / GRIP_TIME)
    if me.slot_duration > 0.0 and not carries(me.results[1], side):
        left = (1.0 - me.slot_progress) * me.slot_duration
        grip = min(grip, left / GRIP_TIME)
    return max(grip, 0.0)


@small_kernel
def _ground_of(me: Character, side: int) -> float:
    """Return how high the ground is under a foot, or where it is going to land [m]."""
    if me.landing_time[side] >= 0.0:
        return me.landing[side, 2]
    return 0.5 * (me.foot_ground[side, 0] + me.foot_ground[side, 1])


@small_kernel
def _follow_ground(me: Character, dt: float) -> None:
    """Let the root's level follow the ground under both feet, nearer to the lower one.

    So the leg that stands lower reaches: going up, the body rises when that foot is lifted; going
    down, it sinks before the other one lands.
    """
    low, high = _ground_of(me, 0), _ground_of(me, 1)
    lower = 0
    if low > high:
        low, high = high, low
        lower = 1
    steepest = 0.0
    for side in range(2):
        slope = me.ground_slope[side]
        steepest = max(steepest, math.sqrt(slope[0] * slope[0] + slope[1] * slope[1]))
    # A body goes down on the leg that stands, before the other one lands.
    over = 0.0 if me.landing_time[lower] >= 0.0 else HIGHEST_OVER
    goal = low + min(0.5 * (high - low), over + HIGHER_ON_SLOPES * steepest)
    if me.placed:
        me.level[0], me.level[1] = goal, 0.0
        return
    level, speed = me.level[0], me.level[1]
    level, me.level[1] = gentle_spring(level, speed, goal, LEVEL_SPEED, LEVEL_HARDEST, dt)
    _raise_level(me, level - me.level[0])
