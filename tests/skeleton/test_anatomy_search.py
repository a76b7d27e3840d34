from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from tests.skeleton.bodies import body

from footfall.errors import SkeletonError
from footfall.io import load
from footfall.skeleton import Anatomy, BodyPart, Skeleton, arm_length, find_anatomy, leg_length

MOTIONS = Path(__file__).parents[2].parent / "shared" / "motions"
L, T, H, A, B = BodyPart  # legs, trunk, head, left arm, right arm


def legs(skeleton: Skeleton, anatomy: Anatomy) -> list[tuple[str, str, str, str]]:
    return [
        (
            skeleton.names[leg.hip],
            skeleton.names[leg.knee],
            skeleton.names[leg.ankle],
            skeleton.names[leg.toe.joint],
        )
        for leg in anatomy.legs
    ]


FULL = """
Hips
  LHipJoint 0 0 0
    LeftUpLeg .09 -.05 0
      LeftUpLegTwist 0 -.2 0
      L_Femur_RIGMESH 0 0 0
      LeftLeg 0 -.42 0
        LeftFoot 0 -.40 0
          L_Talus .05 -.08 .04
          LeftToeBase 0 -.06 .13
            LeftToe_End 0 0 .06
  RHipJoint 0 0 0
    RightUpLeg -.09 -.05 0
      RightLeg 0 -.42 0
        RightFoot 0 -.40 0
          RightToeBase 0 -.06 .13
            RightToe_End 0 0 .06
  Tail 0 0 -.1
  Spine 0 .1 0
    Chest 0 .2 0
      Neck 0 .2 0
        Head 0 .1 0
          Jaw 0 0 .1
      LeftShoulder .05 .15 0
        LeftArm .12 0 0
          LeftForeArm .28 0 0
            LeftHand .25 0 0
              LeftHandThumb1 .03 0 0
      RightShoulder -.05 .15 0
        RightArm -.12 0 0
          RightForeArm -.28 0 0
            RightHand -.25 0 0
      R_Shoulder_RIGMESH 0 0 0
"""


def test_helpers_are_not_taken_for_limbs() -> None:
    skeleton = body(FULL)
    anatomy = find_anatomy(skeleton)
    assert legs(skeleton, anatomy) == [
        ("LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToeBase"),
        ("RightUpLeg", "RightLeg", "RightFoot", "RightToeBase"),
    ]
    assert leg_length(skeleton, anatomy.left) == pytest.approx(0.82)
    left, right = anatomy.arms
    assert left is not None
    assert right is not None
    arm = (left.shoulder, left.elbow, left.wrist)
    assert [skeleton.names[j] for j in arm] == ["LeftArm", "LeftForeArm", "LeftHand"]
    assert arm_length(skeleton, right) == pytest.approx(0.53)
    assert anatomy.head == skeleton.index("Head")
    assert anatomy.chest == skeleton.index("Chest")


def test_every_joint_belongs_to_a_part() -> None:
    anatomy = find_anatomy(body(FULL))
    assert [BodyPart(part) for part in anatomy.parts.tolist()] == (
        [L] * 17 + [T, T, H, H, H] + [A] * 5 + [B] * 5
    )
    assert not anatomy.parts.flags.writeable


def test_each_conclusion_has_a_reason() -> None:
    assert find_anatomy(body(FULL)).reasons == (
        "left leg: hip 'LeftUpLeg', knee 'LeftLeg', ankle 'LeftFoot', by their names",
        "right leg: hip 'RightUpLeg', knee 'RightLeg', ankle 'RightFoot', by their names",
        "left toe 'LeftToeBase', by its name",
        "right toe 'RightToeBase', by its name",
        "left arm: shoulder 'LeftArm', elbow 'LeftForeArm', wrist 'LeftHand', by their names",
        "right arm: shoulder 'RightArm', elbow 'RightForeArm', wrist 'RightHand', by their names",
        "head 'Head', by its name",
    )


def two_legs(left: str, right: str, rest: str = "") -> Skeleton:
    return body(f"Hips\n{left}\n{right}\n{rest}")


