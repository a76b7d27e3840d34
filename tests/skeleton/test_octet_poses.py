"""Eight bodies at once against one body worked out slowly."""

from __future__ import annotations

import numpy as np
import pytest
from tests import walking_figure
from tests.oracles.slow_kinematics import joint_frames, rotation_matrix

from footfall.arrays import Floats, SmallFloats
from footfall.compilation import lean_kernel
from footfall.octet_memory import load
from footfall.skeleton.normalized import padded_count
from footfall.skeleton.octet_poses import PLACEMENT, lower_bodies, place_chains, reach_ankles
from footfall.skeleton.rig import Rig, rig_of

HEIGHT = 0.9


@lean_kernel
def place(rig: Rig, local: SmallFloats, heights: SmallFloats, poses: SmallFloats) -> None:
    place_chains(rig, local, load(heights, 0), poses, 0)


@lean_kernel
def reach(rig: Rig, side: int, local: SmallFloats, aims: SmallFloats, poses: SmallFloats) -> None:
    ankle = (load(aims, 0), load(aims, 8), load(aims, 16))
    reach_ankles(rig, side, local, ankle, load(aims, 24) > 0.5, poses, 0)


@lean_kernel
def lower(poses: SmallFloats, drops: SmallFloats) -> None:
    lower_bodies(poses, 0, load(drops, 0))


def random_pose(rig: Rig, seed: int) -> SmallFloats:
    """Return eight random, modestly bent poses by component, shape (4, rows, 8)."""
    joints = len(rig.parents)
    local = np.zeros((4, padded_count(joints), 8))
    local[0] = 1.0
    turns = np.random.default_rng(seed).normal(0.0, 0.3, (3, joints + 2, 8))
    local[1:, : joints + 2] = turns
    return (local / np.linalg.norm(local, axis=0)).astype(np.float32)


def positions(poses: SmallFloats, lane: int) -> Floats:
    return poses[0, :, 4:, lane].astype(np.float64)


@pytest.fixture
def rig() -> Rig:
    return rig_of(walking_figure.skeleton(), walking_figure.anatomy())


@pytest.fixture
def placed(rig: Rig) -> tuple[SmallFloats, SmallFloats]:
    local = random_pose(rig, 3)
    poses = np.zeros((1, len(rig.parents), PLACEMENT, 8), dtype=np.float32)
    place(rig, local, np.full(8, HEIGHT, dtype=np.float32), poses)
    return local, poses


def test_every_joint_is_where_its_parents_put_it(
    rig: Rig, placed: tuple[SmallFloats, SmallFloats]
) -> None:
    local, poses = placed
    for lane in range(8):
        own = local[:, : len(rig.parents), lane].T.astype(np.float64)
        matrices, expected = joint_frames(
            walking_figure.skeleton(), np.array([0.0, HEIGHT, 0.0]), own
        )
        assert positions(poses, lane) == pytest.approx(expected, abs=2e-6)
        for joint, matrix in enumerate(matrices):
            found = rotation_matrix(poses[0, joint, :4, lane].astype(np.float64))
            assert found == pytest.approx(matrix, abs=2e-6)


def test_bodies_are_lowered_each_by_its_own(placed: tuple[SmallFloats, SmallFloats]) -> None:
    _, poses = placed
    before = poses.copy()
    drops = np.arange(8, dtype=np.float32) / 100.0
    lower(poses, drops)
    moved = before - poses
    assert moved[:, :, 5] == pytest.approx(np.broadcast_to(drops, moved[:, :, 5].shape), abs=1e-6)
    moved[:, :, 5] = 0.0
    assert not moved.any()


@pytest.mark.parametrize("side", [0, 1])
def test_a_leg_reaches_where_it_is_asked_and_no_bone_changes_length(
    rig: Rig, placed: tuple[SmallFloats, SmallFloats], side: int
) -> None:
    local, poses = placed
    before = poses.copy()
    hip, knee, ankle = rig.limbs[side]
    aims = np.zeros((4, 8), dtype=np.float32)
    aims[:3] = before[0, hip, 4:] + np.array([[0.05], [-0.7 * rig.leg_length], [0.1]])
    aims[3, ::2] = 1.0
    reach(rig, side, local, aims, poses)
    reached = poses[0, ankle, 4:]
    assert reached[:, ::2] == pytest.approx(aims[:3, ::2], abs=2e-6)
    # The others were not asked to reach.
    assert np.array_equal(poses[..., 1::2], before[..., 1::2])
    for one, other in ((hip, knee), (knee, ankle)):
        lengths = [np.linalg.norm(p[0, one, 4:] - p[0, other, 4:], axis=0) for p in (before, poses)]
        assert lengths[1] == pytest.approx(lengths[0], abs=2e-6)
    # The feet are as blended.
    foot = local[:, len(rig.parents) + side]
    assert poses[0, ankle, :4, ::2] == pytest.approx(foot[:, ::2])
    others = rig.leg_sides != side
    assert np.array_equal(poses[:, others], before[:, others])
