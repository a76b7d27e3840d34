"""Rotations as arrays of unit quaternions wxyz, batch axes leading.

What files, editing and reports use. The formulas stand once, in `quaternions`; here they are
applied to whole arrays.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from footfall.arrays import Floats, Positions, Rotations
from footfall.geometry import quaternions

__all__ = [
    "blend_rotations",
    "conjugate",
    "continuous",
    "from_axis_angle",
    "from_euler",
    "from_matrix",
    "from_rotation_vector",
    "from_yaw",
    "multiply",
    "rotate",
    "slerp",
    "to_euler",
    "to_rotation_vector",
]

IDENTITY = np.array([1.0, 0.0, 0.0, 0.0])

_product: Any = getattr(quaternions.product, "py_func", quaternions.product)
_rotate: Any = getattr(quaternions.rotate, "py_func", quaternions.rotate)


def _components(array: Floats) -> tuple[Floats, ...]:
    return tuple(array[..., i] for i in range(array.shape[-1]))


def multiply(one: Rotations, other: Rotations) -> Rotations:
    """Return the product: first `other`, then `one`. Shapes (..., 4), broadcast together."""
    product = _product(*_components(one), *_components(other))
    return np.stack(np.broadcast_arrays(*product), axis=-1)


def conjugate(rotations: Rotations) -> Rotations:
    """Return the inverse rotations, shape (..., 4)."""
    return rotations * np.array([1.0, -1.0, -1.0, -1.0])


def rotate(rotations: Rotations, vectors: Positions) -> Positions:
    """Return `vectors`, shape (..., 3), turned by `rotations`, shape (..., 4), broadcast."""
    return np.stack(
        np.broadcast_arrays(*_rotate(*_components(rotations), *_components(vectors))), axis=-1
    )


def from_axis_angle(axis: Positions, angle: Floats | float) -> Rotations:
    """Return the rotations about unit `axis`, shape (..., 3), by `angle` [rad], shape (...)."""
    half = 0.5 * np.asarray(angle, dtype=np.float64)
    axis = np.asarray(axis, dtype=np.float64)
    vector = np.sin(half)[..., np.newaxis] * axis
    scalar = np.broadcast_to(np.cos(half)[..., np.newaxis], (*vector.shape[:-1], 1))
    return np.concatenate([scalar, vector], axis=-1)


def from_yaw(yaw: Floats | float) -> Rotations:
    """Return the rotations by `yaw` [rad], shape (...), about the vertical; shape (..., 4)."""
    return from_axis_angle(np.array([0.0, 1.0, 0.0]), yaw)


def from_euler(order: str, angles: Floats) -> Rotations:
    """Return the rotations that a motion file's angle channels mean.

    Args:
        order: Axes in the order of the channels, such as ``"ZXY"``: the first one turns last.
        angles: Angles [rad] in the same order, shape (..., len(order)).

    Returns:
        Rotations, shape (..., 4).
    """
    result: Rotations = np.broadcast_to(IDENTITY, (*angles.shape[:-1], 4))
    for position, axis in enumerate(order.upper()):
        unit = np.zeros(3)
        unit["XYZ".index(axis)] = 1.0
        result = multiply(result, from_axis_angle(unit, angles[..., position]))
    return result


def from_matrix(matrices: Floats) -> Rotations:
    """Return the rotations of matrices, shape (..., 3, 3): those that they agree with best.

    A matrix that is no rotation by a little, through rounding, is no problem: the result is the
    unit quaternion q that maximizes the trace of R(q)ᵀ M (Bar-Itzhack 2000, version 3).

    Returns:
        Rotations, shape (..., 4).
    """
    m = np.moveaxis(np.asarray(matrices, dtype=np.float64), (-2, -1), (0, 1))
    (a, b, c), (d, e, f), (g, h, i) = m
    agreement = np.array(
        [
            [a + e + i, h - f, c - g, d - b],
            [h - f, a - e - i, b + d, c + g],
            [c - g, b + d, e - a - i, f + h],
            [d - b, c + g, f + h, i - a - e],
        ]
    )
    _, vectors = np.linalg.eigh(np.moveaxis(agreement, (0, 1), (-2, -1)))
    return vectors[..., :, -1]


def to_euler(order: str, rotations: Rotations) -> Floats:
    """Return the angles [rad] of three different axes, the inverse of `from_euler`.

    Args:
        order: Three different axes in the order of the channels, such as ``"ZXY"``.
        rotations: Rotations, shape (..., 4).

    Returns:
        Angles, shape (..., 3); the middle one within ±π/2. Where that one is ±π/2 the first
        and last turn about the same axis, and the last is returned as zero.
    """
    first, middle, last = ("XYZ".index(axis) for axis in order.upper())
    sign = 1.0 if (first, middle, last) in ((0, 1, 2), (1, 2, 0), (2, 0, 1)) else -1.0
    columns = [rotate(rotations, np.eye(3)[axis]) for axis in range(3)]
    matrix = np.stack(columns, axis=-1)
    sine = sign * matrix[..., first, last]
    cosine = np.hypot(matrix[..., first, first], matrix[..., first, middle])
    straight = cosine > 1e-8
    angle_first = np.where(
        straight,
        np.arctan2(-sign * matrix[..., middle, last], matrix[..., last, last]),
        np.arctan2(sign * matrix[..., last, middle], matrix[..., middle, middle]),
    )
    angle_last = np.where(
        straight, np.arctan2(-sign * matrix[..., first, middle], matrix[..., first, first]), 0.0
    )
    return np.stack([angle_first, np.arctan2(sine, cosine), angle_last], axis=-1)


def continuous(rotations: Rotations) -> Rotations:
    """Return the same rotations with signs chosen so that neighbors along axis 0 are close."""
    flips = np.einsum("t...i,t...i->t...", rotations[1:], rotations[:-1]) < 0.0
    signs = np.cumprod(np.where(flips, -1.0, 1.0), axis=0)
    result = rotations.copy()
    result[1:] *= signs[..., np.newaxis]
    return result


def slerp(one: Rotations, other: Rotations, fraction: Floats | float) -> Rotations:
    """Return the rotations on the way from `one` to `other`, the short way, at even speed.

    Args:
        one: Rotations at fraction 0, shape (..., 4).
        other: Rotations at fraction 1, shape (..., 4).
        fraction: Where between them, shape (...).
    """
    cosine = np.einsum("...i,...i->...", one, other)
    other = np.where(cosine[..., np.newaxis] < 0.0, -other, other)
    angle = np.arccos(np.clip(np.abs(cosine), 0.0, 1.0))
    sine = np.sin(angle)
    near = sine < 1e-6
    safe = np.where(near, 1.0, sine)
    fraction = np.asarray(fraction, dtype=np.float64)
    share_one = np.where(near, 1.0 - fraction, np.sin((1.0 - fraction) * angle) / safe)
    share_other = np.where(near, fraction, np.sin(fraction * angle) / safe)
    mixed = share_one[..., np.newaxis] * one + share_other[..., np.newaxis] * other
    return mixed / np.linalg.norm(mixed, axis=-1, keepdims=True)


def blend_rotations(rotations: Rotations, weights: Floats) -> Rotations:
    """Blend the same joints of several poses: the normalized weighted sum of quaternions.

    Each is first brought to the half of the sphere where the heaviest one lies, since q and -q
    are the same rotation, so that the sum is never zero and no order matters.

    Args:
        rotations: Rotations to blend, shape (poses, ..., 4).
        weights: Share of each, >= 0, summing to one over `poses`, shape (poses, ...).

    Returns:
        The blended rotations, shape (..., 4).
    """
    rank = weights.argmax(axis=0)[np.newaxis, ..., np.newaxis]
    heaviest = np.take_along_axis(rotations, rank, axis=0)[0]
    opposed = np.einsum("p...i,...i->p...", rotations, heaviest) < 0.0
    signed = np.where(opposed, -weights, weights)
    total = np.einsum("p...,p...i->...i", signed, rotations)
    return total / np.linalg.norm(total, axis=-1, keepdims=True)


def from_rotation_vector(vectors: Positions) -> Rotations:
    """Return the rotations about `vectors` by their lengths [rad], shape (..., 3) to (..., 4)."""
    vectors = np.asarray(vectors, dtype=np.float64)
    angle = np.linalg.norm(vectors, axis=-1, keepdims=True)
    # sin(a/2)/a, which tends to 1/2 where nothing turns.
    share = 0.5 * np.sinc(angle / (2.0 * np.pi))
    return np.concatenate([np.cos(0.5 * angle), share * vectors], axis=-1)


def to_rotation_vector(rotations: Rotations) -> Positions:
    """Return the axes times the angles [rad], at most π, the inverse of `from_rotation_vector`."""
    positive = np.where(rotations[..., :1] < 0.0, -rotations, rotations)
    sine = np.linalg.norm(positive[..., 1:], axis=-1, keepdims=True)
    angle = 2.0 * np.arctan2(sine, positive[..., :1])
    return positive[..., 1:] * np.where(sine > 1e-12, angle / np.maximum(sine, 1e-12), 2.0)
