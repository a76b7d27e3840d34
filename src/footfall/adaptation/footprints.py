"""Footprints: a foot that carries stays where it came down, and is let go without a jump.

A footprint is kept as the offset by which a foot is moved. While the foot carries, the offset
takes back what the blended pose would let the carrying point slide; that point rolls from heel
to toe with the foot. Afterwards the offset springs back to nothing during the swing.
"""

from __future__ import annotations

import math

from footfall.arrays import Positions
from footfall.compilation import small_kernel

__all__ = [
    "GRIP_TIME",
    "LIFT_SPEED",
    "RELEASE_SPEED",
    "ROLL_TIME",
    "SPEED_TIME",
    "approach",
    "gentle_spring",
    "hold_foot",
    "release_foot",
    "settle",
    "spring",
    "toe_lead",
]

LOWER = 0.004
"""Difference of height from which the lower of heel and toe is the one that carries [m]."""

SLOWER = 0.02
"""Difference of speed that counts as much [m/s]."""

SPEED_TIME = 0.06
"""Time constant of the filter over those speeds [s]."""

ROLL_TIME = 0.02
"""Time constant with which the weight passes from heel to toe [s]."""

GRIP_TIME = 0.05
"""Time in which a foot takes hold at the start of a span, and lets go at its end [s]: a real
foot still or already moves there, and stopping it at once would jerk."""

RELEASE_SPEED = 14.0
"""Of the spring that takes an offset back during the swing [1/s]."""

LIFT_SPEED = 30.0
"""Of the spring that raises a swinging foot over what lies ahead [1/s]."""

HARDEST_LIFT, HARDEST_SINK = 66.0, 80.0
"""The most by which a swinging foot is accelerated towards a place above or below it [m/s²]."""

SETTLE_SPEED = 50.0
"""Of the spring that brings a carrying foot to the height of the ground [1/s]."""

HARDEST_SETTLE = 60.0
"""The most by which that accelerates it [m/s²]."""


@small_kernel
def toe_lead(heel_height: float, toe_height: float, heel_speed: float, toe_speed: float) -> float:
    """Return how clearly the toe of a foot carries rather than its heel: above 1, or below -1.

    The lower of the two carries; where they are level it is the slower one, for a foot that
    turns on the spot turns about the point that stays.

    Args:
        heel_height: Over its own height at rest [m].
        toe_height: Likewise.
        heel_speed: Over the ground [m/s].
        toe_speed: Likewise.
    """
    return (heel_height - toe_height) / LOWER + (heel_speed - toe_speed) / SLOWER


@small_kernel
def approach(value: float, goal: float, time: float, dt: float) -> float:
    """Return a value that has gone towards a goal for `dt`, with this time constant [s]."""
    return goal if value == goal else goal + (value - goal) * math.exp(-dt / time)


@small_kernel
def spring(
    value: float, speed: float, goal: float, stiffness: float, dt: float
) -> tuple[float, float]:
    """Return value and speed after `dt` [s] of a critically damped spring towards a goal.

    Exact for any `dt`: cutting it into pieces changes nothing.
    """
    if value == goal and speed == 0.0:
        return goal, 0.0
    return settle(value, speed, goal, stiffness, dt, math.exp(-stiffness * dt))


@small_kernel
def settle(
    value: float, speed: float, goal: float, stiffness: float, dt: float, decay: float
) -> tuple[float, float]:
    """Return what `spring` does, where `decay` is what is left of anything after `dt`, 0..1."""
    away = value - goal
    pull = speed + stiffness * away
    return goal + (away + pull * dt) * decay, (speed - stiffness * pull * dt) * decay


@small_kernel
def gentle_spring(
    value: float, speed: float, goal: float, stiffness: float, hardest: float, dt: float
) -> tuple[float, float]:
    """Return what `spring` does, where the speed changes at most by `hardest` [1/s²]."""
    new, new_speed = spring(value, speed, goal, stiffness, dt)
    if abs(new_speed - speed) <= hardest * dt:
        return new, new_speed
    new_speed = speed + math.copysign(hardest * dt, new_speed - speed)
    return value + 0.5 * (speed + new_speed) * dt, new_speed


@small_kernel
def hold_foot(
    offset: Positions,
    velocity: Positions,
    slide: tuple[float, float],
    height: float,
    grip: float,
    dt: float,
) -> None:
    """Keep a carrying foot in its footprint.

    Args:
        offset: How far the foot is moved [m], shape (3,); updated.
        velocity: How fast that changes [m/s], shape (3,); updated.
        slide: How far the blended pose moved the carrying point over the ground, x and z [m].
        height: How far the foot has to be raised for its lowest point to touch the ground [m].
        grip: How firmly it is held, 0..1.
        dt: Time step [s].
    """
    for axis, moved in ((0, slide[0]), (2, slide[1])):
        offset[axis] -= grip * moved
        velocity[axis] = -grip * moved / dt if dt > 0.0 else 0.0
    offset[1], velocity[1] = gentle_spring(
        offset[1], velocity[1], height, SETTLE_SPEED, HARDEST_SETTLE, dt
    )


@small_kernel
def release_foot(
    offset: Positions,
    velocity: Positions,
    goal: tuple[float, float, float],
    least: float,
    lift: float,
    dt: float,
) -> None:
    """Take a swinging foot's offset to where it should be; arguments as in `hold_foot`.

    Args:
        offset: Updated, shape (3,) [m].
        velocity: Updated, shape (3,) [m/s].
        goal: What it should be [m]: 0 over level ground, on the way to no particular place.
        least: How far it has to be raised at least, not to be under the ground [m].
        lift: Speed of the spring that raises or lowers it [1/s].
        dt: Time step [s].
    """
    for axis, place in ((0, goal[0]), (2, goal[2])):
        offset[axis], velocity[axis] = spring(
            offset[axis], velocity[axis], place, RELEASE_SPEED, dt
        )
    hardest = HARDEST_LIFT if goal[1] > offset[1] else HARDEST_SINK
    offset[1], velocity[1] = gentle_spring(offset[1], velocity[1], goal[1], lift, hardest, dt)
    if offset[1] < least:
        offset[1] = least
        velocity[1] = max(velocity[1], 0.0)
