from __future__ import annotations

import numpy as np
import pytest

from footfall.samples import sample_skeleton
from footfall.samples.body import ANKLE_HEIGHT, BALL_HEIGHT
from footfall.skeleton import find_anatomy, world_poses


def test_the_body_at_rest_is_a_person_of_a_meter_seventy_five_on_flat_feet() -> None:
    skeleton = sample_skeleton()
    still = np.tile([1.0, 0.0, 0.0, 0.0], (1, skeleton.count, 1))
    positions = world_poses(skeleton, np.zeros((1, 3)), still)[1][0]
    ground = positions[skeleton.index("LeftFoot"), 1] - ANKLE_HEIGHT
    head = skeleton.index("Head")
    assert positions[head, 1] + skeleton.tip_offsets[head, 1] - ground == pytest.approx(
        1.75, abs=0.01
    )
    assert positions[skeleton.index("RightToeBase"), 1] - ground == pytest.approx(BALL_HEIGHT)


def test_left_and_right_mirror_each_other() -> None:
    skeleton = sample_skeleton()
    for joint, name in enumerate(skeleton.names):
        if name.startswith("Left"):
            other = skeleton.index(name.replace("Left", "Right"))
            mirrored = skeleton.rest_offsets[joint] * [-1.0, 1.0, 1.0]
            assert skeleton.rest_offsets[other].tolist() == mirrored.tolist()


def test_joints_are_in_depth_first_order() -> None:
    skeleton = sample_skeleton()
    order: list[int] = []

    def visit(joint: int) -> None:
        order.append(joint)
        for child in skeleton.children(joint):
            visit(child)

    visit(0)
    assert order == list(range(skeleton.count))


def test_legs_and_arms_are_found_by_their_names() -> None:
    skeleton = sample_skeleton()
    anatomy = find_anatomy(skeleton)
    found = [skeleton.names[i] for leg in anatomy.legs for i in (leg.hip, leg.knee, leg.ankle)]
    assert found == ["LeftUpLeg", "LeftLeg", "LeftFoot", "RightUpLeg", "RightLeg", "RightFoot"]
    assert [skeleton.names[leg.toe.joint] for leg in anatomy.legs] == [
        "LeftToeBase",
        "RightToeBase",
    ]
