"""An arm that reaches for a point."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.skeleton.bodies import body
from tests.walking_figure import walk

from footfall.arrays import Positions, Rotations
from footfall.geometry import rotate
from footfall.skeleton import find_anatomy
from footfall.skeleton.arm_ik import ArmRig, arm_rig_of, reach_wrist

WALK = walk(frames=12, fps=10.0)
BODY = WALK.skeleton
ANATOMY = find_anatomy(BODY)
ARMS = arm_rig_of(BODY, ANATOMY)
ROTATIONS, POSITIONS = (array[3] for array in WALK.world_poses())
SIDES = ("Left", "Right")


def reach(
    side: int, target: tuple[float, float, float], weight: float = 1.0, arms: ArmRig = ARMS
) -> tuple[float, Rotations, Positions]:
    rotations, positions = ROTATIONS.copy(), POSITIONS.copy()
    missed = reach_wrist(arms, side, target, weight, rotations, positions)
    return missed, rotations, positions


def near_shoulder(side: int, away: tuple[float, float, float]) -> tuple[float, float, float]:
    shoulder = POSITIONS[BODY.index(f"{SIDES[side]}Arm")]
    x, y, z = (shoulder + away).tolist()
    return x, y, z


@pytest.mark.parametrize("side", [0, 1])
def test_the_wrist_comes_to_its_target_and_the_hand_keeps_its_attitude(side: int) -> None:
    target = near_shoulder(side, (0.1, -0.1, 0.35))
    missed, rotations, positions = reach(side, target)
    wrist = BODY.index(f"{SIDES[side]}Hand")
    np.testing.assert_allclose(positions[wrist], target, atol=1e-9)
    np.testing.assert_array_equal(rotations[wrist], ROTATIONS[wrist])
    assert missed < 1e-9


@pytest.mark.parametrize("side", [0, 1])
def test_nothing_but_the_arm_moves_and_bones_keep_their_lengths(side: int) -> None:
    _, rotations, positions = reach(side, near_shoulder(side, (0.0, 0.3, 0.2)))
    others = ARMS.sides != side
    np.testing.assert_array_equal(positions[others], POSITIONS[others])
    np.testing.assert_array_equal(rotations[others], ROTATIONS[others])
    for joint in range(1, BODY.count):
        parent = int(BODY.parents[joint])
        expected = positions[parent] + rotate(rotations[parent], BODY.rest_offsets[joint])
        np.testing.assert_allclose(positions[joint], expected, atol=1e-9)


def test_half_a_weight_goes_half_the_way() -> None:
    target = near_shoulder(0, (0.1, -0.2, 0.3))
    _, _, positions = reach(0, target, 0.5)
    wrist = BODY.index("LeftHand")
    np.testing.assert_allclose(positions[wrist], 0.5 * (POSITIONS[wrist] + target), atol=1e-9)


def test_no_weight_and_no_arm_leave_the_body_as_it_is() -> None:
    missed, _, positions = reach(0, (1.0, 1.0, 1.0), 0.0)
    assert missed == 0.0
    np.testing.assert_array_equal(positions, POSITIONS)
    armless = arm_rig_of(BODY, replace(ANATOMY, arms=(None, None)))
    missed, _, positions = reach(0, (1.0, 1.0, 1.0), 1.0, armless)
    assert missed == 0.0
    np.testing.assert_array_equal(positions, POSITIONS)


def test_what_is_out_of_reach_is_named_by_how_far_it_is() -> None:
    target = near_shoulder(0, (0.0, 0.0, 2.0))
    missed, _, positions = reach(0, target)
    assert missed == pytest.approx(np.linalg.norm(positions[BODY.index("LeftHand")] - target))
    assert missed == pytest.approx(2.0 - 0.53, abs=0.01)


def test_twist_joints_and_fingers_go_with_their_bones() -> None:
    limb = body(
        """
        Hips
          Spine 0 0.2 0
            LeftArm 0.2 0.3 0
              LeftArmTwist 0.1 0 0
              LeftForeArm 0.3 0 0
                LeftHand 0.25 0 0
                  LeftThumb 0.05 0 0.02
            RightArm -0.2 0.3 0
              RightForeArm -0.3 0 0
                RightHand -0.25 0 0
          LeftUpLeg 0.1 0 0
            LeftLeg 0 -0.4 0
              LeftFoot 0 -0.4 0
          RightUpLeg -0.1 0 0
            RightLeg 0 -0.4 0
              RightFoot 0 -0.4 0
        """
    )
    arms = arm_rig_of(limb, find_anatomy(limb))
    segments = {limb.names[joint]: int(arms.segments[joint]) for joint in range(limb.count)}
    assert [name for name, segment in segments.items() if segment == 1] == [
        "LeftArm",
        "LeftArmTwist",
        "RightArm",
    ]
    assert segments["LeftForeArm"] == 2
    assert segments["LeftHand"] == segments["LeftThumb"] == 3
    assert not segments["LeftFoot"]


@settings(max_examples=60, deadline=None)
@given(st.tuples(*[st.floats(-3.0, 3.0)] * 3), st.floats(0.0, 1.0))
def test_no_target_gives_a_number_that_is_none(
    target: tuple[float, float, float], weight: float
) -> None:
    missed, rotations, positions = reach(1, target, weight)
    assert np.isfinite(missed)
    assert np.isfinite(rotations).all()
    assert np.isfinite(positions).all()
