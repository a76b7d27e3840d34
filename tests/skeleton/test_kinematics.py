from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.oracles.slow_kinematics import joint_frames, rotation_matrix

from footfall.arrays import Rotations
from footfall.geometry import from_yaw, multiply, rotate
from footfall.skeleton import Skeleton, pose_forward, world_poses


def random_body(random: np.random.Generator, joints: int) -> Skeleton:
    parents = np.array([-1, *(int(random.integers(0, joint)) for joint in range(1, joints))])
    offsets = random.normal(size=(joints, 3))
    offsets[0] = 0.0
    return Skeleton(tuple(f"joint {i}" for i in range(joints)), parents, offsets)


def random_rotations(random: np.random.Generator, *shape: int) -> Rotations:
    values = random.normal(size=(*shape, 4))
    return values / np.linalg.norm(values, axis=-1, keepdims=True)


@settings(deadline=None, max_examples=60)
@given(st.integers(0, 2**32 - 1), st.integers(1, 12), st.integers(1, 3))
def test_any_tree_in_any_pose_is_placed_as_by_recursion(
    seed: int, joints: int, frames: int
) -> None:
    random = np.random.default_rng(seed)
    body = random_body(random, joints)
    pelvis = random.normal(size=(frames, 3))
    local = random_rotations(random, frames, joints)
    rotations, positions = world_poses(body, pelvis, local)
    for frame in range(frames):
        matrices, expected = joint_frames(body, pelvis[frame], local[frame])
        np.testing.assert_allclose(positions[frame], expected, rtol=0, atol=1e-12)
        found = np.array([rotation_matrix(q) for q in rotations[frame]])
        np.testing.assert_allclose(found, matrices, rtol=0, atol=1e-12)


def test_at_rest_offsets_add_up_along_the_tree() -> None:
    body = Skeleton(
        ("Hips", "Thigh", "Shank", "Spine"),
        np.array([-1, 0, 1, 0]),
        np.array([[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, -0.4, 0.0], [0.0, 0.2, 0.0]]),
    )
    still = np.tile([1.0, 0.0, 0.0, 0.0], (1, 4, 1))
    rotations, positions = world_poses(body, np.array([[1.0, 2.0, 3.0]]), still)
    expected = [[1.0, 2.0, 3.0], [1.1, 2.0, 3.0], [1.1, 1.6, 3.0], [1.0, 2.2, 3.0]]
    np.testing.assert_allclose(positions[0], expected, rtol=0, atol=1e-15)
    np.testing.assert_array_equal(rotations, still)


def test_turning_the_pelvis_turns_the_whole_body_about_it() -> None:
    random = np.random.default_rng(1)
    body = random_body(random, 9)
    local = random_rotations(random, 1, 9)
    turn = from_yaw(0.8)
    turned = local.copy()
    turned[:, 0] = multiply(turn, local[:, 0])
    _, before = world_poses(body, np.zeros((1, 3)), local)
    _, after = world_poses(body, np.zeros((1, 3)), turned)
    np.testing.assert_allclose(after, rotate(turn, before), rtol=0, atol=1e-14)


def test_a_pose_can_be_placed_in_any_frame_and_its_first_row_is_left_alone() -> None:
    random = np.random.default_rng(2)
    body = random_body(random, 6)
    local = random_rotations(random, 6)
    rotations, positions = np.full((6, 4), np.nan), np.full((6, 3), np.nan)
    rotations[0], positions[0] = random_rotations(random), [4.0, 5.0, 6.0]
    given_rotation = rotations[0].copy()
    ignored = local.copy()
    ignored[0] = np.nan
    pose_forward(body.parents, body.rest_offsets, ignored, rotations, positions)
    np.testing.assert_array_equal(rotations[0], given_rotation)
    np.testing.assert_array_equal(positions[0], [4.0, 5.0, 6.0])
    local[0] = given_rotation
    _, expected = joint_frames(body, positions[0], local)
    np.testing.assert_allclose(positions, expected, rtol=0, atol=1e-13)


@pytest.mark.parametrize("dtype", [np.float32, np.int64])
def test_poses_of_any_number_type_and_memory_order_are_taken(dtype: Any) -> None:
    body = random_body(np.random.default_rng(3), 3)
    local: Any = np.zeros((2, 3, 4), dtype=dtype, order="F")
    local[..., 0] = 1
    pelvis: Any = np.zeros((2, 3), dtype=dtype)
    _, positions = world_poses(body, pelvis, local)
    assert positions.dtype == np.float64
    np.testing.assert_array_equal(positions[0], positions[1])
