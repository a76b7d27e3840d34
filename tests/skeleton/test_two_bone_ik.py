"""The analytic limb, and each of its degenerate cases by name."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.geometry import quaternions
from footfall.skeleton.two_bone_ik import LONGEST_REACH, reach_point, softened_reach

Vector = tuple[float, float, float]

HIP = (0.1, 1.0, -0.2)
AHEAD = (0.0, 0.0, 1.0)
BENT = (0.1, 0.6, 0.0), (0.1, 0.2, -0.15)
"""Knee and ankle of a leg that is a little bent."""

STRAIGHT = (0.1, 0.6, -0.2), (0.1, 0.2, -0.2)
FOLDED = (0.1, 0.6, -0.2), (0.1, 0.999, -0.2)

places = st.tuples(*[st.floats(-2.0, 2.0)] * 3)


def length(one: Vector, other: Vector) -> float:
    return math.dist(one, other)


def reached(
    knee: Vector, ankle: Vector, target: Vector, hint: Vector = AHEAD
) -> tuple[Vector, Vector]:
    """Return the new middle and end, after checking what holds for every limb."""
    upper, lower, middle, end = reach_point(HIP, knee, ankle, target, hint)
    numbers = np.array([*upper, *lower, *middle, *end])
    assert np.isfinite(numbers).all()
    assert np.linalg.norm(upper) == pytest.approx(1.0)
    assert np.linalg.norm(lower) == pytest.approx(1.0)
    assert length(HIP, middle) == pytest.approx(length(HIP, knee), abs=1e-6)
    assert length(middle, end) == pytest.approx(length(knee, ankle), abs=1e-5)
    bone = np.subtract(knee, HIP).tolist()
    turned = np.add(HIP, quaternions.rotate(*upper, *bone))
    np.testing.assert_allclose(turned, middle, atol=1e-6)
    bone = np.subtract(ankle, knee).tolist()
    np.testing.assert_allclose(np.add(middle, quaternions.rotate(*lower, *bone)), end, atol=1e-5)
    return middle, end


@settings(deadline=None)
@given(places, places, places, places)
def test_no_limb_and_no_target_give_a_number_that_is_none(
    knee: Vector, ankle: Vector, target: Vector, hint: Vector
) -> None:
    upper, lower, middle, end = reach_point(HIP, knee, ankle, target, hint)
    assert np.isfinite([*upper, *lower, *middle, *end]).all()
    assert length(HIP, middle) == pytest.approx(length(HIP, knee), abs=1e-6)


def test_a_target_in_reach_is_reached() -> None:
    target = (0.2, 0.35, 0.1)
    _, end = reached(*BENT, target)
    np.testing.assert_allclose(end, target, atol=1e-12)


def test_a_limb_that_is_where_it_should_be_stays_as_it_is() -> None:
    middle, end = reached(*BENT, BENT[1])
    np.testing.assert_allclose(middle, BENT[0], atol=1e-12)
    np.testing.assert_allclose(end, BENT[1], atol=1e-12)


def test_zero_length_of_either_bone_leaves_the_limb_as_it_is() -> None:
    for knee, ankle in ((HIP, BENT[1]), (BENT[0], BENT[0]), (HIP, HIP)):
        upper, lower, middle, end = reach_point(HIP, knee, ankle, (0.3, 0.3, 0.3), AHEAD)
        assert upper == lower == (1.0, 0.0, 0.0, 0.0)
        assert (middle, end) == (knee, ankle)


def test_a_straight_limb_bends_towards_its_hint() -> None:
    middle, end = reached(*STRAIGHT, (0.1, 0.4, -0.2))
    np.testing.assert_allclose(end, (0.1, 0.4, -0.2), atol=1e-9)
    assert middle[2] > -0.1
    assert middle[0] == pytest.approx(0.1, abs=1e-9)


def test_a_straight_limb_with_its_hint_along_it_bends_somewhere() -> None:
    _, end = reached(*STRAIGHT, (0.1, 0.4, -0.2), (0.0, -1.0, 0.0))
    np.testing.assert_allclose(end, (0.1, 0.4, -0.2), atol=1e-9)


def test_a_folded_limb_unfolds() -> None:
    _, end = reached(*FOLDED, (0.1, 0.4, -0.2))
    np.testing.assert_allclose(end, (0.1, 0.4, -0.2), atol=1e-6)


def test_a_target_at_the_hip_folds_the_limb_no_further_than_its_bones_allow() -> None:
    _, end = reached(*BENT, (0.1, 1.0, -0.2 + 1e-5))
    shortest = abs(length(HIP, BENT[0]) - length(*BENT))
    assert length(HIP, end) == pytest.approx(shortest, abs=1e-5)
    upper, lower, _, _ = reach_point(HIP, *BENT, HIP, AHEAD)
    assert upper == lower == (1.0, 0.0, 0.0, 0.0)


def test_a_target_behind_is_reached_too() -> None:
    target = (0.1, 1.6, -0.15)
    _, end = reached(*BENT, target)
    np.testing.assert_allclose(end, target, atol=1e-9)
    target = (0.1, 1.5, -0.2)
    _, end = reached(*STRAIGHT, target)
    np.testing.assert_allclose(end, target, atol=1e-9)


def test_a_target_out_of_reach_is_approached_and_never_reached() -> None:
    whole = length(HIP, BENT[0]) + length(*BENT)
    distances = np.linspace(0.9, 3.0, 400) * whole
    reaches = np.array([softened_reach(distance, whole, 0.5) for distance in distances.tolist()])
    steps = np.diff(reaches)
    assert (steps >= 0.0).all()
    assert (np.diff(steps) <= 1e-9).all()
    assert reaches[-1] == pytest.approx(LONGEST_REACH * whole)
