from __future__ import annotations

import numpy as np
import pytest
from tests.oracles.slow_kinematics import rotation_matrix

from footfall.arrays import Rotations
from footfall.io.rigid_frames import matrices_of, rigid_rotations


def turns(count: int = 500) -> Rotations:
    random = np.random.default_rng(5)
    some = random.normal(size=(count, 4))
    # Half turns and nearly none are where formulas break.
    some[:4] = np.eye(4)
    some[4:8] = np.eye(4) + 1e-9
    return some / np.linalg.norm(some, axis=-1, keepdims=True)


@pytest.mark.parametrize("scales", [(1.0, 1.0, 1.0), (100.0, 100.0, 100.0), (0.5, 2.0, 3.0)])
def test_a_turn_comes_back_whatever_is_scaled(scales: tuple[float, float, float]) -> None:
    wanted = turns()
    matrices = matrices_of(wanted, np.zeros((len(wanted), 3)), np.tile(scales, (len(wanted), 1)))
    found = rigid_rotations(matrices[..., :3, :3])
    assert np.abs(np.einsum("ti,ti->t", wanted, found)).min() > 1.0 - 1e-12


def test_what_is_mirrored_in_all_axes_turns_as_before() -> None:
    wanted = turns()
    matrices = matrices_of(wanted, np.zeros((len(wanted), 3)), np.full((len(wanted), 3), -2.0))
    found = rigid_rotations(matrices[..., :3, :3])
    assert np.abs(np.einsum("ti,ti->t", wanted, found)).min() > 1.0 - 1e-12


def test_the_matrix_of_a_turn_is_the_textbook_s() -> None:
    random = np.random.default_rng(6)
    for turn in turns(20):
        place, scale = random.normal(size=3), random.uniform(0.5, 2.0, 3)
        matrix = matrices_of(turn, place, scale)
        np.testing.assert_allclose(matrix[:3, :3], rotation_matrix(turn) * scale, atol=1e-12)
        np.testing.assert_array_equal(matrix[:, 3], [*place, 1.0])
        np.testing.assert_array_equal(matrix[3], [0.0, 0.0, 0.0, 1.0])


@pytest.mark.parametrize(
    "matrix", [np.zeros((3, 3)), np.diag([1.0, 0.0, 1.0]), np.full((3, 3), np.nan)]
)
def test_a_flat_matrix_turns_by_nothing_known(matrix: Rotations) -> None:
    assert np.isnan(rigid_rotations(matrix)).all()
