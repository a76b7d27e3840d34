"""Feet that stay as they were planted while the root is steered to where no motion turns."""

from __future__ import annotations

from footfall.adaptation.footprints import RELEASE_SPEED, spring
from footfall.compilation import small_kernel
from footfall.engine.moment import Moment
from footfall.engine.record import Character
from footfall.geometry import quaternions

__all__ = ["foot_rotation", "steered_turn", "turn_foot"]

LEAD_TIME = 0.3
"""Half of a usual stance [s]: a swinging foot is turned ahead by what the root will turn in it, so
that in the middle of the stance it points where the body does."""

FARTHEST_AHEAD = 0.35
"""The most that it is turned ahead [rad]."""

LEAST = 1e-3
"""A turn below this is none [rad]."""


@small_kernel
def steered_turn(me: Character, moment: Moment, dt: float) -> float:
    """Return how far the root turns in this step: as it is steered, else as its motions do [rad].

    Written: whether feet are turned against their motions.
    """
    if not me.steered:
        return moment.way[2]
    me.twisted = True
    return me.steer * dt


@small_kernel
def turn_foot(
    me: Character, moment: Moment, side: int, planted: bool, grip: float, dt: float
) -> None:
    """Keep a carrying foot's heading while the root turns; let a swinging one get ahead of it.

    Args:
        me: The character.
        moment: What this frame has found out.
        side: Which foot.
        planted: Whether it carries.
        grip: How firmly it is held, 0..1.
        dt: Time step [s].
    """
    turn = me.foot_turn[side]
    if me.placed or not me.printed:
        turn[0] = turn[1] = 0.0
        return
    if dt <= 0.0:
        return
    beyond = me.steer * dt - moment.way[2] if me.steered else 0.0
    if planted:
        turn[0] -= grip * beyond
        turn[1] = -grip * beyond / dt
        return
    ahead = min(max(beyond / dt * LEAD_TIME, -FARTHEST_AHEAD), FARTHEST_AHEAD)
    turn[0], turn[1] = spring(turn[0], turn[1], ahead, RELEASE_SPEED, dt)
    other = me.foot_turn[1 - side]
    still = abs(turn[0]) < LEAST and abs(other[0]) < LEAST
    if still and not me.steered:
        turn[0] = turn[1] = other[0] = other[1] = 0.0
        me.twisted = False


@small_kernel
def foot_rotation(
    me: Character, side: int, slope_x: float, slope_z: float
) -> tuple[float, float, float, float]:
    """Return how a foot is turned and then tilted as the ground is, w, x, y, z.

    Args:
        me: The character.
        side: Which foot.
        slope_x: Rise per meter along x of the frame in which the rotation is meant.
        slope_z: Likewise.
    """
    w, x, y, z = quaternions.between(0.0, 1.0, 0.0, -slope_x, 1.0, -slope_z)
    if not me.twisted:
        return w, x, y, z
    tw, tx, ty, tz = quaternions.from_yaw(me.foot_turn[side, 0])
    return quaternions.product(w, x, y, z, tw, tx, ty, tz)
