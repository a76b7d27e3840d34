"""Which axis of a file points up."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from footfall.arrays import Positions, Rotations
from footfall.errors import FileFormatError
from footfall.geometry import conjugate, multiply, rotate
from footfall.io.conclusions import Conclusion
from footfall.skeleton import Anatomy, Skeleton, world_poses

__all__ = ["conclude_up", "turned_up"]

CLEAR = 0.8
"""A body stands along an axis if the line from its ankles to its head is within 37 degrees."""

TO_Y_UP = np.array([np.sqrt(0.5), -np.sqrt(0.5), 0.0, 0.0])
"""Turns z to y, and y to -z."""


def conclude_up(
    skeleton: Skeleton, anatomy: Anatomy, places: Positions, rotations: Rotations, path: Path
) -> Conclusion[str]:
    """Return the axis along which the body stands, in its frames and at rest.

    Args:
        skeleton: The body in the file's unit and axes.
        anatomy: Its legs.
        places: Joint 0 in the world, shape (frames, 3).
        rotations: Joints relative to their parents, shape (frames, joints, 4).
        path: The file, for messages.

    Raises:
        FileFormatError: If the frames and the rest pose contradict each other, or neither tells.
    """
    identity = np.zeros((1, skeleton.count, 4))
    identity[..., 0] = 1.0
    moving = _axis(_stance(skeleton, anatomy, places, rotations))
    resting = _axis(_stance(skeleton, anatomy, np.zeros((1, 3)), identity))
    if moving is None and resting is None:
        raise FileFormatError(
            "stands along neither y nor z, in its frames or at rest; pass up='y' or up='z'",
            path=path,
        )
    if moving is not None and resting not in (None, moving):
        raise FileFormatError(
            f"stands along {resting} at rest but along {moving} in its frames; pass "
            f"up={resting!r} if it lies there, or up={moving!r} if it stands",
            path=path,
        )
    if moving is None:
        return Conclusion(
            str(resting), f"{resting}: the rest pose stands along it, the frames along no axis"
        )
    also = " and at rest" if resting == moving else ""
    return Conclusion(
        moving, f"{moving}: from ankles to head the body stands along it in its frames{also}"
    )


def _stance(
    skeleton: Skeleton, anatomy: Anatomy, places: Positions, rotations: Rotations
) -> Positions:
    """Return the median direction from the ankles to the head, shape (3,)."""
    _, positions = world_poses(skeleton, places, rotations)
    ankles = positions[:, [anatomy.left.ankle, anatomy.right.ankle]].mean(axis=1)
    top = anatomy.head if anatomy.head is not None else anatomy.chest
    hips = positions[:, [anatomy.left.hip, anatomy.right.hip]].mean(axis=1)
    upper = hips if top is None else positions[:, top]
    lines = upper - ankles
    lengths = np.linalg.norm(lines, axis=-1, keepdims=True)
    median: Any = np.median(lines / np.maximum(lengths, 1e-300), axis=0)
    return median


def _axis(direction: Positions) -> str | None:
    for axis, share in zip("yz", direction[1:], strict=True):
        if share > CLEAR:
            return axis
    return None


def turned_up(
    skeleton: Skeleton, places: Positions, rotations: Rotations, up: str
) -> tuple[Skeleton, Positions, Rotations]:
    """Return the body and its motion with y up; the facing is left as it is.

    Args:
        skeleton: The body in the file's axes.
        places: Joint 0 in the world, shape (frames, 3).
        rotations: Joints relative to their parents, shape (frames, joints, 4).
        up: The axis that points up in the file, ``"y"`` or ``"z"``.

    Returns:
        The same with every frame of reference turned, the joints' own included: a body that
        stands along z at rest then stands along y.
    """
    if up == "y":
        return skeleton, places, rotations
    turned = Skeleton(
        skeleton.names,
        skeleton.parents,
        rotate(TO_Y_UP, skeleton.rest_offsets),
        rotate(TO_Y_UP, skeleton.tip_offsets),
    )
    back = conjugate(TO_Y_UP)
    return turned, rotate(TO_Y_UP, places), multiply(multiply(TO_Y_UP, rotations), back)
