"""Footprints lie where feet came down, as the ground lies, and go with the plates they are on."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from footfall.adaptation import AnyGround, Plane, Platform, Terrain, ground_heights
from footfall.arrays import Floats, Positions
from footfall.geometry import rotate
from footfall.studio.footprints import ABOVE, Footprints


class Scene:
    """Takes what is drawn."""

    def __init__(self) -> None:
        self.nodes: list[Any] = []

    def add_batched_meshes_simple(self, name: str, *shape: object, **looks: object) -> object:
        del shape, looks
        self.nodes.append(SimpleNamespace(name=name, visible=True))
        return self.nodes[-1]


def feet(left: Positions) -> Positions:
    """Return heel and toe of both feet, the left heel at a place."""
    toe = left + np.array([0.0, 0.0, 0.2])
    return np.array([[left, toe], [left + 9.0, toe + 9.0]])


def printed(ground: AnyGround, place: tuple[float, float, float], time: float = 0.0) -> Any:
    scene = Scene()
    prints = Footprints(scene, "prints")  # pyright: ignore[reportArgumentType]

    def heights(points: Positions) -> Floats:
        return ground_heights(ground, points, np.full(points.shape[:-1], time))

    prints.ride(ground, time)
    points = feet(np.array(place))
    points[..., 1] = heights(points)
    prints.update(points, (True, False), heights, ground)
    return prints, scene.nodes[0]


def test_a_print_lies_a_little_over_where_the_heel_came_down() -> None:
    _, node = printed(Plane(0.3), (1.0, 0.0, 2.0))
    assert node.batched_positions[0] == pytest.approx([1.0, 0.3 + ABOVE, 2.0])
    assert node.batched_scales[0] == pytest.approx(0.2)
    assert not node.batched_scales[1:].any()


def test_a_print_is_tilted_as_the_ground_is() -> None:
    _, node = printed(Plane(slope=(0.1, -0.2)), (1.0, 0.0, 2.0))
    normal = rotate(node.batched_wxyzs[0].astype(np.float64), np.array([0.0, 1.0, 0.0]))
    wanted = np.array([-0.1, 1.0, 0.2])
    assert normal == pytest.approx(wanted / np.linalg.norm(wanted), abs=1e-5)


def test_a_print_goes_and_turns_with_its_plate() -> None:
    plate = Platform((0.0, 0.1, 0.0), (4.0, 4.0), (0.5, 0.0, 0.0), turning=np.pi / 2.0)
    ground = Terrain((Plane(), plate))
    prints, node = printed(ground, (1.0, 0.0, 0.0))
    prints.ride(ground, 1.0)
    # A quarter turn from +z towards +x takes +x to -z; the plate has gone half a meter.
    assert node.batched_positions[0] == pytest.approx([0.5, 0.1 + ABOVE, -1.0], abs=1e-5)


def test_a_print_beside_the_plate_stays() -> None:
    plate = Platform((0.0, 0.1, 0.0), (4.0, 4.0), (0.5, 0.0, 0.0))
    ground = Terrain((Plane(), plate))
    prints, node = printed(ground, (3.0, 0.0, 0.0))
    prints.ride(ground, 1.0)
    assert node.batched_positions[0] == pytest.approx([3.0, ABOVE, 0.0])


def test_cleaning_forgets_all() -> None:
    prints, node = printed(Plane(), (1.0, 0.0, 2.0))
    prints.clear()
    assert not node.batched_scales.any()
