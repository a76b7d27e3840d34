"""The joints that bodies have in common."""

from __future__ import annotations

import numpy as np
import pytest
from tests.skeleton.bodies import body

from footfall.errors import SkeletonError
from footfall.geometry import conjugate, multiply, rotate
from footfall.skeleton import find_anatomy
from footfall.skeleton.canonical_pose import canonical_rotations, rest_axes
from footfall.skeleton.correspondence import map_body
from footfall.skeleton.landmarks import find_landmarks, landmark_sentences, rest_positions

TEXT = """
Hips
  Spine 0 0.2 0
    Chest 0 0.2 0
      Neck 0 0.2 0
        Head 0 0.1 0 tip 0 0.2 0
      LeftShoulder 0.03 0.15 0
        LeftArm 0.15 0 0
          LeftForeArm 0.28 0 0
            LeftHand 0.25 0 0
      RightShoulder -0.03 0.15 0
        RightArm -0.15 0 0
          RightForeArm -0.28 0 0
            RightHand -0.25 0 0
  LeftUpLeg 0.1 0 0
    LeftLeg 0 -0.4 0
      LeftFoot 0 -0.4 0
        LeftToe 0 -0.06 0.13
  RightUpLeg -0.1 0 0
    RightLeg 0 -0.4 0
      RightFoot 0 -0.4 0
        RightToe 0 -0.06 0.13
"""
HUMAN = body(TEXT)
MARKS = find_landmarks(HUMAN, find_anatomy(HUMAN))


def test_a_column_two_legs_and_two_arms_are_found() -> None:
    names = HUMAN.names
    assert names[MARKS.pelvis] == "Hips"
    assert [names[joint] for joint in MARKS.trunk] == ["Hips", "Spine", "Chest"]
    assert [names[joint] for joint in MARKS.neck] == ["Neck"]
    assert MARKS.head is not None
    assert names[MARKS.head] == "Head"
    assert [names[joint or 0] for joint in MARKS.clavicles] == ["LeftShoulder", "RightShoulder"]
    assert [names[joint or 0] for joint in MARKS.toes] == ["LeftToe", "RightToe"]
    assert MARKS.chest == names.index("Chest")


def test_what_is_missing_is_none_and_is_said_so() -> None:
    lines = [
        line
        for line in TEXT.splitlines()
        if not any(part in line for part in ("Neck", "Head", "Arm", "Hand", "Shoulder"))
    ]
    sentences = dict(landmark_sentences(body("\n".join(lines)))[:-1])
    assert sentences["head"] == "none"
    assert sentences["left arm"] == "none"
    assert sentences["left toes"] == "'LeftToe'"


def test_sentences_name_joints_and_end_with_reasons() -> None:
    sentences = landmark_sentences(HUMAN)
    assert sentences[0] == ("pelvis", "'Hips', the lowest joint that carries both legs")
    assert dict(sentences)["right arm"] == "'RightArm', 'RightForeArm', 'RightHand'"
    assert sentences[-1][0] == "because"
    with pytest.raises(SkeletonError, match="no legs found"):
        landmark_sentences(body("Base\n  Arm 0 1 0\n    Hand 0 1 0"))


def test_the_canonical_pose_stands_upright_whatever_the_frames() -> None:
    canonical = canonical_rotations(HUMAN, MARKS)
    places = rest_positions(HUMAN)
    for joint, child, goal in (
        ("LeftUpLeg", "LeftLeg", (0, -1, 0)),
        ("LeftLeg", "LeftFoot", (0, -1, 0)),
        ("LeftArm", "LeftForeArm", (1, 0, 0)),
        ("RightForeArm", "RightHand", (-1, 0, 0)),
    ):
        one, other = HUMAN.index(joint), HUMAN.index(child)
        bone = places[other] - places[one]
        pointing = rotate(canonical[one], bone / np.linalg.norm(bone))
        np.testing.assert_allclose(pointing, goal, atol=1e-9)
    np.testing.assert_allclose(rest_axes(HUMAN, MARKS), [1, 0, 0, 0], atol=1e-9)


def test_a_body_maps_to_itself_and_to_another_size_joint_by_joint() -> None:
    other = body(TEXT.replace("Spine", "Belly"))
    found = map_body(HUMAN, other)
    assert found.leg_ratio == pytest.approx(1.0)
    assert found.arm_ratios == pytest.approx((1.0, 1.0))
    chest = other.index("Chest")
    assert found.sources[chest].tolist() == [chest, chest]
    np.testing.assert_allclose(found.fractions, 0.0, atol=1e-9)
    turns = multiply(conjugate(found.turns[:, 0]), found.turns[:, 1])
    np.testing.assert_allclose(np.abs(turns[:, 0]), 1.0, atol=1e-9)
    assert len(found.reasons) == other.count


def test_a_correction_is_taken_and_a_wrong_one_refused() -> None:
    other = body(TEXT.replace("Spine", "Belly"))
    found = map_body(HUMAN, other, corrections={"Belly": ("Hips", "Chest", 0.25)})
    assert found.fractions[other.index("Belly")] == 0.25
    assert found.reasons[other.index("Belly")].endswith("(as the map file says)")
    with pytest.raises(SkeletonError, match=r"^the map names 'Tail', which is no joint"):
        map_body(HUMAN, other, corrections={"Tail": None})
    with pytest.raises(SkeletonError, match=r"^the map drives 'Belly' by 'Tail', no joint of"):
        map_body(HUMAN, other, corrections={"Belly": ("Tail", "Hips", 0.0)})
    with pytest.raises(SkeletonError, match=r"at a fraction of 2; it must be within 0..1$"):
        map_body(HUMAN, other, corrections={"Belly": ("Hips", "Hips", 2.0)})


def test_a_clavicle_that_is_folded_at_rest_does_not_turn_the_body() -> None:
    folded = body(TEXT.replace("RightArm -0.15 0 0", "RightArm 0.02 -0.3 0.1"))
    axes = rest_axes(folded, find_landmarks(folded, find_anatomy(folded)))
    left = rotate(axes, np.array([1.0, 0.0, 0.0]))
    np.testing.assert_allclose(left, [1.0, 0.0, 0.0], atol=1e-9)
