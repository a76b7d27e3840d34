"""How deep the arms are in the trunk, both taken as capsules."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.skeleton import Anatomy, Skeleton, leg_length
from footfall.skeleton.landmarks import find_landmarks

__all__ = ["Overlap", "arm_overlaps", "forearm_overlap"]

TRUNK_RADIUS = 0.13
"""Radius of the trunk over leg length: 11 cm on a grown person."""

ARM_RADIUS = 0.05
"""Radius of a forearm over leg length: 4 cm."""

SAMPLES = 9
"""Points along a forearm that are looked at."""


class Overlap(NamedTuple):
    """How deep one forearm is in the trunk, frame by frame."""

    depths: Floats
    """Of its deepest point [m], below 0 where it is clear, shape (frames,)."""

    points: Positions
    """That point in the world [m], shape (frames, 3)."""

    outward: Positions
    """Where it should go to be clear, a unit vector, shape (frames, 3): away from the trunk's
    axis, and all the more to the arm's own side the nearer it is."""


def arm_overlaps(skeleton: Skeleton, anatomy: Anatomy, positions: Positions) -> Floats:
    """Return how deep each forearm is in the trunk in each frame [m], shape (frames, 2).

    The trunk reaches from the middle of the hips to that of the shoulders. Zero where the two do
    not touch, or there is no arm.

    Args:
        skeleton: The body.
        anatomy: What its joints are.
        positions: All joints in the world [m], shape (frames, joints, 3).
    """
    depths = np.zeros((len(positions), 2))
    for side in range(2):
        found = forearm_overlap(skeleton, anatomy, positions, side)
        if found is not None:
            depths[:, side] = np.maximum(found.depths, 0.0)
    return depths


def forearm_overlap(
    skeleton: Skeleton, anatomy: Anatomy, positions: Positions, side: int
) -> Overlap | None:
    """Return how deep one forearm is in the trunk; None where there is no such arm.

    Args:
        skeleton: The body.
        anatomy: What its joints are.
        positions: All joints in the world [m], shape (frames, joints, 3).
        side: 0 for the left arm, 1 for the right one.
    """
    arm = anatomy.arms[side]
    if arm is None:
        return None
    size = 0.5 * (leg_length(skeleton, anatomy.left) + leg_length(skeleton, anatomy.right))
    bottom, top = _trunk(skeleton, anatomy, positions)
    axis = top - bottom
    length = np.maximum((axis**2).sum(axis=-1), 1e-12)
    shares = np.linspace(0.0, 1.0, SAMPLES)[:, np.newaxis, np.newaxis]
    points = (1.0 - shares) * positions[:, arm.elbow] + shares * positions[:, arm.wrist]
    along = np.clip(((points - bottom) * axis).sum(axis=-1) / length, 0.0, 1.0)
    away = points - bottom - along[..., np.newaxis] * axis
    nearest = np.linalg.norm(away, axis=-1).argmin(axis=0)
    frames = np.arange(len(positions))
    away = away[nearest, frames]
    apart = np.linalg.norm(away, axis=-1)
    sideways = positions[:, arm.shoulder] - top
    sideways = sideways / np.maximum(np.linalg.norm(sideways, axis=-1, keepdims=True), 1e-9)
    outward = away + 0.5 * TRUNK_RADIUS * size * sideways
    outward = outward / np.maximum(np.linalg.norm(outward, axis=-1, keepdims=True), 1e-9)
    return Overlap((TRUNK_RADIUS + ARM_RADIUS) * size - apart, points[nearest, frames], outward)


def _trunk(
    skeleton: Skeleton, anatomy: Anatomy, positions: Positions
) -> tuple[Positions, Positions]:
    """Return the lower and the upper end of the trunk's axis [m], shape (frames, 3) each."""
    bottom = 0.5 * (positions[:, anatomy.left.hip] + positions[:, anatomy.right.hip])
    left, right = anatomy.arms
    if left is not None and right is not None:
        return bottom, 0.5 * (positions[:, left.shoulder] + positions[:, right.shoulder])
    return bottom, positions[:, find_landmarks(skeleton, anatomy).chest]
