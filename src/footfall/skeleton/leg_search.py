"""Find two legs: by the joints' names, or else by two mirrored chains at the body's root.

A rest pose need not be a standing one (in many files every bone points along x), so heights and
directions say nothing here: who is whose child does, and how long the bones are.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from footfall.errors import SkeletonError
from footfall.skeleton.joint_names import JointName, Role
from footfall.skeleton.loose_feet import loose_feet
from footfall.skeleton.skeleton import Skeleton

__all__ = ["LegJoints", "ancestors", "descendants", "find_legs"]

SIDES = ("left", "right")

SHORTEST_BONE = 0.2
"""A bone shorter than this share of its chain's longest is a helper: thigh and shank are within a
factor of two of each other, hip mounts and twist joints are not."""

ARM_ROLES = (Role.UPPER_ARM, Role.FOREARM, Role.HAND)

GREATEST_DIFFERENCE = 0.3
"""Greatest difference of the two thighs, or shanks, as a share of the longer one. Measured bodies
differ by 6 %; more than this, and the pair is not one body's."""


@dataclass(frozen=True, slots=True)
class LegJoints:
    """A leg without its foot points, and why it is one."""

    hip: int
    knee: int
    ankle: int
    reason: str


def ancestors(skeleton: Skeleton, joint: int) -> list[int]:
    """Return a joint's ancestors, the nearest first."""
    found: list[int] = []
    while (joint := int(skeleton.parents[joint])) >= 0:
        found.append(joint)
    return found


def descendants(skeleton: Skeleton, joint: int) -> list[int]:
    """Return the joints below a joint, the nearest levels first."""
    found: list[int] = []
    level = [joint]
    while level := [child for parent in level for child in skeleton.children(parent)]:
        found.extend(level)
    return found


def find_legs(
    skeleton: Skeleton, names: tuple[JointName, ...]
) -> tuple[tuple[LegJoints, LegJoints], list[str]]:
    """Return the left and the right leg, and one sentence for each conclusion.

    Raises:
        SkeletonError: If no two legs can be found; the message says what was looked for.
    """
    found: list[LegJoints] = []
    failures: list[str] = []
    for side in range(2):
        leg = _named_leg(skeleton, names, side)
        if isinstance(leg, LegJoints):
            found.append(leg)
        else:
            failures.append(leg)
    if len(found) == 2 and (mismatch := _mismatch(skeleton, found[0], found[1])) is not None:
        failures.append(mismatch)
    if not failures:
        return (found[0], found[1]), [leg.reason for leg in found]
    pair = _mirrored_pair(skeleton, names)
    if not isinstance(pair, str):
        return pair, [leg.reason for leg in pair]
    listed = ", ".join(skeleton.names[:12]) + (", ..." if skeleton.count > 12 else "")
    loose = loose_feet(skeleton, names)
    why = [*failures, pair] if loose is None else [loose]
    raise SkeletonError(f"no legs found: {'; '.join(why)}; the joints are {listed}")


def _named_leg(skeleton: Skeleton, names: tuple[JointName, ...], side: int) -> LegJoints | str:
    """Return the leg that the names of one side tell of, or why there is none."""
    feet = [j for j in range(skeleton.count) if names[j].side == side and _is_foot(names[j])]
    if not feet:
        return (
            f"no joint is named like a {SIDES[side]} foot or ankle "
            f"(such as {SIDES[side].capitalize()}Foot or foot.{SIDES[side][0]})"
        )
    depths = [len(ancestors(skeleton, foot)) for foot in feet]
    problem = ""
    for _, ankle in sorted(zip(depths, feet, strict=True)):
        leg = _leg_above(skeleton, names, side, ankle)
        if isinstance(leg, LegJoints):
            return leg
        problem = problem or leg
    return problem


def _is_foot(name: JointName) -> bool:
    return name.role is Role.FOOT


def _leg_above(
    skeleton: Skeleton, names: tuple[JointName, ...], side: int, ankle: int
) -> LegJoints | str:
    """Return the leg that ends in an ankle, climbing from it."""
    above = [joint for joint in ancestors(skeleton, ankle) if names[joint].side == side]
    knee = next((joint for joint in above if names[joint].role is Role.SHANK), None)
    if knee is None:
        return (
            f"{skeleton.names[ankle]!r} is named like a {SIDES[side]} foot, but no joint above "
            "it is named like a knee or shank"
        )
    upper = above[above.index(knee) + 1 :]
    hip = next((joint for joint in upper if names[joint].role is Role.THIGH), None)
    how = "by their names"
    if hip is None:
        shank = _distance(skeleton, knee, ankle)
        hip = next((j for j in upper if _distance(skeleton, j, knee) > SHORTEST_BONE * shank), None)
        how = "by the names of knee and ankle and the length of the bone above"
    if hip is None:
        return (
            f"{skeleton.names[knee]!r} is named like a {SIDES[side]} knee or shank, but no joint "
            "above it can be the hip"
        )
    return LegJoints(hip, knee, ankle, _reason(skeleton, side, (hip, knee, ankle), how))


