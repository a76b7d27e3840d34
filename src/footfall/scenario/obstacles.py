"""What can stand on the plane: ramps, stairs, hills and plates that move, put ahead of somebody."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from footfall.adaptation import HeightField, Platform, Ramp, Stairs
from footfall.arrays import Floats
from footfall.scenario.ground_change import GroundKind

__all__ = ["Obstacle", "Place", "grid_line", "obstacles_of", "raised"]

Obstacle = Ramp | Stairs | Platform | HeightField

Place = tuple[float, float, float]
"""x, z [m] and heading [rad]."""

AHEAD = 1.6
"""Where an obstacle begins, so that nobody stands in it [m]."""

WIDTH = 3.0
"""Across the way [m]."""

RAMP, RAMP_RISE = 3.0, 0.5
STEPS, RISE, TREAD = 5, 0.15, 0.36
PLATE, PLATE_HEIGHT = 4.0, 0.07
SWING, SWING_PERIOD = 0.6, 6.0
TURNING = 0.25

FIELD, SPACING, BUMP = 18.0, 0.25, 0.16
"""Side of a field of hills, distance of its heights, and height of the hills [m]."""

FLAT = 1.0
"""Around the middle of a field nothing rises [m]."""


def obstacles_of(kind: GroundKind, place: Place) -> tuple[Obstacle, ...]:
    """Return what is put ahead of a place, as if the plane lay at height 0."""
    if kind == "ramp":
        return _ramps(place, AHEAD)
    if kind == "stairs":
        return _stairs(place, AHEAD)
    if kind == "hills":
        return (_hills(place),)
    if kind == "moving plate":
        return (_plate(place, AHEAD, swing=SWING),)
    if kind == "turning plate":
        return (_plate(place, AHEAD, turning=TURNING),)
    if kind == "course":
        stairs = AHEAD + 2.0 * RAMP + 4.0
        plate = stairs + 2.0 * STEPS * TREAD + 4.0
        return (
            *_ramps(place, AHEAD),
            *_stairs(place, stairs),
            _plate(place, plate, swing=SWING),
        )
    return ()


def raised(obstacle: Obstacle, rise: float) -> Obstacle:
    """Return an obstacle that is higher [m]."""
    if isinstance(obstacle, HeightField):
        return replace(obstacle, heights=obstacle.heights + rise)
    x, y, z = obstacle.place
    return replace(obstacle, place=(x, y + rise, z))


def grid_line(count: int, spacing: float) -> Floats:
    """Return where the heights of a field are along one axis from its middle [m], (count,)."""
    return spacing * (np.arange(count, dtype=np.float64) - 0.5 * (count - 1))


def _ahead(place: Place, way: float, height: float = 0.0) -> tuple[float, float, float]:
    x, z, heading = place
    return x + way * math.sin(heading), height, z + way * math.cos(heading)


def _ramps(place: Place, start: float) -> tuple[Obstacle, ...]:
    top = start + RAMP
    sizes = {"width": WIDTH, "heading": place[2]}
    return (
        Ramp(_ahead(place, start), RAMP, RAMP_RISE, **sizes),
        Ramp(_ahead(place, top, RAMP_RISE), 2.0, 0.0, **sizes),
        Ramp(_ahead(place, top + 2.0, RAMP_RISE), RAMP, -RAMP_RISE, **sizes),
    )


def _stairs(place: Place, start: float) -> tuple[Obstacle, ...]:
    top, height = start + STEPS * TREAD + 2.0, STEPS * RISE
    return (
        Stairs(_ahead(place, start), STEPS, RISE, TREAD, WIDTH, 2.0, place[2]),
        Stairs(_ahead(place, top, height), STEPS, -RISE, TREAD, WIDTH, 0.01, place[2]),
    )


def _plate(place: Place, start: float, *, swing: float = 0.0, turning: float = 0.0) -> Obstacle:
    across = (swing * math.cos(place[2]), 0.0, -swing * math.sin(place[2]))
    return Platform(
        _ahead(place, start + 0.5 * PLATE, PLATE_HEIGHT),
        (PLATE, PLATE),
        across,
        SWING_PERIOD if swing else 0.0,
        turning,
    )


def _hills(place: Place) -> Obstacle:
    count = int(FIELD / SPACING) + 1
    along = grid_line(count, SPACING)
    z, x = np.meshgrid(along, along, indexing="ij")
    bumps = 1.0 + 0.5 * np.sin(1.7 * x + 0.4) * np.sin(1.3 * z) - 0.5 * np.cos(0.9 * x + 1.1 * z)
    distance = np.hypot(x, z)
    edge = 0.5 * FIELD - np.maximum(np.abs(x), np.abs(z))
    share = np.clip((distance - FLAT) / 2.0, 0.0, 1.0) * np.clip(edge / 2.0, 0.0, 1.0)
    share = share * share * (3.0 - 2.0 * share)
    return HeightField(BUMP * share * bumps, SPACING, (place[0], place[1]))
