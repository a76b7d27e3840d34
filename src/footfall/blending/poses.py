"""The weighted mean of normalized poses, each body part with its own weights."""

from __future__ import annotations

import math

from footfall.arrays import Floats, Indices, Rotations, SmallFloats, Weights
from footfall.compilation import kernel
from footfall.skeleton import BodyPart
from footfall.skeleton.normalized import EFFECTORS

__all__ = ["add_pose", "clear_pose", "finish_pose"]

LEGS = int(BodyPart.LEGS)


@kernel
def clear_pose(turned: Rotations, effectors: Floats) -> None:
    """Begin a mean: set everything to zero."""
    turned[:] = 0.0
    effectors[:] = 0.0


@kernel
def add_pose(
    keys: SmallFloats,
    frame: int,
    fraction: float,
    parts: Indices,
    weights: Weights,
    turned: Rotations,
    effectors: Floats,
) -> None:
    """Add one motion's pose between two of its frames, weighted.

    A quaternion and its opposite are the same rotation: each is added on the side of the
    sphere where the sum so far lies. Lengths are those of the mean leg, so they are weighted
    like the legs.

    Args:
        keys: Normalized poses, shape (frames, channels).
        frame: The frame before; the one after is read only where `fraction` > 0.
        fraction: How far between the two, in [0, 1).
        parts: `BodyPart` of each joint, shape (joints,).
        weights: Weight of this motion on each body part, shape (parts,).
        turned: The sum of rotations, joints then feet, shape (joints + 2, 4).
        effectors: The sum of lengths, shape (7,).
    """
    joints = parts.shape[0]
    after = frame + 1 if fraction > 0.0 else frame
    for row in range(joints + 2):
        weight = weights[parts[row]] if row < joints else weights[LEGS]
        if weight <= 0.0:
            continue
        column = 4 * row
        w = keys[frame, column] + fraction * (keys[after, column] - keys[frame, column])
        x = keys[frame, column + 1] + fraction * (keys[after, column + 1] - keys[frame, column + 1])
        y = keys[frame, column + 2] + fraction * (keys[after, column + 2] - keys[frame, column + 2])
        z = keys[frame, column + 3] + fraction * (keys[after, column + 3] - keys[frame, column + 3])
        total = turned[row]
        if total[0] * w + total[1] * x + total[2] * y + total[3] * z < 0.0:
            weight = -weight
        total[0] += weight * w
        total[1] += weight * x
        total[2] += weight * y
        total[3] += weight * z
    column = 4 * joints + 8
    weight = weights[LEGS]
    for i in range(EFFECTORS):
        one = keys[frame, column + i]
        effectors[i] += weight * (one + fraction * (keys[after, column + i] - one))


@kernel
def finish_pose(turned: Rotations) -> None:
    """End a mean: bring the summed rotations to unit length."""
    for row in range(turned.shape[0]):
        q = turned[row]
        length = math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
        if length < 1e-12:
            q[0], q[1], q[2], q[3] = 1.0, 0.0, 0.0, 0.0
        else:
            q[0] /= length
            q[1] /= length
            q[2] /= length
            q[3] /= length
