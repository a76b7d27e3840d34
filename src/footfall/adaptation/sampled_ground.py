"""A program's own ground as the kernels take it: a grid of heights around who stands on it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from footfall.adaptation.own_ground import Ground, frame_of_own, heights_of_own
from footfall.adaptation.surface_record import FIELD, surface_type
from footfall.adaptation.surface_record import Ground as PackedGround
from footfall.arrays import Flags, Floats
from footfall.compilation import records
from footfall.errors import GroundError
from footfall.geometry import transforms

__all__ = ["sample_ground"]

SPACING = 0.05
"""Between the places at which it is asked [m]."""

REACH = 1.7
"""How far around a character [m]: a long step, and what lies under the foot after it."""

FASTEST = 6.0
"""How fast somebody may run away from there [m/s]."""

MOST = 16_000_000
"""Places that a grid may have: 200 m in square."""

CELL = 1.0
"""Size of the cells in which it is asked, where a crowd is scattered [m]."""


def sample_ground(
    ground: Ground, places: Floats, span: tuple[float, float], dt: float
) -> PackedGround:
    """Return a ground around some characters, as it is at the end of a step.

    Args:
        ground: The ground.
        places: Where the characters are at first: x and z [m], shape (characters, 2).
        span: Clock times at which the step begins and ends [s].
        dt: How long the characters have been under way by its end [s].

    Raises:
        GroundError: If the ground fails, or they are too far apart.
    """
    before, now = span
    frame, old = frame_of_own(ground, now), frame_of_own(ground, before)
    own = np.array(
        [transforms.apply(0.0, 0.0, -frame[3], x - frame[0], z - frame[2]) for x, z in places]
    )
    reach = REACH + FASTEST * dt
    low, high = own.min(axis=0) - reach, own.max(axis=0) + reach
    counts = np.ceil((high - low) / SPACING).astype(np.int64) + 1
    if int(counts.prod()) > MOST:
        wide, long = (high - low).tolist()
        raise GroundError(
            f"characters on ground {type(ground).__name__} are scattered over {wide:.0f} × "
            f"{long:.0f} m; it is asked within 200 × 200 m at most"
        )
    columns, rows = counts.tolist()
    along, across = np.indices((rows, columns)).reshape(2, -1)
    grid: Floats = low + SPACING * np.column_stack([across, along])
    near = _near(grid, own, reach)
    heights = np.zeros(len(grid))
    heights[near] = heights_of_own(ground, grid[near], now)
    surfaces = records(np.zeros(1, dtype=surface_type))
    middle = low + 0.5 * SPACING * (counts - 1)
    fields = {"kind": FIELD, "count_x": columns, "count_z": rows, "spacing": SPACING, "first": 0}
    fields |= {"half_x": math.inf, "half_z": math.inf}
    fields |= _motion(frame, old, (float(middle[0]), float(middle[1])), before, now)
    one: Any = surfaces[0]
    for name, value in fields.items():
        one[name] = value
    packed: Any = surfaces
    return PackedGround(packed, False, heights)


def _near(grid: Floats, own: Floats, reach: float) -> Flags:
    """Return which places of a grid somebody may reach, shape (places,)."""
    if len(own) == 1:
        return np.ones(len(grid), dtype=np.bool_)
    around = math.ceil(reach / CELL)
    taken = {
        (i + di, j + dj)
        for i, j in np.unique(np.floor(own / CELL).astype(np.int64), axis=0).tolist()
        for di in range(-around, around + 1)
        for dj in range(-around, around + 1)
    }
    cells = np.floor(grid / CELL).astype(np.int64)
    low = cells.min(axis=0)
    wide, long = (cells.max(axis=0) - low + 1).tolist()
    known = np.zeros((wide, long), dtype=np.bool_)
    for i, j in taken:
        i, j = i - int(low[0]), j - int(low[1])
        if 0 <= i < wide and 0 <= j < long:
            known[i, j] = True
    inside = cells - low
    return known[inside[:, 0], inside[:, 1]]


def _motion(
    frame: tuple[float, float, float, float],
    old: tuple[float, float, float, float],
    middle: tuple[float, float],
    before: float,
    now: float,
) -> dict[str, float]:
    """Return the fields that put the middle of a grid where the frame has it, then and now."""
    x, z = transforms.apply(frame[0], frame[2], frame[3], *middle)
    old_x, old_z = transforms.apply(old[0], old[2], old[3], *middle)
    dt = now - before
    if dt <= 0.0:
        return {"x": x, "y": frame[1], "z": z, "heading": frame[3]}
    turn = math.remainder(frame[3] - old[3], math.tau)
    speeds = ((x - old_x) / dt, (frame[1] - old[1]) / dt, (z - old_z) / dt, turn / dt)
    here = (x, frame[1], z, frame[3])
    names = (("x", "way_x"), ("y", "way_y"), ("z", "way_z"), ("heading", "turning"))
    fields: dict[str, float] = {}
    for (name, way), place, speed in zip(names, here, speeds, strict=True):
        fields[name], fields[way] = place - now * speed, speed
    return fields
