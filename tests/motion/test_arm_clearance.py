"""Arms that stay out of the trunk, and the smooth curves by which they do."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.walking_figure import walk

from footfall.arrays import Rotations
from footfall.motion.arm_clearance import MARGIN, clear_arm
from footfall.motion.arm_placement import place_wrist
from footfall.motion.smooth_cover import covered
from footfall.skeleton import find_anatomy, world_poses
from footfall.skeleton.capsule_overlap import arm_overlaps

WALK = walk(frames=60, fps=30.0)
BODY = WALK.skeleton
ANATOMY = find_anatomy(BODY)


def hugging() -> Rotations:
    """Return the walk with its left hand in the belly halfway through."""
    _, positions = WALK.world_poses()
    arm = ANATOMY.arms[0]
    assert arm is not None
    share = np.hanning(60)[:, np.newaxis]
    belly = WALK.pelvis_positions + np.array([0.04, 0.15, 0.02])
    wrists = (1.0 - share) * positions[:, arm.wrist] + share * belly
    return place_wrist(BODY, arm, WALK.pelvis_positions, WALK.local_rotations, wrists)


@pytest.mark.parametrize("cyclic", [False, True])
def test_an_arm_in_the_trunk_is_turned_out_smoothly(cyclic: bool) -> None:
    local = hugging()
    allowed = np.zeros(60)
    before = arm_overlaps(BODY, ANATOMY, world_poses(BODY, WALK.pelvis_positions, local)[1])
    pose = (WALK.pelvis_positions, local)
    cleared = clear_arm(BODY, ANATOMY, 0, pose, allowed, 30.0, cyclic)
    _, positions = world_poses(BODY, WALK.pelvis_positions, cleared)
    after = arm_overlaps(BODY, ANATOMY, positions)
    assert before[:, 0].max() > 0.03
    assert after[:, 0].max() <= MARGIN + 1e-3
    shoulder = BODY.index("LeftArm")
    turns = np.abs(np.diff(cleared[:, shoulder], axis=0)).max()
    assert turns < 0.15
    others = [joint for joint in range(BODY.count) if joint != shoulder]
    np.testing.assert_array_equal(cleared[:, others], local[:, others])


def test_an_arm_that_is_as_deep_as_it_may_be_stays() -> None:
    local = hugging()
    pose = (WALK.pelvis_positions, local)
    cleared = clear_arm(BODY, ANATOMY, 0, pose, np.full(60, 1.0), 30.0, cyclic=False)
    np.testing.assert_array_equal(cleared, local)


@settings(deadline=None)
@given(st.lists(st.floats(0.0, 1.0), min_size=3, max_size=40), st.integers(1, 8), st.booleans())
def test_a_cover_is_nowhere_below_what_it_covers(
    values: list[float], reach: int, cyclic: bool
) -> None:
    needed = np.array(values)
    if cyclic:
        needed[-1] = needed[0]
    cover = covered(needed, reach, cyclic)
    assert cover.shape == needed.shape
    assert (cover >= needed - 1e-12).all()
    assert cover.max() <= needed.max() + 1e-12
