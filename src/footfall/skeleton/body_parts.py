"""Arms, head and chest, and the part of the body that each joint belongs to."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Indices, frozen
from footfall.skeleton.anatomy import Arm, BodyPart
from footfall.skeleton.joint_names import JointName, Role
from footfall.skeleton.leg_search import SIDES, LegJoints, ancestors
from footfall.skeleton.skeleton import Skeleton

__all__ = ["assign_parts", "find_arms", "find_chest", "find_head"]


def find_arms(
    skeleton: Skeleton, names: tuple[JointName, ...]
) -> tuple[tuple[Arm | None, Arm | None], list[str]]:
    """Return the left and the right arm as far as names tell of them, and why."""
    arms = (_named_arm(skeleton, names, 0), _named_arm(skeleton, names, 1))
    reasons: list[str] = []
    for side, arm in zip(SIDES, arms, strict=True):
        if arm is None:
            reasons.append(f"{side} arm: none, no hand below a forearm is named so")
        else:
            joints = (arm.shoulder, arm.elbow, arm.wrist)
            shoulder, elbow, wrist = (skeleton.names[joint] for joint in joints)
            reasons.append(
                f"{side} arm: shoulder {shoulder!r}, elbow {elbow!r}, wrist {wrist!r}, "
                "by their names"
            )
    return arms, reasons


def _named_arm(skeleton: Skeleton, names: tuple[JointName, ...], side: int) -> Arm | None:
    """Return the arm that ends in the hand nearest the root, climbing from it."""
    hands = [
        (len(ancestors(skeleton, joint)), joint)
        for joint, name in enumerate(names)
        if name.side == side and name.role is Role.HAND
    ]
    for _, wrist in sorted(hands):
        above = [joint for joint in ancestors(skeleton, wrist) if names[joint].side == side]
        elbow = next((joint for joint in above if names[joint].role is Role.FOREARM), None)
        if elbow is None:
            continue
        upper = above[above.index(elbow) + 1 :]
        shoulder = next((joint for joint in upper if names[joint].role is Role.UPPER_ARM), None)
        if shoulder is not None:
            return Arm(shoulder, elbow, wrist)
    return None


def find_head(skeleton: Skeleton, names: tuple[JointName, ...]) -> int | None:
    """Return the joint named head that is nearest the root, or None."""
    heads = [
        (len(ancestors(skeleton, joint)), joint)
        for joint, name in enumerate(names)
        if name.side is None and name.role is Role.HEAD
    ]
    return min(heads)[1] if heads else None


def find_chest(skeleton: Skeleton, arms: tuple[Arm | None, Arm | None]) -> int | None:
    """Return the lowest joint that carries both arms, or None."""
    left, right = arms
    if left is None or right is None:
        return None
    carriers = set(ancestors(skeleton, right.shoulder))
    return next((j for j in ancestors(skeleton, left.shoulder) if j in carriers), None)


def assign_parts(
    skeleton: Skeleton,
    names: tuple[JointName, ...],
    legs: tuple[LegJoints, LegJoints],
    arms: tuple[Arm | None, Arm | None],
    head: int | None,
) -> Indices:
    """Return the `BodyPart` of each joint, shape (joints,).

    A joint that carries one limb belongs to that limb, one that carries several to the trunk, one
    that carries both legs to the legs, and one that carries none goes with its parent.
    """
    landmarks: dict[int, BodyPart] = {legs[0].hip: BodyPart.LEGS, legs[1].hip: BodyPart.LEGS}
    for arm, part in zip(arms, (BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM), strict=True):
        if arm is not None:
            landmarks[arm.shoulder] = part
    if head is not None:
        landmarks[head] = BodyPart.HEAD
    carried: list[set[BodyPart]] = [set[BodyPart]() for _ in names]
    for landmark, part in landmarks.items():
        for joint in (landmark, *ancestors(skeleton, landmark)):
            carried[joint].add(part)
    parts = np.full(skeleton.count, BodyPart.LEGS, dtype=np.int64)
    for joint in range(1, skeleton.count):
        parent = int(skeleton.parents[joint])
        parts[joint] = _part(
            names[joint], BodyPart(int(parts[parent])), carried[joint], carried[parent]
        )
    return frozen(parts, np.int64)


def _part(
    name: JointName, parent: BodyPart, carried: set[BodyPart], siblings: set[BodyPart]
) -> BodyPart:
    """Return the part of a joint, from its name, its parent, and what both carry."""
    if BodyPart.LEGS in carried:
        return BodyPart.LEGS
    if len(carried) > 1:
        return BodyPart.TRUNK
    if carried == {BodyPart.HEAD}:
        beside_arms = bool(siblings & {BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM})
        named = name.role in (Role.NECK, Role.HEAD)
        return BodyPart.HEAD if named or beside_arms or parent is BodyPart.HEAD else BodyPart.TRUNK
    if carried:
        return next(iter(carried))
    if parent is BodyPart.TRUNK and name.side is not None:
        return (BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM)[name.side]
    return parent
