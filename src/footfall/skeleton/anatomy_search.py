"""Find out what the joints of a skeleton are, and say why."""

from __future__ import annotations

from footfall.skeleton.anatomy import Anatomy, FootPoint, Leg, leg_length
from footfall.skeleton.body_parts import assign_parts, find_arms, find_chest, find_head
from footfall.skeleton.joint_names import JointName, Role, read_joint_names
from footfall.skeleton.leg_search import SIDES, LegJoints, descendants, find_legs
from footfall.skeleton.skeleton import Skeleton

__all__ = ["find_anatomy"]

SHORTEST_FOOT = 0.03
"""A toe nearer to the ankle than this share of the leg's length is a helper on the ankle."""

_NO_OFFSET = (0.0, 0.0, 0.0)


def find_anatomy(skeleton: Skeleton) -> Anatomy:
    """Find legs, arms and head of a body, from the joints' names, tree and bone lengths.

    Legs are needed; arms, head and chest are given where they are found. Rest directions are not
    trusted: in many files the rest pose does not stand.

    Args:
        skeleton: The body.

    Returns:
        What the joints are, with one sentence for each conclusion.

    Raises:
        SkeletonError: If no two legs can be found; the message says what was looked for.
    """
    names = read_joint_names(skeleton)
    legs, reasons = find_legs(skeleton, names)
    full_legs: list[Leg] = []
    for side, joints in zip(SIDES, legs, strict=True):
        leg, reason = _with_foot(skeleton, names, joints, side)
        full_legs.append(leg)
        reasons.append(reason)
    arms, arm_reasons = find_arms(skeleton, names)
    reasons += arm_reasons
    head = find_head(skeleton, names)
    reasons.append(
        "head: none, no joint is named so"
        if head is None
        else f"head {skeleton.names[head]!r}, by its name"
    )
    return Anatomy(
        left=full_legs[0],
        right=full_legs[1],
        parts=assign_parts(skeleton, names, legs, arms, head),
        reasons=tuple(reasons),
        arms=arms,
        head=head,
        chest=find_chest(skeleton, arms),
    )


def _with_foot(
    skeleton: Skeleton, names: tuple[JointName, ...], joints: LegJoints, side: str
) -> tuple[Leg, str]:
    """Return a leg with its foot points, and why the toe is where it is."""
    hip, knee, ankle = joints.hip, joints.knee, joints.ankle
    heel = FootPoint(ankle, _NO_OFFSET)
    shortest = SHORTEST_FOOT * leg_length(skeleton, Leg(hip, knee, ankle, heel, heel))
    below = [
        joint for joint in descendants(skeleton, ankle) if skeleton.bone_length(joint) > shortest
    ]
    named = [joint for joint in below if names[joint].role is Role.TOE]
    tip = skeleton.tip_offsets[ankle]
    if named or below:
        joint = named[0] if named else below[0]
        toe = FootPoint(joint, _NO_OFFSET)
        how = "by its name" if named else "by being the first joint below the ankle"
        reason = f"{side} toe {skeleton.names[joint]!r}, {how}"
    elif float(tip @ tip) > shortest**2:
        toe = FootPoint(ankle, (float(tip[0]), float(tip[1]), float(tip[2])))
        reason = f"{side} toe: the end of the bone of {skeleton.names[ankle]!r}, which has no toe"
    else:
        toe = heel
        reason = f"{side} toe: the ankle {skeleton.names[ankle]!r}, as nothing is known below it"
    return Leg(hip, knee, ankle, heel, toe), reason