def _reason(skeleton: Skeleton, side: int, joints: tuple[int, int, int], how: str) -> str:
    hip, knee, ankle = (skeleton.names[joint] for joint in joints)
    return f"{SIDES[side]} leg: hip {hip!r}, knee {knee!r}, ankle {ankle!r}, {how}"


def _distance(skeleton: Skeleton, upper: int, lower: int) -> float:
    """Return the length of the bones from a joint down to one below it [m]."""
    between = ancestors(skeleton, lower)
    path = [lower, *between[: between.index(upper)]]
    return sum(skeleton.bone_length(joint) for joint in path)


def _mismatch(skeleton: Skeleton, left: LegJoints, right: LegJoints) -> str | None:
    """Return why two legs cannot be one body's, or None."""
    if len({left.hip, left.knee, left.ankle, right.hip, right.knee, right.ankle}) < 6:
        return "the left and the right leg share a joint"
    for bone, upper, lower in (("thigh", "hip", "knee"), ("shank", "knee", "ankle")):
        lengths = [
            _distance(skeleton, getattr(leg, upper), getattr(leg, lower)) for leg in (left, right)
        ]
        if min(lengths) <= (1.0 - GREATEST_DIFFERENCE) * max(lengths):
            return (
                f"the left {bone} is {lengths[0]:.3f} m and the right one {lengths[1]:.3f} m; "
                f"they may differ by {GREATEST_DIFFERENCE:.0%}"
            )
    return None


def _mirrored_pair(
    skeleton: Skeleton, names: tuple[JointName, ...]
) -> tuple[LegJoints, LegJoints] | str:
    """Return the pair of equal chains that leaves the body nearest its root, or why none does."""
    candidates: list[tuple[int, float, tuple[int, int, int], tuple[int, int, int]]] = []
    arms = 0
    for joint in range(skeleton.count):
        chains = [_chain(skeleton, child) for child in skeleton.children(joint)]
        legs = [chain for chain in chains if chain is not None and not _is_arm(names, chain)]
        arms += sum(chain is not None for chain in chains) - len(legs)
        for one, other in combinations(legs, 2):
            if _mismatch(skeleton, LegJoints(*one, ""), LegJoints(*other, "")) is None:
                depth = len(ancestors(skeleton, joint))
                length = _distance(skeleton, one[0], one[2])
                candidates.append((depth, -length, one, other))
    if not candidates:
        but = ", but for what is named like arms" if arms else ""
        return f"no two chains of three joints and equal lengths leave one joint{but}"
    _, _, one, other = min(candidates)
    how = "by being the mirrored pair of chains nearest the root"
    sides = [names[chain[0]].side for chain in (one, other)]
    if {sides[0], sides[1]} != {0, 1}:
        across = skeleton.rest_offsets[one[0]] - skeleton.rest_offsets[other[0]]
        if abs(across[0]) < 2.0 * float(np.hypot(across[1], across[2])):
            pair = f"{skeleton.names[one[0]]!r} and {skeleton.names[other[0]]!r}"
            return f"{pair} begin a pair of equal chains, but which is left cannot be told"
        sides = [0, 1] if across[0] > 0.0 else [1, 0]
        how += "; left is the one at greater x"
    left, right = (one, other) if sides[0] == 0 else (other, one)
    return (
        LegJoints(*left, _reason(skeleton, 0, left, how)),
        LegJoints(*right, _reason(skeleton, 1, right, how)),
    )


def _is_arm(names: tuple[JointName, ...], chain: tuple[int, int, int]) -> bool:
    """Whether a joint of a chain is named like one of an arm.

    Rigs whose feet hang on the root, to be reached for, have no other pair of chains.
    """
    return any(names[joint].role in ARM_ROLES for joint in chain)


def _chain(skeleton: Skeleton, start: int) -> tuple[int, int, int] | None:
    """Return the ends of the first two long bones along the longest chain from a joint."""
    path = _longest_path(skeleton, start)
    bones = [skeleton.bone_length(joint) for joint in path[1:]]
    if not bones:
        return None
    long = [i for i, bone in enumerate(bones) if bone > SHORTEST_BONE * max(bones)]
    if len(long) < 2:
        return None
    return path[long[0]], path[long[1]], path[long[1] + 1]


def _longest_path(skeleton: Skeleton, joint: int) -> list[int]:
    paths = [_longest_path(skeleton, child) for child in skeleton.children(joint)]
    if not paths:
        return [joint]
    return [joint, *max(paths, key=lambda path: sum(skeleton.bone_length(j) for j in path))]
