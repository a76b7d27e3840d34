from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from footfall.adaptation import (
    AnyGround,
    HeightField,
    Plane,
    Platform,
    Ramp,
    Stairs,
    Terrain,
    ground_heights,
)
from footfall.errors import ArgumentError, FileFormatError


def height(ground: AnyGround, x: float, z: float, time: float = 0.0) -> float:
    return float(ground_heights(ground, np.array([x, 9.0, z]), np.array(time)))


def test_a_plane_lies_and_rises_as_it_is_put() -> None:
    assert height(Plane(), 3.0, -2.0) == 0.0
    assert height(Plane(0.4), 3.0, -2.0) == 0.4
    assert height(Plane(0.4, (0.1, -0.2)), 3.0, 2.0) == pytest.approx(0.4 + 0.3 - 0.4)


def test_a_ramp_rises_along_its_way_and_ends() -> None:
    ramp = Ramp((1.0, 0.5, 2.0), 4.0, 1.0, width=2.0, heading=0.5 * math.pi)
    assert height(ramp, 1.0 + 1e-9, 2.0) == pytest.approx(0.5)
    assert height(ramp, 3.0, 2.9) == pytest.approx(1.0)
    assert height(ramp, 5.0 - 1e-9, 2.0) == pytest.approx(1.5)
    assert height(ramp, 5.1, 2.0) == 0.0
    assert height(ramp, 3.0, 3.1) == 0.0


def test_stairs_rise_step_by_step_to_a_landing() -> None:
    stairs = Stairs((0.0, 0.2, 1.0), 3, rise=0.18, tread=0.3, landing=2.0)
    places = [1.01, 1.29, 1.31, 1.61, 2.0, 3.8, 3.95]
    expected = [0.38, 0.38, 0.56, 0.74, 0.74, 0.74, 0.0]
    assert [height(stairs, 0.0, z) for z in places] == pytest.approx(expected)


def test_a_platform_swings_or_goes_on_and_turns() -> None:
    swings = Platform((0.0, 0.3, 0.0), (1.0, 1.0), way=(2.0, 0.1, 0.0), period=4.0)
    assert height(swings, 2.0, 0.0, 1.0) == pytest.approx(0.4)
    assert height(swings, 0.0, 0.0, 1.0) == 0.0
    goes = Platform((0.0, 0.3, 0.0), (1.0, 1.0), way=(0.5, 0.0, 0.0))
    assert height(goes, 5.0, 0.0, 10.0) == pytest.approx(0.3)
    turns = Platform((0.0, 0.3, 0.0), (4.0, 0.2), turning=0.5 * math.pi)
    assert height(turns, 0.0, 1.9, 0.0) == 0.0
    assert height(turns, 0.0, 1.9, 1.0) == pytest.approx(0.3)


def test_a_platform_tilts_to_each_side() -> None:
    tilts = Platform((1.0, 0.3, 0.0), (9.0, 9.0), period=4.0, tilt=(0.2, -0.1))
    assert height(tilts, 2.0, 3.0, 0.0) == pytest.approx(0.3)
    assert height(tilts, 2.0, 3.0, 1.0) == pytest.approx(0.3 + 0.2 - 0.3)
    assert height(tilts, 2.0, 3.0, 3.0) == pytest.approx(0.3 - 0.2 + 0.3)


def test_a_field_is_linear_between_its_heights_and_level_beyond_them() -> None:
    field = HeightField(np.array([[0.0, 1.0], [2.0, 3.0]]), 2.0, (1.0, 1.0))
    assert height(field, 0.0, 0.0) == pytest.approx(0.0)
    assert height(field, 2.0, 0.0) == pytest.approx(1.0)
    assert height(field, 1.0, 1.0) == pytest.approx(1.5)
    assert height(field, 9.0, 9.0) == pytest.approx(3.0)


def test_of_several_surfaces_the_highest_counts() -> None:
    terrain = Terrain((Plane(0.1), Platform((0.0, 0.3, 0.0), (1.0, 1.0)), Plane(-1.0)))
    assert height(terrain, 0.0, 0.0) == pytest.approx(0.3)
    assert height(terrain, 2.0, 0.0) == pytest.approx(0.1)


def test_a_field_is_read_from_a_file_and_from_an_image(tmp_path: Path) -> None:
    heights = np.arange(12.0).reshape(3, 4)
    np.savez(tmp_path / "hill.npz", heights=heights, spacing=0.25, middle=[1.0, 2.0])
    field = HeightField.load(tmp_path / "hill.npz")
    assert (field.heights == heights).all()
    assert (field.spacing, field.middle) == (0.25, (1.0, 2.0))
    image = pytest.importorskip("PIL.Image")
    picture = np.zeros((4, 4), dtype=np.uint8)
    picture[0, 0] = 255
    image.fromarray(picture).save(tmp_path / "hill.png")
    seen = HeightField.from_image(tmp_path / "hill.png", 0.0, 2.0)
    # The top of the image is towards +z, its left towards +x.
    assert seen.heights[-1, -1] == 2.0
    assert seen.heights.sum() == 2.0


BAD: list[tuple[Any, str]] = [
    (lambda: Plane(math.nan), "ground at height nan; it must be a finite number [m]"),
    (
        lambda: Plane(0.0, (2.0, 0.0)),
        "ground with slopes (2.0, 0.0); nobody stands where it is steeper than 60°",
    ),
    (
        lambda: Ramp((0, 0, 0), 0.0, 1.0),
        "a ramp with a length of 0.0 m; it must be > 0",
    ),
    (lambda: Stairs((0, 0, 0), 0), "stairs of 0 steps; there must be at least 1"),
    (
        lambda: Stairs((0, 0, 0), 2, tread=-0.1),
        "stairs with a tread of -0.1 m; it must be > 0",
    ),
    (
        lambda: Platform((0, 0, 0), (1.0, 1.0), period=-1.0),
        "a platform with a period of -1.0 s; it must be >= 0",
    ),
    (
        lambda: HeightField(np.zeros((1, 5))),
        "heights of shape (1, 5); a grid of 2 × 2 is the least",
    ),
    (
        lambda: HeightField(np.array([[0.0, math.inf], [0.0, 0.0]])),
        "the height at row 0, column 1 is not finite",
    ),
    (lambda: Terrain(()), "a terrain without parts; give at least one surface"),
]


@pytest.mark.parametrize(("make", "message"), BAD)
def test_what_is_no_ground_is_refused(make: Any, message: str) -> None:
    with pytest.raises(ArgumentError) as caught:
        make()
    assert str(caught.value) == message


def test_a_file_that_holds_no_field_is_refused(tmp_path: Path) -> None:
    missing = tmp_path / "none.npz"
    with pytest.raises(FileFormatError) as caught:
        HeightField.load(missing)
    assert str(caught.value) == f"{missing}: there is no such file; check the name"
    np.savez(tmp_path / "other.npz", other=np.zeros(3))
    (tmp_path / "text.npz").write_text("hello")
    for name in ("other.npz", "text.npz"):
        with pytest.raises(FileFormatError, match="holds no height field"):
            HeightField.load(tmp_path / name)
