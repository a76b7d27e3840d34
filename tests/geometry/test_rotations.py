from __future__ import annotations

import math
from itertools import permutations
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation, Slerp  # pyright: ignore[reportMissingTypeStubs]

from footfall.arrays import Floats, Rotations
from footfall.geometry import (
    blend_rotations,
    conjugate,
    continuous,
    from_axis_angle,
    from_euler,
    from_yaw,
    multiply,
    rotate,
    slerp,
    to_euler,
)

ORDERS = pytest.mark.parametrize("order", ["".join(axes) for axes in permutations("XYZ")])
IDENTITY = np.array([1.0, 0.0, 0.0, 0.0])
angles = st.floats(-math.pi, math.pi)
seeds = st.integers(0, 2**32 - 1)


def random_rotations(*shape: int, seed: int = 0) -> Rotations:
    values = np.random.default_rng(seed).normal(size=(*shape, 4))
    return values / np.linalg.norm(values, axis=-1, keepdims=True)


def oracle(rotations: Rotations) -> Any:
    return Rotation.from_quat(np.roll(rotations, -1, axis=-1))


def angle_between(one: Rotations, other: Rotations) -> Floats:
    """Return how far the rotations are apart [rad], without loss of precision near zero."""
    difference = multiply(conjugate(one), other)
    sine = np.linalg.norm(difference[..., 1:], axis=-1)
    return 2.0 * np.arctan2(sine, np.abs(difference[..., 0]))


def assert_same(one: Rotations, other: Rotations, within: float = 1e-12) -> None:
    assert angle_between(one, other).max() <= within


def test_products_are_those_of_the_oracle() -> None:
    one, other = random_rotations(50, seed=1), random_rotations(50, seed=2)
    expected: Any = (oracle(one) * oracle(other)).as_quat()
    assert_same(multiply(one, other), np.roll(expected, 1, axis=-1))


def test_rotated_vectors_are_those_of_the_oracle() -> None:
    rotations = random_rotations(50)
    vectors = np.random.default_rng(3).normal(size=(50, 3))
    expected: Any = oracle(rotations).apply(vectors)
    np.testing.assert_allclose(rotate(rotations, vectors), expected, rtol=0, atol=1e-14)


def test_products_and_rotated_vectors_broadcast() -> None:
    many, one = random_rotations(5, 1, 3), random_rotations(3)
    assert multiply(many, one).shape == (5, 1, 3, 4)
    assert multiply(one, many[0, 0, 0]).shape == (3, 4)
    assert rotate(many, np.ones((7, 1, 3))).shape == (5, 7, 3, 3)
    np.testing.assert_array_equal(multiply(many, one)[2, 0, 1], multiply(many[2, 0, 1], one[1]))


def test_the_conjugate_is_the_inverse() -> None:
    rotations = random_rotations(20)
    product = multiply(rotations, conjugate(rotations))
    np.testing.assert_allclose(product, np.broadcast_to(IDENTITY, (20, 4)), rtol=0, atol=1e-15)


def test_grouping_never_matters() -> None:
    a, b, c = (random_rotations(20, seed=seed) for seed in range(3))
    left, right = multiply(multiply(a, b), c), multiply(a, multiply(b, c))
    np.testing.assert_allclose(left, right, rtol=0, atol=1e-15)


@pytest.mark.parametrize("angle", [0.0, 1e-300, 1e-9, 1.0, math.pi, 2.0 * math.pi, -3.0])
def test_an_angle_about_an_axis_is_the_oracles_rotation_vector(angle: float) -> None:
    axis = np.array([2.0, -1.0, 2.0]) / 3.0
    expected: Any = Rotation.from_rotvec(axis * angle).as_quat()
    assert_same(from_axis_angle(axis, angle), np.roll(expected, 1))


def test_axes_and_angles_broadcast() -> None:
    axes = np.eye(3)
    assert from_axis_angle(axes, 0.5).shape == (3, 4)
    assert from_axis_angle(axes[0], np.linspace(0.0, 1.0, 6)).shape == (6, 4)
    assert from_axis_angle(axes, np.zeros((6, 3))).shape == (6, 3, 4)


def test_a_positive_yaw_turns_forward_to_the_left() -> None:
    forward, left = np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0])
    np.testing.assert_allclose(rotate(from_yaw(math.pi / 2), forward), left, rtol=0, atol=1e-15)


@ORDERS
@settings(deadline=None)
@given(angles, angles, angles)
def test_euler_angles_mean_what_the_oracles_intrinsic_ones_do(
    order: str, a: float, b: float, c: float
) -> None:
    expected: Any = Rotation.from_euler(order, [a, b, c]).as_quat()
    assert_same(from_euler(order, np.array([a, b, c])), np.roll(expected, 1))


@pytest.mark.parametrize("order", ["X", "ZY", "ZXZ", "zxy", ""])
def test_any_number_of_channels_in_any_letters_can_be_read(order: str) -> None:
    values = np.linspace(0.3, 1.1, len(order))
    expected: Rotations = IDENTITY
    for axis, value in zip(order.upper(), values, strict=True):
        expected = multiply(expected, from_axis_angle(np.eye(3)["XYZ".index(axis)], float(value)))
    assert_same(from_euler(order, values), expected)


