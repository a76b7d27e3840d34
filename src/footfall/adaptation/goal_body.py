"""What of a body meets goals: arms, legs, neck and head, packed for the kernels."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from footfall.arrays import Indices, Positions
from footfall.geometry import conjugate, rotate
from footfall.skeleton import Anatomy, Skeleton
from footfall.skeleton.arm_ik import ArmRig, arm_rig_of
from footfall.skeleton.canonical_pose import canonical_rotations
from footfall.skeleton.landmarks import find_landmarks
from footfall.skeleton.leg_search import descendants

__all__ = ["GoalBody", "goal_body_of"]


class GoalBody(NamedTuple):
    """What of a body meets goals."""

    arms: ArmRig
    """Its arms."""

    legs: ArmRig
    """Its legs, likewise."""

    chest: int
    """The joint that the head turns against."""

    neck: int
    """The joint of the neck, or -1."""

    head: int
    """The joint of the head, or -1."""

    carried: Indices
    """2 for what moves with the head, 1 for what else moves with the neck, else 0, (joints,)."""

    forward: Positions
    """Where chest and head face, in their own frames: unit vectors, shape (2, 3)."""


def goal_body_of(skeleton: Skeleton, anatomy: Anatomy) -> GoalBody:
    """Pack what of a body meets goals."""
    marks = find_landmarks(skeleton, anatomy)
    canonical = canonical_rotations(skeleton, marks)
    head = -1 if marks.head is None else marks.head
    neck = marks.neck[0] if marks.neck else -1
    carried = np.zeros(skeleton.count, dtype=np.int64)
    for joint, mark in ((neck, 1), (head, 2)):
        if joint >= 0:
            carried[[joint, *descendants(skeleton, joint)]] = mark
    ahead = np.array([0.0, 0.0, 1.0])
    faces = [marks.chest, max(head, 0)]
    return GoalBody(
        arms=arm_rig_of(skeleton, anatomy),
        legs=_leg_rig(skeleton, anatomy),
        chest=marks.chest,
        neck=neck,
        head=head,
        carried=carried,
        forward=rotate(conjugate(canonical[faces]), ahead),
    )


def _leg_rig(skeleton: Skeleton, anatomy: Anatomy) -> ArmRig:
    """Return the legs as if they were arms: hip, knee and ankle."""
    sides = np.full(skeleton.count, -1, dtype=np.int64)
    segments = np.zeros(skeleton.count, dtype=np.int64)
    limbs = np.array([[leg.hip, leg.knee, leg.ankle] for leg in anatomy.legs], dtype=np.int64)
    for side in range(2):
        own = {int(joint): place + 1 for place, joint in enumerate(limbs[side])}
        for joint in [int(limbs[side, 0]), *sorted(descendants(skeleton, int(limbs[side, 0])))]:
            sides[joint] = side
            segments[joint] = own.get(joint, int(segments[skeleton.parents[joint]]))
    return ArmRig(limbs, sides, segments)
