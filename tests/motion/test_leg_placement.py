from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests import walking_figure

from footfall.arrays import Floats
from footfall.geometry import from_yaw, multiply
from footfall.motion import place_feet
from footfall.motion.pelvis_drop import pelvis_drops
from footfall.skeleton import find_anatomy, leg_length, world_poses

WALK = walking_figure.walk(frames=34, fps=30.0)
BODY = WALK.skeleton
ANATOMY = find_anatomy(BODY)
ANKLES = [leg.ankle for leg in ANATOMY.legs]
ROTATIONS, POSITIONS = WALK.world_poses()


def placed(ankles: Floats, feet: Floats, pelvis: Floats) -> tuple[Floats, Floats, Floats]:
    local = place_feet(BODY, ANATOMY, pelvis, WALK.local_rotations, ankles, feet)
    return (local, *world_poses(BODY, pelvis, local))


@given(st.integers(0, 2**32 - 1))
@settings(deadline=None, max_examples=25)
def test_ankles_come_to_their_targets_and_feet_turn_as_told(seed: int) -> None:
    random = np.random.default_rng(seed)
    targets = POSITIONS[:, ANKLES] + random.uniform([-0.05, 0.03, -0.05], [0.05, 0.1, 0.05])
    feet = multiply(from_yaw(float(random.uniform(-0.5, 0.5))), ROTATIONS[:, ANKLES])
    local, rotations, positions = placed(targets, feet, WALK.pelvis_positions)
    np.testing.assert_allclose(positions[:, ANKLES], targets, atol=1e-9)
    agreement = np.einsum("fji,fji->fj", rotations[:, ANKLES], feet)
    np.testing.assert_allclose(np.abs(agreement), 1.0, atol=1e-12)
    others = [j for j in range(BODY.count) if j not in {1, 2, 3, 5, 6, 7}]
    np.testing.assert_array_equal(local[:, others], WALK.local_rotations[:, others])


def test_feet_in_place_leave_the_legs_as_they_are() -> None:
    local, _, _ = placed(POSITIONS[:, ANKLES], ROTATIONS[:, ANKLES], WALK.pelvis_positions)
    np.testing.assert_allclose(local, WALK.local_rotations, atol=1e-12)


def test_knees_stay_on_their_side() -> None:
    targets = POSITIONS[:, ANKLES] + np.array([0.0, 0.05, 0.0])
    _, _, positions = placed(targets, ROTATIONS[:, ANKLES], WALK.pelvis_positions)
    for leg in ANATOMY.legs:
        middle = 0.5 * (positions[:, leg.hip] + positions[:, leg.ankle])
        assert (positions[:, leg.knee, 2] > middle[:, 2]).all()


def test_a_target_out_of_reach_is_approached_in_its_direction() -> None:
    targets = POSITIONS[:, ANKLES] - np.array([0.0, 0.4, 0.0])
    _, _, positions = placed(targets, ROTATIONS[:, ANKLES], WALK.pelvis_positions)
    for foot, leg in enumerate(ANATOMY.legs):
        reached = positions[:, leg.ankle] - positions[:, leg.hip]
        wanted = targets[:, foot] - positions[:, leg.hip]
        length = np.linalg.norm(reached, axis=-1)
        assert (length <= leg_length(BODY, leg)).all()
        cosine = (reached * wanted).sum(axis=-1) / length / np.linalg.norm(wanted, axis=-1)
        np.testing.assert_allclose(cosine, 1.0, atol=1e-9)


def drops(lowered: Floats, cyclic: bool = False) -> Floats:
    ankles = POSITIONS[:, ANKLES].copy()
    ankles[..., 1] -= lowered[:, np.newaxis]
    return pelvis_drops(
        BODY, ANATOMY, WALK.pelvis_positions, WALK.local_rotations, ankles, 30.0, cyclic
    )


def test_the_pelvis_stays_where_the_feet_are_in_reach() -> None:
    assert not drops(np.zeros(34)).any()
    assert not drops(np.full(34, -0.05)).any()


def test_a_lowered_pelvis_lets_every_ankle_come_to_its_target() -> None:
    lowered = np.zeros(34)
    lowered[15:18] = 0.06
    drop = drops(lowered)
    assert drop.max() == pytest.approx(0.06, abs=0.03)
    assert not drop[:5].any()
    pelvis = WALK.pelvis_positions - drop[:, np.newaxis] * np.array([0.0, 1.0, 0.0])
    targets = POSITIONS[:, ANKLES].copy()
    targets[..., 1] -= lowered[:, np.newaxis]
    _, _, positions = placed(targets, ROTATIONS[:, ANKLES], pelvis)
    np.testing.assert_allclose(positions[:, ANKLES], targets, atol=1e-3)


def test_the_drop_of_a_cycle_goes_around() -> None:
    lowered = np.zeros(34)
    lowered[[0, -1]] = 0.06
    drop = drops(lowered, cyclic=True)
    assert drop[0] == drop[-1] > 0.0
    assert drop[1] > 0.0
    assert drop[-2] > 0.0
    assert np.abs(np.diff(drop)).max() < 0.02
