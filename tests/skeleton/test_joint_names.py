from __future__ import annotations

import pytest

from footfall.skeleton.joint_names import Role, read_joint_name

NAMED = (
    ("LeftUpLeg", 0, Role.THIGH),
    ("Character1_LeftUpLeg", 0, Role.THIGH),
    ("mixamorig:RightUpLeg", 1, Role.THIGH),
    ("mixamorig6:LeftFoot", 0, Role.FOOT),
    ("Bip01 L Thigh", 0, Role.THIGH),
    ("Bip01 R Calf", 1, Role.SHANK),
    ("lThigh", 0, Role.THIGH),
    ("lShin", 0, Role.SHANK),
    ("rFoot", 1, Role.FOOT),
    ("lfemur", 0, Role.THIGH),
    ("rtibia", 1, Role.SHANK),
    ("ltoes", 0, Role.TOE),
    ("thigh.L", 0, Role.THIGH),
    ("DEF-shin.R.001", 1, Role.SHANK),
    ("upperleg.l", 0, Role.THIGH),
    ("lowerleg.r", 1, Role.SHANK),
    ("leftUpperLeg", 0, Role.THIGH),
    ("thigh_l", 0, Role.THIGH),
    ("ball_r", 1, Role.TOE),
    ("left_hip", 0, Role.THIGH),
    ("right_ankle", 1, Role.FOOT),
    ("L_Hip", 0, Role.THIGH),
    ("m_avg_R_Knee", 1, Role.SHANK),
    ("LeftHip", 0, Role.THIGH),
    ("LeftKnee", 0, Role.SHANK),
    ("LeftAnkle", 0, Role.FOOT),
    ("LEFT_KNEE", 0, Role.SHANK),
    ("leftupleg", 0, Role.THIGH),
    ("LeftFootThumb1", 0, Role.TOE),
    ("LeftToeBase", 0, Role.TOE),
    ("Lefthand", 0, Role.HAND),
    ("lhand", 0, Role.HAND),
    ("RightShoulder1", 1, Role.UPPER_ARM),
    ("lShldr", 0, Role.UPPER_ARM),
    ("lhumerus", 0, Role.UPPER_ARM),
    ("rradius", 1, Role.FOREARM),
    ("Head", None, Role.HEAD),
    ("HEad", None, Role.HEAD),
    ("lowerneck", None, Role.NECK),
    ("Neck1", None, Role.NECK),
)
"""Names seen in files, the side they name (0 left, 1 right) and what they are."""

HELPERS = (
    "LHipJoint",
    "L_Femur_RIGMESH",
    "thigh_twist_01_l",
    "LeftUpLegDummy",
    "HEadDummy",
    "Bip01LToe0Nub",
    "LeftToe_End",
    "LeftHandThumb1",
    "ik_foot_l",
    "LowerBack",
    "Spine",
    "Pelvis",
    "radial",
    "lower",
)


@pytest.mark.parametrize(("name", "side", "role"), NAMED)
def test_a_name_tells_its_side_and_what_it_is(name: str, side: int | None, role: Role) -> None:
    read = read_joint_name(name)
    assert (read.side, read.role) == (side, role)


@pytest.mark.parametrize("name", HELPERS)
def test_a_helper_is_not_taken_for_what_it_helps(name: str) -> None:
    assert read_joint_name(name).role is None


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("LeftToeBase", "RightToeBase"),
        ("thigh.L", "thigh.R"),
        ("lShin", "rShin"),
        ("lhand", "rhand"),
    ],
)
def test_the_two_joints_of_a_pair_have_the_same_words(left: str, right: str) -> None:
    one, other = read_joint_name(left), read_joint_name(right)
    assert (one.side, other.side) == (0, 1)
    assert one.words == other.words
