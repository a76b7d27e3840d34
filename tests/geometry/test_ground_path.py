from __future__ import annotations

import math

import numpy as np
import pytest

from footfall.errors import ArgumentError
from footfall.geometry.ground_path import GroundPath, wrapped

CORNER = GroundPath.through([(0.0, 0.0), (0.0, 2.0), (3.0, 2.0)])


def test_places_are_found_by_how_far_along_they_are_straight_on_beyond_both_ends() -> None:
    assert CORNER.length == 5.0
    found = [CORNER.at(distance) for distance in (-1.0, 0.0, 1.5, 2.0, 2.5, 5.0, 6.0)]
    expected = [(0, -1), (0, 0), (0, 1.5), (0, 2), (0.5, 2), (3, 2), (4, 2)]
    assert np.array(found) == pytest.approx(np.array(expected))


def test_a_direction_is_that_of_a_chord() -> None:
    assert CORNER.direction(1.0, 0.4) == pytest.approx(0.0)
    assert CORNER.direction(4.0, 0.4) == pytest.approx(0.5 * math.pi)
    assert CORNER.direction(2.0, 0.4) == pytest.approx(0.25 * math.pi)
    assert CORNER.direction(5.5, 0.4) == pytest.approx(0.5 * math.pi)


def test_the_nearest_place_is_told_with_the_side_on_which_one_stands() -> None:
    # Facing +z, +x is to the left.
    assert CORNER.nearest(0.3, 1.0, 0.0, 5.0) == pytest.approx((1.0, 0.3))
    assert CORNER.nearest(-0.3, 1.0, 0.0, 5.0) == pytest.approx((1.0, -0.3))
    assert CORNER.nearest(1.0, 2.5, 0.0, 5.0) == pytest.approx((3.0, -0.5))
    assert CORNER.nearest(1.0, 2.5, 0.0, 1.0) == pytest.approx((1.0, math.hypot(1.0, 1.5)))
    assert CORNER.nearest(9.0, 2.0, 0.0, 5.0)[0] == 5.0


def test_of_equally_near_places_the_first_counts() -> None:
    there_and_back = GroundPath.through([(0.0, 0.0), (0.0, 4.0), (0.0, 0.0)])
    assert there_and_back.nearest(0.2, 1.0, 0.0, 8.0)[0] == pytest.approx(1.0)


def test_points_that_are_the_same_are_passed_over() -> None:
    path = GroundPath.through([(0, 0), (0, 0), (0, 1), (0, 1), (1, 1), (1, 1)])
    found = [path.at(distance) for distance in (-0.5, 0.0, 0.5, 1.0, 1.5, 2.0, 2.5)]
    expected = [(0, -0.5), (0, 0), (0, 0.5), (0, 1), (0.5, 1), (1, 1), (1.5, 1)]
    assert np.array(found) == pytest.approx(np.array(expected))


@pytest.mark.parametrize(
    ("points", "message"),
    [
        ([], "a path of shape (0,); two points or more are needed, x and z of each"),
        ([(0, 0)], "a path of shape (1, 2); two points or more are needed, x and z of each"),
        (
            [(0, 0, 0), (1, 0, 0)],
            "a path of shape (2, 3); two points or more are needed, x and z of each",
        ),
        ([(0, 0), (math.nan, 1)], "point 1 of the path is not finite; give x and z [m]"),
        ([(2, 1), (2, 1)], "a path of 0 m; it must lead somewhere"),
        ("to the door", "a path must be an array of numbers, x and z a point"),
        ([(0, 0), (1,)], "a path must be an array of numbers, x and z a point"),
    ],
)
def test_what_is_no_path_is_refused(points: object, message: str) -> None:
    with pytest.raises(ArgumentError) as caught:
        GroundPath.through(points)  # pyright: ignore[reportArgumentType]
    assert str(caught.value) == message


def test_angles_are_brought_between_minus_and_plus_pi() -> None:
    assert wrapped(1.5 * math.pi) == pytest.approx(-0.5 * math.pi)
    assert wrapped(-7.0) == pytest.approx(-7.0 + 2.0 * math.pi)
