from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.arrays import Floats
from footfall.geometry import from_yaw, rotate, transforms

numbers = st.floats(-10.0, 10.0)
frames = st.tuples(numbers, numbers, numbers)
points = st.tuples(numbers, numbers)


def matrix(frame: tuple[float, float, float]) -> Floats:
    """The slow and obvious frame: a homogeneous matrix on (x, z, 1)."""
    x, z, heading = frame
    cosine, sine = math.cos(heading), math.sin(heading)
    return np.array([[cosine, sine, x], [-sine, cosine, z], [0.0, 0.0, 1.0]])


@given(frames, points)
@settings(deadline=None)
def test_a_point_of_a_frame_is_turned_and_then_moved(
    frame: tuple[float, float, float], point: tuple[float, float]
) -> None:
    assert transforms.apply(*frame, *point) == pytest.approx(
        (matrix(frame) @ [*point, 1.0])[:2], abs=1e-12
    )


@given(frames, frames)
@settings(deadline=None)
def test_composing_is_multiplying_matrices(
    one: tuple[float, float, float], other: tuple[float, float, float]
) -> None:
    composed = transforms.compose(*one, *other)
    np.testing.assert_allclose(matrix(composed), matrix(one) @ matrix(other), atol=1e-11)
    assert composed[2] == one[2] + other[2]


@given(frames)
@settings(deadline=None)
def test_a_frame_and_its_inverse_cancel(frame: tuple[float, float, float]) -> None:
    inverse = transforms.inverse(*frame)
    assert transforms.compose(*frame, *inverse) == pytest.approx((0.0, 0.0, 0.0), abs=1e-12)
    assert transforms.compose(*inverse, *frame) == pytest.approx((0.0, 0.0, 0.0), abs=1e-12)


@given(frames, frames)
@settings(deadline=None)
def test_what_one_frame_sees_of_another_leads_from_one_to_the_other(
    one: tuple[float, float, float], other: tuple[float, float, float]
) -> None:
    seen = transforms.relative(*one, *other)
    assert seen == pytest.approx(transforms.compose(*transforms.inverse(*one), *other), abs=1e-11)
    assert transforms.compose(*one, *seen) == pytest.approx(other, abs=1e-11)


@given(numbers, points)
@settings(deadline=None)
def test_a_heading_turns_as_the_yaw_of_a_rotation(
    heading: float, point: tuple[float, float]
) -> None:
    turned = rotate(from_yaw(heading), np.array([point[0], 0.0, point[1]]))
    assert transforms.apply(0.0, 0.0, heading, *point) == pytest.approx(
        (turned[0], turned[2]), abs=1e-12
    )


def test_heading_a_quarter_turn_faces_x() -> None:
    assert transforms.apply(5.0, 7.0, math.pi / 2, 0.0, 1.0) == pytest.approx((6.0, 7.0))


def test_the_same_source_takes_arrays() -> None:
    apply: Any = getattr(transforms.apply, "py_func", transforms.apply)
    frames_and_points = np.random.default_rng(1).normal(size=(5, 50))
    one_by_one = [transforms.apply(*numbers) for numbers in frames_and_points.T.tolist()]
    np.testing.assert_allclose(apply(*frames_and_points), np.array(one_by_one).T, rtol=1e-15)


@settings(deadline=None)
@given(st.one_of(st.floats(-10.0, 10.0), st.floats(-0.126, 0.126)))
def test_cosine_and_sine_are_exact_to_the_last_bits(angle: float) -> None:
    found = transforms.cosine_and_sine(angle)
    np.testing.assert_allclose(found, (math.cos(angle), math.sin(angle)), rtol=3e-16, atol=3e-16)
