"""How deep the arms are in the trunk, both taken as capsules."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.skeleton import Anatomy, Skeleton, leg_length
from footfall.skeleton.landmarks import find_landmarks

__all__ = ["arm_overlaps"]

TRUNK_RADIUS = 0.13
"""Radius of the trunk over leg length: 11 cm on a grown person."""

ARM_RADIUS = 0.05
"""Radius of a forearm over leg length: 4 cm."""

SAMPLES = 9
"""Points along a forearm that are looked at."""


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
    left, right = anatomy.arms
    bottom = 0.5 * (positions[:, anatomy.left.hip] + positions[:, anatomy.right.hip])
    top = positions[:, find_landmarks(skeleton, anatomy).chest]
    if left is not None and right is not None:
        top = 0.5 * (positions[:, left.shoulder] + positions[:, right.shoulder])
    size = 0.5 * (leg_length(skeleton, anatomy.left) + leg_length(skeleton, anatomy.right))
    axis = top - bottom
    length = np.maximum((axis**2).sum(axis=-1), 1e-12)
    for side, arm in enumerate(anatomy.arms):
        if arm is None:
            continue
        elbows, wrists = positions[:, arm.elbow], positions[:, arm.wrist]
        for share in np.linspace(0.0, 1.0, SAMPLES).tolist():
            point = (1.0 - share) * elbows + share * wrists
            along = np.clip(((point - bottom) * axis).sum(axis=-1) / length, 0.0, 1.0)
            apart = np.linalg.norm(point - bottom - along[:, np.newaxis] * axis, axis=-1)
            depth = (TRUNK_RADIUS + ARM_RADIUS) * size - apart
            depths[:, side] = np.maximum(depths[:, side], depth)
    return depths
