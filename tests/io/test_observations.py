from __future__ import annotations

import numpy as np
import pytest
from tests.io.small_biped import biped_clip

from footfall.arrays import Positions
from footfall.geometry import from_yaw, rotate
from footfall.io.conclusions import LegNames
from footfall.io.observations import (
    conclude_cyclic,
    conclude_feet,
    conclude_first_frame,
    conclude_floor,
    legs_or_reason,
)
from footfall.skeleton import Skeleton

FRAMES = 61
LIFT = np.array([0.0, 0.1, 0.0])


def swinging(gap: float) -> Positions:
    """Return joints that swing once and end `gap` from where they began, walking a curve."""
    phase = np.linspace(0.0, 2.0 * np.pi, FRAMES)
    pose = np.array([[0.0, 0.9, 0.0], [0.1, 0.5, 0.0], [-0.1, 0.1, 0.0], [0.0, 1.5, 0.1]])
    positions = np.tile(pose, (FRAMES, 1, 1))
    positions[:, 1:, 1] += 0.2 * np.sin(phase)[:, np.newaxis]
    positions[:, 1:, 1] += np.linspace(0.0, gap, FRAMES)[:, np.newaxis] * np.sqrt(4.0 / 3.0)
    walked = np.stack([phase, np.zeros(FRAMES), 0.3 * phase], axis=-1)[:, np.newaxis]
    return rotate(from_yaw(phase / 5.0)[:, np.newaxis], positions) + walked


@pytest.mark.parametrize(
    ("gap", "cyclic", "reason"),
    [
        (0.0, True, "cyclic: the last pose is 0.0 mm from the first"),
        (0.0019, True, "cyclic: the last pose is 1.9 mm from the first"),
        (
            0.0021,
            False,
            "not cyclic: the last pose is 2.1 mm from the first; editing can close such a gap",
        ),
        (0.1, False, "not cyclic: the last pose is 100.0 mm from the first"),
    ],
)
def test_a_clip_that_comes_back_to_its_first_pose_is_cyclic(
    gap: float, cyclic: bool, reason: str
) -> None:
    found = conclude_cyclic(swinging(gap))
    assert (found.value, found.reason) == (cyclic, reason)


def test_a_body_that_stands_still_is_not_cyclic() -> None:
    positions = np.tile(swinging(0.0)[0], (FRAMES, 1, 1))
    positions[5, 1] += 0.01
    assert conclude_cyclic(positions).reason == "not cyclic: the body stands still"


def test_two_frames_are_no_cycle() -> None:
    found = conclude_cyclic(swinging(0.0)[[0, -1]])
    assert (found.value, found.reason) == (False, "not cyclic: there are too few frames")


def test_a_t_pose_before_the_motion_is_an_outlier() -> None:
    positions = swinging(0.0)
    positions[0, 1:, 0] += 0.3
    found = conclude_first_frame(positions)
    assert found.value
    assert found.reason == (
        "an outlier, such as a T-pose: the joints leap by 260 mm to the second frame, and by at "
        "most 18 mm between almost all others; crop it off before use"
    )


def test_a_first_frame_like_the_others_is_part_of_the_motion() -> None:
    found = conclude_first_frame(swinging(0.0))
    assert not found.value
    assert found.reason == "part of the motion: the joints move by 18 mm to the second frame"


def test_three_frames_do_not_tell() -> None:
    found = conclude_first_frame(swinging(0.0)[:3])
    assert (found.value, found.reason) == (
        False,
        "too few frames to tell whether the first one is an outlier",
    )


def test_the_floor_is_where_the_lowest_foot_joint_rests() -> None:
    clip = biped_clip(200)
    rotations, positions = clip.world_poses()
    found = conclude_floor(legs_or_reason(clip.skeleton), rotations, positions + LIFT)
    heights = positions[:, [4, 5, 8, 9], 1].min(axis=1) + 0.1
    assert found.value == pytest.approx(np.percentile(heights, 5.0))
    assert found.reason == (
        f"at {found.value * 1000.0:+.0f} mm: there the lowest joint of the feet is in the lowest "
        "twentieth of frames"
    )


def test_the_floor_of_a_body_without_legs_is_below_its_lowest_joint() -> None:
    clip = biped_clip(200)
    rotations, positions = clip.world_poses()
    found = conclude_floor("no legs", rotations, positions)
    assert found.value == pytest.approx(np.percentile(positions[..., 1].min(axis=1), 5.0))
    assert "there the lowest joint is in the lowest twentieth" in found.reason


def test_the_joints_of_the_feet_are_named() -> None:
    skeleton = biped_clip().skeleton
    assert conclude_feet(skeleton, legs_or_reason(skeleton)).value == (
        LegNames("LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToe"),
        LegNames("RightUpLeg", "RightLeg", "RightFoot", "RightToe"),
    )


def test_a_body_without_legs_has_no_feet_and_says_why() -> None:
    arm = Skeleton(("a", "b"), np.array([-1, 0]), np.array([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]]))
    found = conclude_feet(arm, legs_or_reason(arm))
    assert found.value is None
    assert found.reason.startswith("no legs found: ")
