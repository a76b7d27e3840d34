"""The joints that two bodies have in common, whatever they are called and however many there are.

A body is a column (pelvis, spine, chest, neck, head) with two legs and two arms. What is no
landmark (twist joints, helpers, fingers) moves with the landmark above it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Indices, Positions
from footfall.skeleton.anatomy import Anatomy
from footfall.skeleton.anatomy_search import find_anatomy
from footfall.skeleton.joint_names import Role, read_joint_name
from footfall.skeleton.leg_search import SIDES, ancestors
from footfall.skeleton.skeleton import Skeleton

__all__ = ["Landmarks", "find_landmarks", "landmark_sentences", "rest_positions"]


@dataclass(frozen=True, eq=False)
class Landmarks:
    """What the joints of a body are, from the pelvis to the toes and to the hands."""

    anatomy: Anatomy
    """Legs, arms and head as they were found."""

    pelvis: int
    """The lowest joint that carries both legs."""

    trunk: tuple[int, ...]
    """The joints from the pelvis up to the chest, both included."""

    neck: tuple[int, ...]
    """The joints between chest and head; empty where the head sits on the chest."""

    head: int | None
    """The joint at the lower end of the skull; None where there is none."""

    clavicles: tuple[int | None, int | None]
    """The joint between the column and each shoulder; None where there is none."""

    toes: tuple[int | None, int | None]
    """The toe joint of each foot; None where a foot has none."""

    @property
    def chest(self) -> int:
        """The uppermost joint of the trunk."""
        return self.trunk[-1]


def find_landmarks(skeleton: Skeleton, anatomy: Anatomy) -> Landmarks:
    """Return the landmarks of a body.

    Args:
        skeleton: The body.
        anatomy: Its legs, arms and head.
    """
    left, right = anatomy.legs
    pelvis = _meeting(skeleton, left.hip, right.hip)
    head = anatomy.head if anatomy.head is not None else _last_neck(skeleton)
    chest = _chest(skeleton, anatomy, pelvis, head)
    trunk = _path(skeleton, pelvis, chest)
    neck: tuple[int, ...] = ()
    if head is not None and chest in ancestors(skeleton, head):
        neck = _path(skeleton, chest, head)[1:-1]
    column = {*trunk, *neck}
    clavicles = tuple(
        None if arm is None else _clavicle(skeleton, arm.shoulder, column) for arm in anatomy.arms
    )
    toes = tuple(None if leg.toe.joint == leg.ankle else leg.toe.joint for leg in anatomy.legs)
    return Landmarks(
        anatomy, pelvis, trunk, neck, head, (clavicles[0], clavicles[1]), (toes[0], toes[1])
    )


def landmark_sentences(skeleton: Skeleton) -> tuple[tuple[str, str], ...]:
    """Return what each landmark of a body is, by name, and then why.

    This is what other bodies' motions are mapped by; see `footfall.skeleton.correspondence`.

    Raises:
        SkeletonError: If no two legs are found; the message says what was looked for.
    """
    anatomy = find_anatomy(skeleton)
    marks = find_landmarks(skeleton, anatomy)
    sentences = [
        ("pelvis", _named(skeleton, marks.pelvis) + ", the lowest joint that carries both legs"),
        ("trunk", ", ".join(_named(skeleton, joint) for joint in marks.trunk)),
        ("neck", ", ".join(_named(skeleton, joint) for joint in marks.neck) or "none"),
        ("head", _named(skeleton, marks.head)),
    ]
    for side, word in enumerate(SIDES):
        sentences.append((f"{word} clavicle", _named(skeleton, marks.clavicles[side])))
        arm, leg = anatomy.arms[side], anatomy.legs[side]
        joints = (None,) if arm is None else (arm.shoulder, arm.elbow, arm.wrist)
        sentences.append((f"{word} arm", ", ".join(_named(skeleton, joint) for joint in joints)))
        joints = (leg.hip, leg.knee, leg.ankle)
        sentences.append((f"{word} leg", ", ".join(_named(skeleton, joint) for joint in joints)))
        sentences.append((f"{word} toes", _named(skeleton, marks.toes[side])))
    return (*sentences, *(("because", reason) for reason in anatomy.reasons))


def _named(skeleton: Skeleton, joint: int | None) -> str:
    return "none" if joint is None else repr(skeleton.names[joint])


def rest_positions(skeleton: Skeleton) -> Positions:
    """Return where the joints are at rest, joint 0 at the origin [m], shape (joints, 3)."""
    positions = np.zeros((skeleton.count, 3))
    parents: Indices = skeleton.parents
    for joint in range(1, skeleton.count):
        positions[joint] = positions[parents[joint]] + skeleton.rest_offsets[joint]
    return positions


def _meeting(skeleton: Skeleton, one: int, other: int) -> int:
    """Return the lowest joint above both of two joints, or joint 0."""
    above = set(ancestors(skeleton, other))
    return next((joint for joint in ancestors(skeleton, one) if joint in above), 0)


def _path(skeleton: Skeleton, upper: int, lower: int) -> tuple[int, ...]:
    """Return the joints from one to another; where they are on two branches, past the fork."""
    if upper == lower:
        return (upper,)
    above = ancestors(skeleton, lower)
    stop = above.index(upper) if upper in above else above.index(_meeting(skeleton, upper, lower))
    return (upper, *reversed(above[:stop]), lower)


def _last_neck(skeleton: Skeleton) -> int | None:
    """Return the joint named neck that is farthest from the root: a neck without a head."""
    necks = [j for j, name in enumerate(skeleton.names) if read_joint_name(name).role is Role.NECK]
    return max(necks, key=lambda joint: len(ancestors(skeleton, joint)), default=None)


def _chest(skeleton: Skeleton, anatomy: Anatomy, pelvis: int, head: int | None) -> int:
    """Return the uppermost joint of the trunk.

    It carries both arms. Where a neck does that, its nodding is not the trunk's, and the chest is
    the joint below. Without arms it is what carries the neck.
    """
    left, right = anatomy.arms
    if left is not None and right is not None:
        chest = _meeting(skeleton, left.shoulder, right.shoulder)
    elif head is not None:
        chest = head
    else:
        return pelvis
    above = set(ancestors(skeleton, pelvis))
    while chest != pelvis and (chest == head or _is_neck(skeleton, chest)):
        parent = int(skeleton.parents[chest])
        if parent < 0 or parent in above:
            return pelvis
        chest = parent
    return pelvis if chest in above else chest


def _is_neck(skeleton: Skeleton, joint: int) -> bool:
    return read_joint_name(skeleton.names[joint]).role is Role.NECK


def _clavicle(skeleton: Skeleton, shoulder: int, column: set[int]) -> int | None:
    """Return the joint with the longest bone between the column and a shoulder, or None."""
    lengths: list[tuple[float, int]] = []
    below = shoulder
    for joint in ancestors(skeleton, shoulder):
        if joint in column:
            break
        lengths.append((skeleton.bone_length(below), joint))
        below = joint
    return max(lengths)[1] if lengths and below != shoulder else None
