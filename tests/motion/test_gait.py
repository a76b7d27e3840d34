from __future__ import annotations

import numpy as np
import pytest
from tests import walking_figure

from footfall.motion.gait import foot_point_paths, foot_speeds, swinging
from footfall.skeleton import find_anatomy

WALK = walking_figure.walk(frames=133, fps=60.0)
ANATOMY = find_anatomy(WALK.skeleton)
ROTATIONS, POSITIONS = WALK.world_poses()
POINTS = foot_point_paths(ANATOMY, ROTATIONS, POSITIONS)


def test_heels_and_toes_of_left_and_right() -> None:
    assert POINTS.shape == (133, 2, 2, 3)
    for foot, leg in enumerate(ANATOMY.legs):
        np.testing.assert_allclose(POINTS[:, foot, 0], POSITIONS[:, leg.ankle])
        np.testing.assert_allclose(POINTS[:, foot, 1], POSITIONS[:, leg.toe.joint])


def test_a_foot_swings_while_it_is_not_planted() -> None:
    supports = walking_figure.supports(frames=133)
    speeds = foot_speeds(POINTS, POSITIONS[:, 0], WALK.fps)
    for foot, side in enumerate("LR"):
        planted = np.array([symbol in (side, "D") for symbol in supports])
        wrong = swinging(speeds[:, foot]) == planted
        assert np.count_nonzero(wrong) <= 0.12 * len(planted)
        assert speeds[planted, foot].mean() < 0.05


@pytest.mark.parametrize("drift", [0.0, 0.1])
def test_on_a_treadmill_feet_move_over_the_belt(drift: float) -> None:
    seconds = np.arange(133) / 60.0
    ahead = (1.0 - drift) * (walking_figure.STRIDE / walking_figure.PERIOD) * seconds
    shift = ahead[:, np.newaxis] * np.array([0.0, 0.0, 1.0])
    belt = foot_speeds(POINTS - shift[:, np.newaxis, np.newaxis], POSITIONS[:, 0] - shift, 60.0)
    ground = foot_speeds(POINTS, POSITIONS[:, 0], 60.0)
    np.testing.assert_allclose(belt, ground, atol=0.02)


def test_a_standing_foot_that_trembles_does_not_swing() -> None:
    tremble = np.random.default_rng(0).uniform(0.0, 0.2, size=300)
    assert not swinging(tremble).any()


def test_a_single_frame_does_not_move() -> None:
    assert foot_speeds(POINTS[:1], POSITIONS[:1, 0], 60.0).tolist() == [[0.0, 0.0]]
