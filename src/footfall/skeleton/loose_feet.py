"""Feet that hang beside their legs: animators' rigs have them, for the legs to reach for.

Without the rig's solver nothing holds such a foot at the end of its leg.
"""

from __future__ import annotations

from collections.abc import Sequence

from footfall.skeleton.joint_names import JointName, Role
from footfall.skeleton.skeleton import Skeleton

__all__ = ["loose_feet"]


def loose_feet(skeleton: Skeleton, names: Sequence[JointName]) -> str | None:
    """Return a sentence on a skeleton whose feet do not hang on its shanks; None where they do.

    Args:
        skeleton: The body.
        names: What the names of its joints tell.
    """
    feet: list[int] = []
    shanks: list[int] = []
    for side in range(2):
        own = [joint for joint in range(skeleton.count) if names[joint].side == side]
        feet += [joint for joint in own if names[joint].role is Role.FOOT and joint > 0][:1]
        shanks += [joint for joint in own if names[joint].role is Role.SHANK][:1]
    if len(feet) < 2 or len(shanks) < 2:
        return None
    if any(_hangs_on(skeleton, foot, shank) for foot, shank in zip(feet, shanks, strict=True)):
        return None
    left, right = (repr(skeleton.names[foot]) for foot in feet)
    above = " and ".join(
        repr(name)
        for name in dict.fromkeys(skeleton.names[int(skeleton.parents[foot])] for foot in feet)
    )
    one, other = (repr(skeleton.names[shank]) for shank in shanks)
    return (
        f"{left} and {right} look like the feet, but hang on {above} for the legs to reach for, "
        f"not on the shanks {one} and {other}, so that no chain of joints leads from a hip to a "
        "foot; make them children of the shanks where the file was made"
    )


def _hangs_on(skeleton: Skeleton, joint: int, above: int) -> bool:
    while joint >= 0 and joint != above:
        joint = int(skeleton.parents[joint])
    return joint == above