def chain(*names: str, side: float = 1.0, tip: str = "") -> str:
    offsets = [f"{0.1 * side} -.05 0", *["0 -.4 0"] * 2, "0 -.05 .12", "0 0 .05"]
    lines = [f"{'  ' * (level + 1)}{name} {offsets[level]}" for level, name in enumerate(names)]
    return "\n".join(lines) + tip


NAMINGS = (
    "LeftHip LeftKnee LeftAnkle LeftToe RightHip RightKnee RightAnkle RightToe",
    "lThigh lShin lFoot lToe rThigh rShin rFoot rToe",
    "upperleg.l lowerleg.l foot.l toes.l upperleg.r lowerleg.r foot.r toes.r",
    "thigh_l calf_l foot_l ball_l thigh_r calf_r foot_r ball_r",
    "L_Hip L_Knee L_Ankle L_Foot R_Hip R_Knee R_Ankle R_Foot",
    "lfemur ltibia lfoot ltoes rfemur rtibia rfoot rtoes",
    "LeftLeg LeftShin LeftFoot LeftToe RightLeg RightShin RightFoot RightToe",
    "left_1 left_2 left_3 left_4 right_1 right_2 right_3 right_4",
)


@pytest.mark.parametrize("naming", NAMINGS)
def test_legs_of_many_namings(naming: str) -> None:
    left, right = tuple(naming.split()[:4]), tuple(naming.split()[4:])
    skeleton = two_legs(chain(*left), chain(*right, side=-1.0))
    assert legs(skeleton, find_anatomy(skeleton)) == [left, right]


def test_without_a_toe_the_end_of_the_foot_is_the_toe() -> None:
    skeleton = two_legs(
        chain("LeftHip", "LeftKnee", "LeftAnkle", tip=" tip .01 -.04 .12"),
        chain("RightHip", "RightKnee", "RightAnkle", side=-1.0),
    )
    anatomy = find_anatomy(skeleton)
    assert anatomy.left.toe.joint == anatomy.left.ankle
    assert anatomy.left.toe.offset == (0.01, -0.04, 0.12)
    assert anatomy.right.toe == anatomy.right.heel
    assert anatomy.reasons[2:4] == (
        "left toe: the end of the bone of 'LeftAnkle', which has no toe",
        "right toe: the ankle 'RightAnkle', as nothing is known below it",
    )


def test_nameless_legs_are_the_mirrored_chains_nearest_the_root() -> None:
    skeleton = two_legs(
        chain("a1", "a2", "a3", "a4", side=-1.0),
        chain("b1", "b2", "b3", "b4"),
        "  c1 0 .2 0\n    d1 .1 .1 0\n      d2 .3 0 0\n        d3 .3 0 0\n          d4 .1 0 0\n"
        "    e1 -.1 .1 0\n      e2 -.3 0 0\n        e3 -.3 0 0\n          e4 -.1 0 0",
    )
    anatomy = find_anatomy(skeleton)
    assert legs(skeleton, anatomy) == [("b1", "b2", "b3", "b4"), ("a1", "a2", "a3", "a4")]
    assert anatomy.reasons[0] == (
        "left leg: hip 'b1', knee 'b2', ankle 'b3', by being the mirrored pair of chains nearest "
        "the root; left is the one at greater x"
    )


NO_FEET = (
    "no legs found: no joint is named like a left foot or ankle (such as LeftFoot or foot.l); "
    "no joint is named like a right foot or ankle (such as RightFoot or foot.r); "
)

