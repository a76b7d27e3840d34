"""Surfaces of what can be stood on, each in a frame of its own in which it does not move."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from footfall.adaptation import HeightField, Platform, Ramp, Stairs
from footfall.arrays import Indices, Positions
from footfall.scenario.obstacles import grid_line

__all__ = ["Part", "Shape", "frame_at", "shape_of"]

Part = Ramp | Stairs | Platform | HeightField
"""What stands on the plane."""

ABOVE = np.array([0.0, 0.004, 0.0])
"""Lines are drawn so far over their surface [m]."""

LINES = 0.5
"""Between the lines drawn on hills [m]."""


class Shape(NamedTuple):
    """Triangles, and lines on them."""

    vertices: Positions
    """Shape (vertices, 3) [m]."""

    faces: Indices
    """Shape (faces, 3)."""

    lines: Positions
    """Shape (lines, 2, 3) [m]."""


def shape_of(part: Part) -> Shape:
    """Return how a part looks in its own frame; see `frame_at`."""
    if isinstance(part, HeightField):
        return _hills(part)
    if isinstance(part, Platform):
        return _plate(part)
    half = 0.5 * part.width
    profile = _steps(part) if isinstance(part, Stairs) else _slope(part)
    return _extruded(profile, half)


def frame_at(part: Part, time: float) -> tuple[float, float, float, float]:
    """Return where the frame of a part is at a clock time: x, y, z [m] and heading [rad]."""
    if isinstance(part, HeightField):
        return part.middle[0], 0.0, part.middle[1], 0.0
    x, y, z = part.place
    if not isinstance(part, Platform):
        return x, y, z, part.heading
    share = math.sin(2.0 * math.pi * time / part.period) if part.period > 0.0 else time
    way = part.way
    return x + share * way[0], y + share * way[1], z + share * way[2], time * part.turning


def _slope(ramp: Ramp) -> Positions:
    """Return the outline from aside of a ramp: z and y of its points, shape (points, 2)."""
    low = min(0.0, ramp.rise) - 0.02
    return np.array([[0.0, 0.0], [ramp.length, ramp.rise], [ramp.length, low], [0.0, low]])


def _steps(stairs: Stairs) -> Positions:
    outline = [(0.0, 0.0)]
    for step in range(stairs.steps):
        height = stairs.rise * (step + 1)
        outline += [(stairs.tread * step, height), (stairs.tread * (step + 1), height)]
    end = stairs.steps * stairs.tread + stairs.landing
    low = min(0.0, stairs.rise * stairs.steps) - 0.02
    outline[-1] = (end, stairs.rise * stairs.steps)
    return np.array([*outline, (end, low), (0.0, low)])


def _extruded(profile: Positions, half: float) -> Shape:
    """Return a body whose outline from aside is given, the last two of its points underneath."""
    count = len(profile)
    height, along = profile[:, 1], profile[:, 0]
    left, right = (np.column_stack([np.full(count, x), height, along]) for x in (half, -half))
    after = np.roll(np.arange(count), -1)
    quads = [*np.stack([left, right, right[after], left[after]], axis=1)]
    low = profile[-1, 1]
    for side, order in ((left, 1), (right, -1)):
        # A wall below each piece of the outline that leads on.
        for start, end in pairwise(side[: count - 2]):
            if end[2] - start[2] > 1e-9:
                corners = [[start[0], low, start[2]], start, end, [end[0], low, end[2]]]
                quads.append(np.array(corners)[::order])
    first = 4 * np.arange(len(quads))[:, np.newaxis]
    faces = np.concatenate([first + np.array(half_of) for half_of in ((0, 1, 2), (0, 2, 3))])
    edges = np.stack([left, right], axis=1)[: count - 2]
    rims = [np.stack([side[: count - 3], side[1 : count - 2]], axis=1) for side in (left, right)]
    return Shape(np.concatenate(quads), faces, np.concatenate([edges, *rims]) + ABOVE)


def _plate(plate: Platform) -> Shape:
    x, z = 0.5 * plate.size[0], 0.5 * plate.size[1]
    shape = _extruded(np.array([[-z, 0.0], [z, 0.0], [z, -0.1], [-z, -0.1]]), x)
    count = max(2, round(plate.size[1]))
    along = np.linspace(-1.0, 1.0, count + 1)
    lines = [[[-x, 0.003, z * one], [x, 0.003, z * one]] for one in along]
    lines += [[[x * one, 0.003, -z], [x * one, 0.003, z]] for one in along]
    return Shape(shape.vertices, shape.faces, np.array(lines))


def _hills(field: HeightField) -> Shape:
    rows, columns = field.heights.shape
    x, z = grid_line(columns, field.spacing), grid_line(rows, field.spacing)
    places = np.stack([np.tile(x, (rows, 1)), field.heights, np.tile(z[:, None], (1, columns))], -1)
    corner: Indices = np.reshape(np.arange(rows * columns, dtype=np.int64), (rows, columns))
    a, b, c, d = corner[:-1, :-1], corner[:-1, 1:], corner[1:, :-1], corner[1:, 1:]
    faces: Indices = np.stack([np.stack([a, c, b], -1), np.stack([b, c, d], -1)], 2).reshape(-1, 3)
    vertices = places.reshape(-1, 3)
    step = max(1, round(LINES / field.spacing))
    across = np.stack([places[::step, :-1], places[::step, 1:]], axis=2).reshape(-1, 2, 3)
    along = np.stack([places[:-1, ::step], places[1:, ::step]], axis=2).reshape(-1, 2, 3)
    return Shape(vertices, faces, np.concatenate([across, along]) + ABOVE)
