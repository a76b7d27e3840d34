"""Shorthand for scores, with angles in degrees: stances, swings, resting values."""

from __future__ import annotations

import math

from footfall.samples.curves import Knot
from footfall.samples.footsteps import Stance, Swing

__all__ = ["FOR_LONG", "RELAXED", "SINCE_LONG", "rest", "standing", "step", "stride", "swing"]

SINCE_LONG = -10.0
"""Strike of a foot that already stands when a motion begins [s]."""

FOR_LONG = 60.0
"""Leave of a foot that still stands when a motion ends [s]."""

RELAXED = (4.0, 3.0, 9.0, -15.0, 17.0)
"""A hanging arm, as in `arm_rotations` [degrees]."""


def rest(time: float, value: float, acceleration: float = 0.0) -> Knot:
    """Return the knot of a curve that stops or turns there."""
    return (time, value, 0.0, acceleration)


def standing(
    ball: tuple[float, float], toe_out: float, *, lifts: tuple[tuple[float, float], ...] = ()
) -> Stance:
    """Return a foot that stands all the time; `lifts` as in `Stance`, in degrees."""
    return Stance(
        SINCE_LONG,
        FOR_LONG,
        ball,
        heading=math.copysign(math.radians(toe_out), ball[0]),
        lifts=tuple((time, math.radians(pitch)) for time, pitch in lifts),
    )


def step(
    strike: float,
    leave: float,
    ball: tuple[float, float],
    strike_pitch: float,
    leave_pitch: float = 0.0,
    *,
    flat: float = 0.09,
    rise: float = 0.24,
    toe_out: float = 6.0,
) -> Stance:
    """Return a stance; the sign of the ball's x says which foot it is."""
    return Stance(
        strike,
        leave,
        ball,
        math.copysign(math.radians(toe_out), ball[0]),
        math.radians(strike_pitch),
        math.radians(leave_pitch),
        flat=flat,
        rise=rise,
    )


def stride(*, height: float = 0.045) -> Swing:
    """Return a walking foot's swing."""
    return Swing(
        ((0.2, height), (0.5, 0.45 * height), (0.8, 0.025)),
        tuple(
            (share, math.radians(pitch))
            for share, pitch in ((0.17, -70.0), (0.5, -18.0), (0.78, 15.0))
        ),
    )


def swing(*points: tuple[float, float, float, float, float]) -> Swing:
    """Return a swing through points: share of it, x, clearance and z [m], pitch."""
    return Swing(
        tuple((share, clearance) for share, _, clearance, _, _ in points),
        tuple((share, math.radians(pitch)) for share, _, _, _, pitch in points),
        tuple((share, x, z) for share, x, _, z, _ in points),
    )