@ORDERS
@settings(deadline=None, max_examples=60)
@given(seeds)
def test_euler_angles_come_back_as_the_same_rotation(order: str, seed: int) -> None:
    rotations = random_rotations(20, seed=seed)
    result = to_euler(order, rotations)
    assert np.abs(result[..., 1]).max() <= math.pi / 2
    assert_same(from_euler(order, result), rotations, within=1e-11)


@ORDERS
@settings(deadline=None)
@given(angles, st.floats(-1.5, 1.5), angles)
def test_euler_angles_within_their_ranges_come_back_as_themselves(
    order: str, a: float, b: float, c: float
) -> None:
    values = np.array([a, b, c])
    difference = to_euler(order, from_euler(order, values)) - values
    turns = np.round(difference / (2.0 * math.pi)) * 2.0 * math.pi
    assert np.abs(difference - turns).max() < 1e-11


@ORDERS
@pytest.mark.parametrize("side", [-1.0, 1.0])
@settings(deadline=None, max_examples=60)
@given(angles, st.one_of(st.just(0.0), st.floats(-16.0, -1.0).map(lambda e: 10.0**e)), angles)
@example(0.4, 1e-6, -2.0)
@example(0.4, 1e-8, -2.0)
def test_at_and_near_the_gimbal_lock_the_rotation_still_comes_back(
    order: str, side: float, a: float, away: float, c: float
) -> None:
    rotation = from_euler(order, np.array([a, side * (math.pi / 2 - away), c]))
    assert_same(from_euler(order, to_euler(order, rotation)), rotation, within=1e-7)


@ORDERS
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_in_the_gimbal_lock_the_last_angle_is_zero(order: str, side: float) -> None:
    rotation = from_euler(order, np.array([0.3, side * math.pi / 2, 0.2]))
    first, middle, last = to_euler(order, rotation)
    assert (middle, last) == (pytest.approx(side * math.pi / 2, abs=1e-8), 0.0)
    expected = {0.3 + 0.2, 0.3 - 0.2}
    assert any(first == pytest.approx(value, abs=1e-7) for value in expected)


def test_no_sign_flips_along_a_continuous_series() -> None:
    smooth = from_axis_angle(np.array([0.6, 0.0, 0.8]), np.linspace(0.0, 20.0, 200))
    flipped = smooth * np.random.default_rng(4).choice([-1.0, 1.0], size=(200, 1))
    flipped[0] = smooth[0]
    np.testing.assert_array_equal(continuous(flipped), smooth)


def test_each_joint_of_a_continuous_series_keeps_its_own_signs() -> None:
    series = random_rotations(30, 4)
    result = continuous(series)
    assert np.einsum("tji,tji->tj", result[1:], result[:-1]).min() >= 0.0
    np.testing.assert_array_equal(np.abs(result), np.abs(series))
    np.testing.assert_array_equal(result[0], series[0])


@settings(deadline=None)
@given(seeds, st.floats(0.0, 1.0))
def test_slerp_is_the_oracles(seed: int, fraction: float) -> None:
    one, other = random_rotations(2, seed=seed)
    expected: Any = Slerp([0.0, 1.0], oracle(np.stack([one, other])))(fraction).as_quat()
    assert_same(slerp(one, other, fraction), np.roll(expected, 1), within=1e-7)


@pytest.mark.parametrize("angle", [0.0, 1e-9, 1e-7, 1e-5, 3e-3, 1.0, math.pi - 1e-6, math.pi])
@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_slerp_turns_at_even_speed_between_any_two(angle: float, sign: float) -> None:
    axis = np.array([0.0, 0.6, 0.8])
    fractions = np.linspace(0.0, 1.0, 5)
    result = slerp(IDENTITY, sign * from_axis_angle(axis, angle), fractions)
    turned = angle_between(IDENTITY, result)
    np.testing.assert_allclose(turned, fractions * angle, rtol=1e-9, atol=1e-15)


def test_a_blend_of_two_equal_shares_is_halfway() -> None:
    one, other = random_rotations(2, 30, seed=5)
    blended = blend_rotations(np.stack([one, other]), np.full((2, 30), 0.5))
    assert_same(blended, slerp(one, other, 0.5), within=1e-7)


@settings(deadline=None)
@given(seeds)
def test_neither_order_nor_sign_matters_to_a_blend(seed: int) -> None:
    random = np.random.default_rng(seed)
    rotations = random_rotations(4, seed=seed)
    weights = random.dirichlet(np.ones(4))
    order = random.permutation(4)
    signs = random.choice([-1.0, 1.0], size=(4, 1))
    once = blend_rotations(rotations, weights)
    again = blend_rotations((signs * rotations)[order], weights[order])
    assert_same(once, again)


def test_a_lone_rotation_blends_to_itself() -> None:
    rotations = random_rotations(3, 2)
    weights = np.array([[0.0, 0.0], [1.0, 1.0], [0.0, 0.0]])
    np.testing.assert_allclose(
        blend_rotations(rotations, weights), rotations[1], rtol=0, atol=1e-15
    )


def test_opposed_quaternions_of_one_rotation_blend_to_it() -> None:
    rotation = random_rotations()
    blended = blend_rotations(np.stack([rotation, -rotation]), np.array([0.5, 0.5]))
    assert_same(blended, rotation)


def test_half_turns_about_different_axes_still_blend_to_a_rotation() -> None:
    half_turns = np.eye(4)[1:]
    blended = blend_rotations(half_turns, np.full(3, 1.0 / 3.0))
    assert np.linalg.norm(blended) == pytest.approx(1.0)
