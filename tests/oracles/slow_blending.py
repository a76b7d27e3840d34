"""The weighted mean of normalized poses, one joint and one pose after the other."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Indices, SmallFloats
from footfall.skeleton import BodyPart


def mean_pose(keys: SmallFloats, weights: Floats, parts: Indices) -> tuple[Floats, Floats]:
    """Return the sums of rotations, not brought to unit length, and of lengths.

    Args:
        keys: Normalized poses, one a layer, shape (layers, channels).
        weights: Weight of each on each body part, shape (layers, parts).
        parts: `BodyPart` of each joint, shape (joints,).
    """
    whose = [*parts.tolist(), int(BodyPart.LEGS), int(BodyPart.LEGS)]
    rotations = np.zeros((len(whose), 4))
    lengths = np.zeros(7)
    for pose, shares in zip(keys.astype(np.float64), weights, strict=True):
        for joint, part in enumerate(whose):
            q = pose[4 * joint : 4 * joint + 4]
            sign = -1.0 if rotations[joint] @ q < 0.0 else 1.0
            rotations[joint] += sign * shares[part] * q
        lengths += shares[BodyPart.LEGS] * pose[4 * len(whose) :]
    return rotations, lengths
