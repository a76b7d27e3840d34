"""What is drawn of the ground is where the engine finds it."""

from __future__ import annotations

import numpy as np
import pytest

from footfall.adaptation import HeightField, Plane, Platform, Ramp, Stairs, Terrain, ground_heights
from footfall.geometry import from_yaw, rotate
from footfall.scenario.obstacles import obstacles_of
from footfall.studio.ground_shapes import Part, frame_at, shape_of

PARTS: list[Part] = [
    Ramp((1.0, 0.2, -2.0), 3.0, 0.5, heading=0.7),
    Ramp((1.0, 0.2, -2.0), 3.0, -0.5, heading=-2.0),
    Stairs((1.0, 0.2, -2.0), 4, heading=0.7),
    Stairs((1.0, 0.2, -2.0), 4, rise=-0.15, landing=0.01, heading=0.7),
    Platform((1.0, 0.2, -2.0), (2.0, 3.0), (0.5, 0.1, 0.0), 4.0, 0.3),
    Platform((1.0, 0.2, -2.0), (2.0, 3.0), (0.5, 0.0, 0.2)),
    *(one for one in obstacles_of("hills", (1.0, -2.0, 0.3))),
]

DEEP = Plane(-5.0)


@pytest.mark.parametrize("part", PARTS, ids=lambda part: type(part).__name__)
@pytest.mark.parametrize("time", [0.0, 1.3])
def test_what_looks_up_is_where_feet_find_it(part: Part, time: float) -> None:
    shape = shape_of(part)
    x, y, z, heading = frame_at(part, time)
    places = rotate(from_yaw(heading), shape.vertices) + np.array([x, y, z])
    corners = places[shape.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=-1)
    up = normals[:, 1] > 0.5 * lengths
    assert up.any()
    assert (lengths > 0.0).all()
    middles = corners[up].mean(axis=1)
    found = ground_heights(Terrain((DEEP, part)), middles, np.full(len(middles), time))
    # A square of a grid is bent, the two triangles that are drawn of it are not.
    exact = 0.02 if isinstance(part, HeightField) else 1e-9
    assert middles[:, 1] == pytest.approx(found, abs=exact)


@pytest.mark.parametrize("part", PARTS, ids=lambda part: type(part).__name__)
def test_its_surface_looks_outwards_and_its_lines_lie_on_it(part: Part) -> None:
    shape = shape_of(part)
    corners = shape.vertices[shape.faces]
    if not isinstance(part, HeightField):
        # Of a closed surface that looks outwards the volume is positive.
        a, b, c = corners.transpose(1, 0, 2)
        assert np.einsum("ij,ij->i", a, np.cross(b, c)).sum() > 0.0
    low, high = shape.vertices.min(axis=0), shape.vertices.max(axis=0)
    assert (shape.lines >= low - 1e-9).all()
    assert (shape.lines <= high + 0.005).all()
