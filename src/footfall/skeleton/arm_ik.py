"""An arm that reaches for a point after the blend: the analytic limb, on arrays of joints.

The hand keeps its attitude, the elbow the plane it is in; what hangs on the arm goes with it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from footfall.arrays import Indices, Positions, Rotations
from footfall.compilation import kernel
from footfall.skeleton.anatomy import Anatomy, Arm
from footfall.skeleton.skeleton import Skeleton
from footfall.skeleton.two_bone_ik import Vector, reach_point, turn_about

__all__ = ["BEND", "ArmRig", "arm_rig_of", "reach_end", "reach_wrist"]

UPPER, LOWER, HAND = 1, 2, 3
"""Values of `ArmRig.segments`."""

BEND = (0.0, -1.0, -0.5)
"""Where the elbow of a straight arm goes when it bends, in a frame that faces +z: down and
back."""


class ArmRig(NamedTuple):
    """The arms of a body as the kernels take them, in the order left, right."""

    limbs: Indices
    """Shoulder, elbow and wrist of each arm, -1 where there is none, shape (2, 3)."""

    sides: Indices
    """0 or 1 for a joint of the left or right arm, else -1, shape (joints,)."""

    segments: Indices
    """What an arm's joint moves with: upper arm 1, forearm 2, hand 3; else 0, shape (joints,)."""


def arm_rig_of(skeleton: Skeleton, anatomy: Anatomy) -> ArmRig:
    """Pack the arms of a body for the kernels."""
    sides = np.full(skeleton.count, -1, dtype=np.int64)
    segments = np.zeros(skeleton.count, dtype=np.int64)
    limbs = np.full((2, 3), -1, dtype=np.int64)
    for side, arm in enumerate(anatomy.arms):
        if arm is not None:
            limbs[side] = arm.shoulder, arm.elbow, arm.wrist
            _mark(skeleton, arm, side, sides, segments)
    return ArmRig(limbs, sides, segments)


def _mark(skeleton: Skeleton, arm: Arm, side: int, sides: Indices, segments: Indices) -> None:
    own = {arm.shoulder: UPPER, arm.elbow: LOWER, arm.wrist: HAND}
    for joint in range(arm.shoulder, skeleton.count):
        parent = int(skeleton.parents[joint])
        if joint == arm.shoulder or (parent >= arm.shoulder and sides[parent] == side):
            sides[joint] = side
            segments[joint] = own.get(joint, int(segments[parent]))


@kernel
def reach_wrist(
    arms: ArmRig,
    side: int,
    target: Vector,
    weight: float,
    rotations: Rotations,
    positions: Positions,
) -> float:
    """Turn one arm of a body that faces +z so that its wrist goes towards a target.

    Arguments and what is returned as of `reach_end`.
    """
    return reach_end(arms, side, target, weight, BEND, rotations, positions)


@kernel
def reach_end(
    limbs: ArmRig,
    side: int,
    target: Vector,
    weight: float,
    bend: Vector,
    rotations: Rotations,
    positions: Positions,
) -> float:
    """Turn one limb so that its end goes towards a target; hand or foot keeps its attitude.

    A target out of reach is approached softly. An arm that is not there stays away.

    Args:
        limbs: The arms of the body, or its legs packed alike.
        side: 0 for the left one, 1 for the right one.
        target: Where the end should be, in the frame of the positions [m].
        weight: How much of the way it goes, 0 to 1.
        bend: Where the middle of a straight limb goes when it bends.
        rotations: All joints, shape (joints, 4); the limb's are rewritten.
        positions: All joints [m], shape (joints, 3); likewise.

    Returns:
        How far the end then is from where the weight would have it [m].
    """
    shoulder, elbow, wrist = limbs.limbs[side, 0], limbs.limbs[side, 1], limbs.limbs[side, 2]
    if shoulder < 0 or weight <= 0.0:
        return 0.0
    old = (positions[wrist, 0], positions[wrist, 1], positions[wrist, 2])
    goal = (
        old[0] + weight * (target[0] - old[0]),
        old[1] + weight * (target[1] - old[1]),
        old[2] + weight * (target[2] - old[2]),
    )
    start = (positions[shoulder, 0], positions[shoulder, 1], positions[shoulder, 2])
    middle = (positions[elbow, 0], positions[elbow, 1], positions[elbow, 2])
    upper, lower, bent, end = reach_point(start, middle, old, goal, bend)
    for joint in range(shoulder, limbs.sides.shape[0]):
        if limbs.sides[joint] != side:
            continue
        if limbs.segments[joint] == UPPER:
            turn_about(joint, upper, start, start, rotations, positions)
        elif limbs.segments[joint] == LOWER:
            turn_about(joint, lower, middle, bent, rotations, positions)
        else:
            for axis in range(3):
                positions[joint, axis] += end[axis] - old[axis]
    return math.sqrt((end[0] - goal[0]) ** 2 + (end[1] - goal[1]) ** 2 + (end[2] - goal[2]) ** 2)
