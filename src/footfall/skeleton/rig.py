"""A skeleton and its anatomy as plain arrays, for the kernels."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from footfall.arrays import Indices, Positions, SmallFloats
from footfall.octets import LANES
from footfall.skeleton.anatomy import Anatomy, BodyPart, Leg
from footfall.skeleton.skeleton import Skeleton

__all__ = ["FOOT", "SHANK", "THIGH", "Rig", "rig_of"]

THIGH, SHANK, FOOT = 1, 2, 3
"""Values of `Rig.leg_segments`."""


class Rig(NamedTuple):
    """A skeleton and its anatomy as the kernels take them. Feet are in the order left, right."""

    parents: Indices
    """Parent of each joint, shape (joints,)."""

    rest_offsets: Positions
    """Joint in its parent's frame [m], shape (joints, 3)."""

    parts: Indices
    """`BodyPart` of each joint, shape (joints,)."""

    part_masks: SmallFloats
    """1 where a joint belongs to a body part, the feet with the legs, else 0, shape
    (parts, rotations of a pose by component)."""

    limbs: Indices
    """Hip, knee and ankle of each leg, shape (2, 3)."""

    leg_sides: Indices
    """0 or 1 for a joint of the left or right leg, else -1, shape (joints,)."""

    leg_segments: Indices
    """What a leg's joint moves with: thigh 1, shank 2, foot 3; else 0, shape (joints,)."""

    foot_points: Positions
    """Heel and toe in the ankle's frame [m], shape (2 feet, 2 points, 3)."""

    leg_length: float
    """Thigh and shank together, mean of both legs [m]."""


def rig_of(skeleton: Skeleton, anatomy: Anatomy) -> Rig:
    """Pack a skeleton and its anatomy for the kernels."""
    sides = np.full(skeleton.count, -1, dtype=np.int64)
    segments = np.zeros(skeleton.count, dtype=np.int64)
    for side, leg in enumerate(anatomy.legs):
        for joint in range(skeleton.count):
            parent = int(skeleton.parents[joint])
            if joint == leg.hip:
                segment = THIGH
            elif parent < 0 or sides[parent] != side:
                continue
            elif joint == leg.knee:
                segment = SHANK
            else:
                segment = FOOT if joint == leg.ankle else int(segments[parent])
            sides[joint], segments[joint] = side, segment
    lengths = [_chain_length(skeleton, leg.hip, leg.ankle) for leg in anatomy.legs]
    return Rig(
        parents=np.array(skeleton.parents),
        rest_offsets=np.array(skeleton.rest_offsets),
        parts=np.array(anatomy.parts, dtype=np.int64),
        part_masks=_part_masks([int(part) for part in anatomy.parts]),
        limbs=np.array([[leg.hip, leg.knee, leg.ankle] for leg in anatomy.legs], dtype=np.int64),
        leg_sides=sides,
        leg_segments=segments,
        foot_points=np.array([_foot_points(skeleton, leg) for leg in anatomy.legs]),
        leg_length=float(np.mean(lengths)),
    )


def _part_masks(parts: Sequence[int]) -> SmallFloats:
    rotations = [*parts, int(BodyPart.LEGS), int(BodyPart.LEGS)]
    masks = np.zeros((len(BodyPart), -(-len(rotations) // LANES) * LANES), dtype=np.float32)
    masks[rotations, np.arange(len(rotations))] = 1.0
    return masks


def _chain_length(skeleton: Skeleton, start: int, end: int) -> float:
    length = 0.0
    joint = end
    while joint != start:
        length += skeleton.bone_length(joint)
        joint = int(skeleton.parents[joint])
    return length


def _foot_points(skeleton: Skeleton, leg: Leg) -> Positions:
    """Return heel and toe in the ankle's frame, the foot's own joints at rest [m], (2, 3)."""
    points = np.zeros((2, 3))
    for row, point in enumerate((leg.heel, leg.toe)):
        joint = point.joint
        points[row] = point.offset
        while joint != leg.ankle:
            points[row] += skeleton.rest_offsets[joint]
            joint = int(skeleton.parents[joint])
    return points
