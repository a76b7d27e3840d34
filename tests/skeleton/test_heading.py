from __future__ import annotations

import numpy as np
import pytest
from tests import walking_figure

from footfall.geometry import from_axis_angle, from_yaw, multiply
from footfall.skeleton import find_anatomy, pelvis_headings, world_poses

BODY = walking_figure.skeleton()
ANATOMY = find_anatomy(BODY)


def headings(pelvis_rotations: np.ndarray) -> np.ndarray:
    count = len(pelvis_rotations)
    local = np.tile([1.0, 0.0, 0.0, 0.0], (count, BODY.count, 1))
    local[:, 0] = pelvis_rotations
    _, positions = world_poses(BODY, np.zeros((count, 3)), local)
    return pelvis_headings(ANATOMY, positions)


def test_it_is_the_yaw_of_the_pelvis_and_never_jumps() -> None:
    yaws = np.linspace(-1.0, 20.0, 200)
    np.testing.assert_allclose(headings(from_yaw(yaws)), yaws, atol=1e-12)


def test_neither_leaning_nor_dropping_a_hip_changes_it() -> None:
    lean = from_axis_angle(np.array([1.0, 0.0, 0.0]), np.linspace(-1.4, 1.4, 9))
    drop = from_axis_angle(np.array([0.0, 0.0, 1.0]), np.linspace(-1.2, 1.2, 9))
    for tilt in (lean, drop):
        np.testing.assert_allclose(headings(multiply(from_yaw(0.7), tilt)), 0.7, atol=1e-12)


def test_where_the_hips_stand_above_each_other_it_is_interpolated() -> None:
    rolls = from_axis_angle(np.array([0.0, 0.0, 1.0]), np.array([0.0, 1.5, 1.6, 0.0]))
    turned = multiply(from_yaw(np.array([0.0, 0.3, 0.6, 0.9])), rolls)
    np.testing.assert_allclose(headings(turned), [0.0, 0.3, 0.6, 0.9], atol=1e-12)


def test_hips_that_never_tell_a_heading_face_forward() -> None:
    roll = from_axis_angle(np.array([0.0, 0.0, 1.0]), np.full(3, np.pi / 2))
    assert headings(roll) == pytest.approx([0.0, 0.0, 0.0])
