"""How high surfaces are at a place and a time, and how they move: for the kernels."""

from __future__ import annotations

import math
from typing import NamedTuple

from footfall.adaptation.surface_record import FIELD, STAIRS, Ground, Surface
from footfall.arrays import Floats
from footfall.compilation import inner_kernel, small_kernel
from footfall.geometry import transforms

__all__ = ["Contact", "carry", "frame_of", "is_level", "probe"]

TURN = 2.0 * math.pi


class Contact(NamedTuple):
    """What is found under a place."""

    height: float
    """[m]"""

    slope_x: float
    """Rise per meter along the world's x."""

    slope_z: float
    """Rise per meter along the world's z."""

    surface: int
    """Which surface it is; -1 where there is none."""


@small_kernel
def frame_of(surface: Surface, time: float) -> tuple[float, float, float, float]:
    """Return where a surface is at a clock time: x, y, z [m] and heading [rad]."""
    share = time
    if surface.period > 0.0:
        share = math.sin(TURN * time / surface.period)
    return (
        surface.x + share * surface.way_x,
        surface.y + share * surface.way_y,
        surface.z + share * surface.way_z,
        surface.heading + time * surface.turning,
    )


@small_kernel
def is_level(ground: Ground) -> bool:
    """Return whether the ground is one level plane."""
    one = ground.surfaces[0]
    return ground.even and one.slope_x == 0.0 and one.slope_z == 0.0


@small_kernel
def probe(ground: Ground, x: float, z: float, time: float) -> Contact:
    """Return what lies under a place at a clock time; height 0 and level where nothing does."""
    if ground.even:
        one = ground.surfaces[0]
        height = one.y + one.slope_x * x + one.slope_z * z
        return Contact(height, one.slope_x, one.slope_z, 0)
    return _highest(ground, x, z, time)


@inner_kernel
def _highest(ground: Ground, x: float, z: float, time: float) -> Contact:
    """Return what lies under a place where there are several surfaces, or one that ends."""
    best = Contact(0.0, 0.0, 0.0, -1)
    for index in range(ground.surfaces.shape[0]):
        surface = ground.surfaces[index]
        fx, fy, fz, heading = frame_of(surface, time)
        lx, lz = transforms.apply(0.0, 0.0, -heading, x - fx, z - fz)
        if abs(lx) > surface.half_x or abs(lz) > surface.half_z:
            continue
        rise, slope_x, slope_z = _relief(ground, surface, lx, lz, time)
        height = fy + rise
        if best.surface < 0 or height > best.height:
            world_x, world_z = transforms.apply(0.0, 0.0, heading, slope_x, slope_z)
            best = Contact(height, world_x, world_z, index)
    return best


@inner_kernel
def _relief(
    ground: Ground, surface: Surface, x: float, z: float, time: float
) -> tuple[float, float, float]:
    """Return how high a surface is over its frame, and its slopes, at a place in that frame."""
    if surface.kind == STAIRS:
        done = math.floor((z + surface.half_z) / surface.tread) + 1.0
        return surface.rise * min(max(done, 0.0), float(surface.steps)), 0.0, 0.0
    if surface.kind == FIELD:
        return _interpolated(ground.samples, surface, x, z)
    slope_x, slope_z = surface.slope_x, surface.slope_z
    if surface.tilt_x != 0.0 or surface.tilt_z != 0.0:
        share = math.sin(TURN * time / surface.period)
        slope_x, slope_z = slope_x + share * surface.tilt_x, slope_z + share * surface.tilt_z
    return slope_x * x + slope_z * z, slope_x, slope_z


@inner_kernel
def _interpolated(
    samples: Floats, surface: Surface, x: float, z: float
) -> tuple[float, float, float]:
    """Return height and slopes of a grid, linear between its heights; its edge goes on level."""
    columns, rows = surface.count_x, surface.count_z
    u = min(max(x / surface.spacing + 0.5 * (columns - 1), 0.0), columns - 1.0)
    v = min(max(z / surface.spacing + 0.5 * (rows - 1), 0.0), rows - 1.0)
    column, row = min(int(u), columns - 2), min(int(v), rows - 2)
    u, v = u - column, v - row
    corner = surface.first + row * columns + column
    a, b = samples[corner], samples[corner + 1]
    c, d = samples[corner + columns], samples[corner + columns + 1]
    height = (1.0 - v) * ((1.0 - u) * a + u * b) + v * ((1.0 - u) * c + u * d)
    slope_x = ((1.0 - v) * (b - a) + v * (d - c)) / surface.spacing
    slope_z = ((1.0 - u) * (c - a) + u * (d - b)) / surface.spacing
    return height, slope_x, slope_z


@inner_kernel
def carry(
    ground: Ground, surface: int, x: float, z: float, before: float, after: float
) -> tuple[float, float, float, float]:
    """Return how a surface takes a place with it: displacement x, y, z [m] and turn [rad].

    Args:
        ground: All surfaces.
        surface: Which one; -1 for none, which goes nowhere.
        x: The place at `before` [m].
        z: Likewise.
        before: Clock time [s].
        after: Clock time [s].
    """
    if surface < 0:
        return 0.0, 0.0, 0.0, 0.0
    one = ground.surfaces[surface]
    ax, ay, az, a_heading = frame_of(one, before)
    bx, by, bz, b_heading = frame_of(one, after)
    turn = b_heading - a_heading
    moved_x, moved_z = transforms.apply(bx, bz, turn, x - ax, z - az)
    rise = by - ay
    if one.tilt_x != 0.0 or one.tilt_z != 0.0:
        lx, lz = transforms.apply(0.0, 0.0, -a_heading, x - ax, z - az)
        rise += _relief(ground, one, lx, lz, after)[0] - _relief(ground, one, lx, lz, before)[0]
    return moved_x - x, rise, moved_z - z, turn
