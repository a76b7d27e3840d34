"""What can be seen in any clip: legs, an outlying first frame, the floor, whether it loops."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Positions, Rotations
from footfall.errors import SkeletonError
from footfall.geometry import rotate
from footfall.io.conclusions import Conclusion, LegNames
from footfall.skeleton import Anatomy, FootPoint, Skeleton, find_anatomy

__all__ = [
    "conclude_cyclic",
    "conclude_feet",
    "conclude_first_frame",
    "conclude_floor",
    "legs_or_reason",
]

OUTLYING_LEAP = 5.0
"""A first step this many times the 95th percentile of all others makes the frame an outlier …"""

SHORTEST_LEAP = 0.05
"""… if its joints move by at least this much (root mean square) [m]."""

CLOSED = 0.002
"""A clip is cyclic if its last pose is within this of its first (root mean square) [m]."""

NEARLY_CLOSED = 0.05
"""Up to this gap the loop can be closed by editing [m]."""

MOVING = 0.02
"""A clip that never leaves its first pose by more than this stands still [m]."""


def legs_or_reason(skeleton: Skeleton) -> Anatomy | str:
    """Return the anatomy of a body, or why it has no legs."""
    try:
        return find_anatomy(skeleton)
    except SkeletonError as error:
        return str(error)


def conclude_feet(
    skeleton: Skeleton, anatomy: Anatomy | str
) -> Conclusion[tuple[LegNames, LegNames] | None]:
    """Return the joints of the legs; `anatomy` is a reason where there are none."""
    if isinstance(anatomy, str):
        return Conclusion(None, anatomy)
    left, right = (
        LegNames(
            *(skeleton.names[joint] for joint in (leg.hip, leg.knee, leg.ankle, leg.toe.joint))
        )
        for leg in anatomy.legs
    )
    return Conclusion((left, right), "; ".join(anatomy.reasons[:4]))


def conclude_first_frame(positions: Positions) -> Conclusion[bool]:
    """Return whether the first frame is no part of the motion.

    Args:
        positions: The joints in the world [m], shape (frames, joints, 3).
    """
    if len(positions) < 4:
        return Conclusion(False, "too few frames to tell whether the first one is an outlier")
    relative = positions - positions[:, :1]
    leaps = _root_mean_square(relative[1:] - relative[:-1])
    usual = float(np.percentile(leaps[1:], 95.0))
    first = float(leaps[0])
    if first > max(SHORTEST_LEAP, OUTLYING_LEAP * usual):
        return Conclusion(
            True,
            f"an outlier, such as a T-pose: the joints leap by {first * 1000.0:.0f} mm to the "
            f"second frame, and by at most {usual * 1000.0:.0f} mm between almost all others; "
            "crop it off before use",
        )
    return Conclusion(
        False, f"part of the motion: the joints move by {first * 1000.0:.0f} mm to the second frame"
    )


def conclude_floor(
    anatomy: Anatomy | str, rotations: Rotations, positions: Positions
) -> Conclusion[float]:
    """Return how high the lowest foot points rest [m].

    Args:
        anatomy: The legs; a reason where there are none, and then all joints are looked at.
        rotations: The joints in the world, shape (frames, joints, 4).
        positions: The same [m], shape (frames, joints, 3).
    """
    if isinstance(anatomy, str):
        heights, what = positions[..., 1].min(axis=1), "lowest joint"
    else:
        points = [point for leg in anatomy.legs for point in (leg.heel, leg.toe)]
        heights = np.min([_height(point, rotations, positions) for point in points], axis=0)
        what = "lowest joint of the feet"
    floor = float(np.percentile(heights, 5.0))
    return Conclusion(
        floor, f"at {floor * 1000.0:+.0f} mm: there the {what} is in the lowest twentieth of frames"
    )


def _height(point: FootPoint, rotations: Rotations, positions: Positions) -> Floats:
    offset = rotate(rotations[:, point.joint], np.array(point.offset))
    return positions[:, point.joint, 1] + offset[:, 1]


def conclude_cyclic(positions: Positions) -> Conclusion[bool]:
    """Return whether the last frame is the first one again, moved and turned on the ground.

    Args:
        positions: The joints in the world [m], shape (frames, joints, 3).
    """
    if len(positions) < 3:
        return Conclusion(False, "not cyclic: there are too few frames")
    relative = positions - _on_ground(positions)
    gap = _gap(relative[0], relative[-1])
    millimetres = f"{gap * 1000.0:.1f} mm"
    away = float(_root_mean_square(relative - relative[0]).max())
    if gap > NEARLY_CLOSED:
        return Conclusion(False, f"not cyclic: the last pose is {millimetres} from the first")
    if away < MOVING:
        return Conclusion(False, "not cyclic: the body stands still")
    if gap > CLOSED:
        return Conclusion(
            False,
            f"not cyclic: the last pose is {millimetres} from the first; "
            "editing can close such a gap",
        )
    return Conclusion(True, f"cyclic: the last pose is {millimetres} from the first")


def _on_ground(positions: Positions) -> Positions:
    """Return the point on the ground below each frame's joint 0, shape (frames, 1, 3)."""
    return positions[:, :1] * np.array([1.0, 0.0, 1.0])


def _gap(one: Positions, other: Positions) -> float:
    """Return the distance of two poses, one turned about the vertical to fit the other [m]."""
    sine = float((one[:, 0] * other[:, 2] - one[:, 2] * other[:, 0]).sum())
    cosine = float((one[:, 0] * other[:, 0] + one[:, 2] * other[:, 2]).sum())
    yaw = np.arctan2(sine, cosine)
    turn = np.array([np.cos(0.5 * yaw), 0.0, np.sin(0.5 * yaw), 0.0])
    return float(_root_mean_square(rotate(turn, other) - one))


def _root_mean_square(differences: Positions) -> Floats:
    """Return the root mean square length over the joints, shape (..., joints, 3) to (...)."""
    squares = np.einsum("...jc,...jc->...", differences, differences)
    return np.sqrt(squares / differences.shape[-2])
