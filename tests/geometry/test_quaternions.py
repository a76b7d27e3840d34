from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.arrays import Floats, Positions
from footfall.geometry import from_axis_angle, multiply, quaternions
from footfall.geometry import rotate as rotate_array

seeds = st.integers(0, 2**32 - 1)
directions = st.tuples(*[st.floats(-10.0, 10.0)] * 3).filter(lambda v: math.hypot(*v) > 1e-3)
AXES = [*np.eye(3), *-np.eye(3)]


def unit(seed: int) -> Floats:
    values = np.random.default_rng(seed).normal(size=4)
    return values / np.linalg.norm(values)


def numbers(*parts: tuple[float, ...] | Floats) -> list[float]:
    return [float(x) for part in parts for x in part]


def turned(q: tuple[float, ...] | Floats, vector: Positions | tuple[float, ...]) -> Positions:
    return np.array(quaternions.rotate(*numbers(q, vector)))


def between(a: Positions | tuple[float, ...], b: Positions | tuple[float, ...]) -> Floats:
    q = quaternions.between(*numbers(a, b))
    assert math.hypot(*q) == pytest.approx(1.0, abs=1e-14)
    return np.array(q)


def direction(vector: Positions | tuple[float, ...]) -> Positions:
    return np.array(vector) / np.linalg.norm(vector)


@settings(deadline=None)
@given(seeds, seeds)
def test_a_product_is_the_composition_and_a_quotient_undoes_it(one: int, other: int) -> None:
    a, b = unit(one), unit(other)
    product = quaternions.product(*numbers(a, b))
    np.testing.assert_allclose(product, multiply(a, b), rtol=0, atol=1e-15)
    np.testing.assert_allclose(quaternions.quotient(*numbers(a, product)), b, rtol=0, atol=1e-15)


@settings(deadline=None)
@given(seeds, directions)
def test_rotating_there_and_back_changes_nothing(
    seed: int, vector: tuple[float, float, float]
) -> None:
    q = unit(seed)
    there = quaternions.rotate(*numbers(q, vector))
    np.testing.assert_allclose(there, rotate_array(q, np.array(vector)), rtol=0, atol=1e-13)
    assert quaternions.conjugate_rotate(*numbers(q, there)) == pytest.approx(vector, abs=1e-13)


def test_a_quaternion_of_no_length_becomes_the_identity() -> None:
    assert quaternions.normalize(0.0, 0.0, 0.0, 0.0) == (1.0, 0.0, 0.0, 0.0)
    assert quaternions.normalize(0.0, 3.0, 0.0, 4.0) == pytest.approx((0.0, 0.6, 0.0, 0.8))


@settings(deadline=None)
@given(seeds, seeds)
def test_a_mix_begins_and_ends_where_it_should_the_short_way_round(one: int, other: int) -> None:
    a, b = unit(one), unit(other)
    short = b if a @ b >= 0.0 else -b
    for fraction, expected in ((0.0, a), (1.0, short), (0.5, (a + short) / 2.0)):
        mixed = quaternions.nlerp(*numbers(a, b, (fraction,)))
        np.testing.assert_allclose(mixed, direction(expected), rtol=0, atol=1e-14)


@settings(deadline=None)
@given(directions, directions)
def test_the_shortest_rotation_turns_one_direction_into_the_other(
    a: tuple[float, float, float], b: tuple[float, float, float]
) -> None:
    np.testing.assert_allclose(turned(between(a, b), direction(a)), direction(b), rtol=0, atol=1e-6)


@settings(deadline=None)
@given(directions, directions)
def test_the_shortest_rotation_turns_no_further_than_needed(
    a: tuple[float, float, float], b: tuple[float, float, float]
) -> None:
    q = between(a, b)
    needed = math.acos(float(np.clip(direction(a) @ direction(b), -1.0, 1.0)))
    assert 2.0 * math.acos(min(float(q[0]), 1.0)) == pytest.approx(needed, abs=1e-6)


@pytest.mark.parametrize("a", AXES)
@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e3])
def test_between_parallel_directions_nothing_turns(a: Positions, scale: float) -> None:
    np.testing.assert_allclose(between(a, scale * a), [1.0, 0.0, 0.0, 0.0], rtol=0, atol=1e-15)


@pytest.mark.parametrize("a", [*AXES, np.array([1.0, 1.0, 1.0]), np.array([1.0, -1.0, 0.0])])
@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e3])
def test_between_opposed_directions_there_is_half_a_turn(a: Positions, scale: float) -> None:
    q = between(a, -scale * a)
    assert abs(q[0]) < 1e-7
    np.testing.assert_allclose(turned(q, a), -a, rtol=0, atol=1e-7)


@pytest.mark.parametrize("exponent", range(-16, 0))
@pytest.mark.parametrize("a", AXES)
def test_between_nearly_opposed_directions_the_turn_is_still_exact(
    a: Positions, exponent: int
) -> None:
    aside = np.roll(a, 1) * 10.0**exponent
    b = direction(aside - a)
    np.testing.assert_allclose(turned(between(a, b), a), b, rtol=0, atol=3e-7)


def test_where_a_direction_is_missing_nothing_turns() -> None:
    zero, a = np.zeros(3), np.array([1.0, 2.0, 3.0])
    for pair in ((zero, a), (a, zero), (zero, zero)):
        assert between(*pair).tolist() == [1.0, 0.0, 0.0, 0.0]


@settings(deadline=None)
@given(st.floats(-3.0, 3.0))
def test_a_yaw_is_read_back_from_w_and_y(yaw: float) -> None:
    w, x, y, z = quaternions.from_yaw(yaw)
    assert (x, z) == (0.0, 0.0)
    assert quaternions.yaw_of(w, y) == pytest.approx(yaw, abs=1e-14)


def test_the_twist_about_the_vertical_is_unmoved_by_a_swing_after_it() -> None:
    swing = from_axis_angle(np.array([0.6, 0.0, 0.8]), 0.7)
    twist = np.array(quaternions.from_yaw(1.1))
    w, _, y, _ = multiply(swing, twist)
    assert quaternions.yaw_of(float(w), float(y)) == pytest.approx(1.1)
