from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

from footfall.errors import SkeletonError, UnknownNameError
from footfall.skeleton import Skeleton

NAMES = ("Hips", "Thigh", "Shank", "Spine")
PARENTS = np.array([-1, 0, 1, 0])
OFFSETS = np.array([[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, -0.3, 0.4], [0.0, 0.2, 0.0]])


def skeleton(
    names: tuple[str, ...] = NAMES, parents: object = PARENTS, offsets: object = OFFSETS
) -> Skeleton:
    return Skeleton(names, np.array(parents), np.array(offsets))


def test_joints_are_found_by_name() -> None:
    body = skeleton()
    assert body.count == 4
    assert [body.index(name) for name in NAMES] == [0, 1, 2, 3]


def test_an_unknown_joint_is_answered_with_those_there_are() -> None:
    with pytest.raises(UnknownNameError) as caught:
        skeleton().index("Shnak")
    assert str(caught.value) == "no joint named 'Shnak'; there are: Hips, Thigh, Shank, Spine"


def test_children_stand_in_order() -> None:
    body = skeleton()
    assert [body.children(joint) for joint in range(4)] == [(1, 3), (2,), (), ()]


def test_a_bone_is_as_long_as_its_offset() -> None:
    assert [skeleton().bone_length(joint) for joint in range(4)] == [0.0, 0.1, 0.5, 0.2]


def test_a_family_shares_names_and_parents_not_lengths() -> None:
    body = skeleton()
    assert body.same_family(skeleton(offsets=2.0 * OFFSETS))
    assert not body.same_family(skeleton(names=("Hips", "Thigh", "Shank", "Neck")))
    assert not body.same_family(skeleton(parents=[-1, 0, 1, 1]))


def test_bones_that_are_not_known_to_end_anywhere_end_at_their_joint() -> None:
    assert skeleton().tip_offsets.tolist() == np.zeros((4, 3)).tolist()


def test_what_a_skeleton_holds_cannot_be_changed() -> None:
    offsets = OFFSETS.copy()
    body = skeleton(offsets=offsets)
    offsets[1] = 9.0
    np.testing.assert_array_equal(body.rest_offsets, OFFSETS)
    for array in (body.parents, body.rest_offsets, body.tip_offsets):
        assert not array.flags.writeable
    with pytest.raises(dataclasses.FrozenInstanceError):
        body.names = ()  # pyright: ignore[reportAttributeAccessIssue]


def test_a_single_joint_is_a_body() -> None:
    assert Skeleton(("Hips",), np.array([-1]), np.zeros((1, 3))).children(0) == ()


def with_number(number: float) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    offsets = OFFSETS.copy()
    offsets[2, 1] = number
    return offsets


@pytest.mark.parametrize(
    ("names", "parents", "offsets", "message"),
    [
        ((), np.zeros(0), np.zeros((0, 3)), "a skeleton needs at least one joint"),
        (NAMES, PARENTS[:3], OFFSETS, "4 joint names but parents of shape (3,)"),
        (
            NAMES,
            PARENTS,
            OFFSETS[:, :2],
            "rest_offsets has shape (4, 2); 4 joints need (4, 3)",
        ),
        (NAMES, PARENTS, with_number(math.nan), "rest_offsets of joint 'Shank' is not finite"),
        (NAMES, PARENTS, with_number(-math.inf), "rest_offsets of joint 'Shank' is not finite"),
        (
            ("Hips", "Thigh", "Hips", "Spine"),
            PARENTS,
            OFFSETS,
            "two joints are named 'Hips'; names must differ",
        ),
        (NAMES, [0, 0, 1, 0], OFFSETS, "joint 0 has parent 0; the pelvis has parent -1"),
        (
            NAMES,
            [-1, 0, 2, 0],
            OFFSETS,
            "joint 2 ('Shank') has parent 2; a parent must stand before its child, so within 0..1",
        ),
        (
            NAMES,
            [-1, 0, 1, -1],
            OFFSETS,
            "joint 3 ('Spine') has parent -1; a parent must stand before its child, so within 0..2",
        ),
    ],
)
def test_impossible_bodies_are_refused(
    names: tuple[str, ...], parents: object, offsets: object, message: str
) -> None:
    with pytest.raises(SkeletonError) as caught:
        skeleton(names, parents, offsets)
    assert str(caught.value) == message


def test_tips_are_checked_like_joints() -> None:
    with pytest.raises(SkeletonError) as caught:
        Skeleton(NAMES, PARENTS, OFFSETS, np.zeros((2, 3)))
    assert str(caught.value) == "tip_offsets has shape (2, 3); 4 joints need (4, 3)"