REFUSED = (
    (
        "Shoulder\n  Elbow .3 0 0\n    Wrist .3 0 0",
        NO_FEET + "no two chains of three joints and equal lengths leave one joint; "
        "the joints are Shoulder, Elbow, Wrist",
    ),
    (
        "Hips\n  LeftFoot .1 0 0\n  RightFoot -.1 0 0",
        "no legs found: 'LeftFoot' is named like a left foot, but no joint above it is named like "
        "a knee or shank; 'RightFoot' is named like a right foot, but no joint above it is named "
        "like a knee or shank; no two chains of three joints and equal lengths leave one joint; "
        "the joints are Hips, LeftFoot, RightFoot",
    ),
    (
        "Hips\n  LeftLeg .1 0 0\n    LeftFoot 0 -.4 0\n  RightLeg -.1 0 0\n    RightFoot 0 -.4 0",
        "no legs found: 'LeftLeg' is named like a left knee or shank, but no joint above it can "
        "be the hip; 'RightLeg' is named like a right knee or shank, but no joint above it can be "
        "the hip; no two chains of three joints and equal lengths leave one joint; the joints are "
        "Hips, LeftLeg, LeftFoot, RightLeg, RightFoot",
    ),
    (
        "Hips\n  LeftUpLeg\n    LeftLeg 0 -.4 0\n      LeftFoot 0 -.4 0\n"
        "  RightUpLeg\n    RightLeg 0 -.2 0\n      RightFoot 0 -.4 0",
        "no legs found: the left thigh is 0.400 m and the right one 0.200 m; they may differ by "
        "30%; no two chains of three joints and equal lengths leave one joint; the joints are "
        "Hips, LeftUpLeg, LeftLeg, LeftFoot, RightUpLeg, RightLeg, RightFoot",
    ),
    (
        "a\n  b 0 0 .1\n    c 0 -.4 0\n      d 0 -.4 0\n"
        "  e 0 0 -.1\n    f 0 -.4 0\n      g 0 -.4 0",
        NO_FEET + "'b' and 'e' begin a pair of equal chains, but which is left cannot be told; "
        "the joints are a, b, c, d, e, f, g",
    ),
)


FEET_ON_THE_ROOT = """Bone
  Foot.L .1 .1 0
  Body 0 .9 0
    Torso 0 .4 0
      UpperArm.L .2 0 0
        LowerArm.L .3 0 0
          Palm.L .3 0 0
      UpperArm.R -.2 0 0
        LowerArm.R -.3 0 0
          Palm.R -.3 0 0
    UpperLeg.L .1 0 0
      LowerLeg.L 0 -.4 0
    UpperLeg.R -.1 0 0
      LowerLeg.R 0 -.4 0
  Foot.R -.1 .1 0
"""
"""Shanks that end in the air: the feet are what an animator's legs reach for."""


def test_feet_that_legs_reach_for_are_told_and_arms_not_taken_for_legs() -> None:
    with pytest.raises(SkeletonError) as refusal:
        find_anatomy(body(FEET_ON_THE_ROOT))
    assert str(refusal.value) == (
        "no legs found: 'Foot.L' and 'Foot.R' look like the feet, but hang on 'Bone' for the legs "
        "to reach for, not on the shanks 'LowerLeg.L' and 'LowerLeg.R', so that no chain of joints "
        "leads from a hip to a foot; make them children of the shanks where the file was made; "
        "the joints are Bone, Foot.L, Body, Torso, UpperArm.L, LowerArm.L, Palm.L, UpperArm.R, "
        "LowerArm.R, Palm.R, UpperLeg.L, LowerLeg.L, ..."
    )


@pytest.mark.parametrize(("text", "message"), REFUSED)
def test_a_body_without_two_legs_is_refused(text: str, message: str) -> None:
    with pytest.raises(SkeletonError) as refusal:
        find_anatomy(body(text))
    assert str(refusal.value) == message


def real_clips() -> list[dict[str, Any]]:
    manifest = MOTIONS / "manifest.json"
    if not manifest.exists():
        return []
    records: list[dict[str, Any]] = json.loads(manifest.read_text())["clips"]
    return [
        record
        for record in records
        if record["file"].endswith(".bvh.gz")
        and record.get("feet")
        and not record["file"].startswith("problems/")
    ]


CLIPS = {
    tuple(sorted(record["feet"]["L"].items())): record
    for record in sorted(real_clips(), key=lambda record: -record["bytes"])
}
"""The smallest clip of each naming of the legs."""


@pytest.mark.skipif(not CLIPS, reason="the folder ../shared/motions is missing")
@pytest.mark.parametrize("record", CLIPS.values(), ids=lambda record: record["file"])
def test_the_legs_of_real_clips(record: dict[str, Any]) -> None:
    skeleton = load(MOTIONS / record["file"]).skeleton
    found = legs(skeleton, find_anatomy(skeleton))
    assert [dict(zip(("hip", "knee", "ankle", "toe"), leg, strict=True)) for leg in found] == [
        record["feet"][side] for side in "LR"
    ]
