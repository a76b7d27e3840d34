from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.io.small_biped import BIPED, biped_clip, biped_text

from footfall.errors import FileFormatError
from footfall.geometry import conjugate, from_axis_angle, multiply, rotate
from footfall.io.bvh_clip import clip_from_rig
from footfall.io.bvh_rig import BvhRig, parse_bvh

FILE = Path("walk.bvh")
FRAMES = 31


def moving_rig() -> BvhRig:
    """Return a rig in metres that plays `biped_clip`, no joint but the root moving."""
    clip = biped_clip(FRAMES)
    skeleton = clip.skeleton
    rig = parse_bvh(BIPED.encode(), FILE)
    return BvhRig(
        skeleton.names,
        np.array(skeleton.parents),
        np.array(skeleton.rest_offsets),
        np.array(skeleton.tip_offsets),
        np.array(clip.local_rotations),
        {0: np.array(clip.pelvis_positions)},
        FRAMES,
        rig.frame_time,
    )


def test_a_rig_without_position_channels_has_fixed_bones() -> None:
    _, conclusions = clip_from_rig(moving_rig(), FILE)
    assert conclusions.bones.value == 0.0
    assert conclusions.bones.reason == "fixed: no joint but the root has position channels"


def test_a_joint_is_put_at_its_median_place_and_the_loss_is_told() -> None:
    rig = moving_rig()
    head = np.tile(rig.offsets[1], (FRAMES, 1))
    head[5, 1] += 0.03
    rig.translations[1] = head
    clip, conclusions = clip_from_rig(rig, FILE)
    np.testing.assert_array_equal(clip.skeleton.rest_offsets[1], rig.offsets[1])
    assert conclusions.bones.value == pytest.approx(0.03)
    assert conclusions.bones.reason == (
        "fixed: 1 joints have position channels; each is put at its median place, from which "
        "'Head' strays most, by 30.0 mm"
    )
    assert clip.provenance[1] == f"bones: {conclusions.bones.reason}"


def test_a_leg_that_stretches_is_refused() -> None:
    rig = moving_rig()
    knee = np.tile(rig.offsets[3], (FRAMES, 1))
    knee[5, 1] -= 0.05
    rig.translations[3] = knee
    with pytest.raises(FileFormatError) as caught:
        clip_from_rig(rig, FILE)
    assert str(caught.value) == (
        "walk.bvh: joint 'LeftLeg' moves 6% of the leg's length within its parent; at most 5% "
        "can be left out, so bake the motion to rotations first"
    )


def test_a_pelvis_that_turns_under_its_joint_keeps_the_feet_where_they_are() -> None:
    """Hips that swing about a joint which does not turn: as in some captured rigs."""
    plain = moving_rig()
    swing = 0.3 * np.sin(np.linspace(0.0, 6.0, FRAMES))
    turn = from_axis_angle(np.array([0.0, 1.0, 0.0]), swing)
    rig = moving_rig()
    rig.rotations[:, 0] = multiply(plain.rotations[:, 0], conjugate(turn))
    for child in (1, 2, 6):
        rig.translations[child] = rotate(turn, plain.offsets[child])
        rig.rotations[:, child] = multiply(turn, plain.rotations[:, child])
    clip, conclusions = clip_from_rig(rig, FILE)
    expected, _ = clip_from_rig(plain, FILE)
    _, positions = clip.world_poses()
    _, wanted = expected.world_poses()
    # Joint 0 itself is nothing to see: only what hangs on it is.
    np.testing.assert_allclose(positions[:, 1:], wanted[:, 1:], atol=1e-4)
    np.testing.assert_allclose(positions[:, 0], wanted[:, 0], atol=1e-3)
    assert conclusions.bones.value < 1e-4
    assert "the pelvis is turned and placed so that both hips stay" in conclusions.bones.reason


def test_the_root_offset_means_nothing_where_the_root_has_position_channels() -> None:
    clip, _ = clip_from_rig(parse_bvh(BIPED.encode(), FILE), FILE)
    text = biped_text(("OFFSET 0 0 0", "OFFSET 70 88 -50"))
    other, _ = clip_from_rig(parse_bvh(text.encode(), FILE), FILE)
    assert np.array_equal(clip.world_poses()[1], other.world_poses()[1])
    assert np.array_equal(clip.skeleton.rest_offsets, other.skeleton.rest_offsets)
