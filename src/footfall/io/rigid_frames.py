"""Turns out of matrices that also scale, and matrices out of turns."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Positions, Rotations

__all__ = ["matrices_of", "rigid_rotations"]


def rigid_rotations(matrices: Floats) -> Rotations:
    """Return what matrices turn by, whatever they scale by besides.

    The first two axes decide (Gram-Schmidt), so that the answer is exact wherever a matrix turns
    and scales along its own axes. A mirroring matrix is first turned inside out: what is
    mirrored in all three axes is taken for what it was before.

    Args:
        matrices: Shape (..., 3, 3).

    Returns:
        Unit quaternions, shape (..., 4); NaN where a matrix flattens or is not finite.
    """
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        sign = np.where(np.linalg.det(matrices) < 0.0, -1.0, 1.0)[..., np.newaxis]
        x = _unit(sign * matrices[..., 0])
        y = sign * matrices[..., 1]
        y = _unit(y - np.einsum("...i,...i->...", x, y)[..., np.newaxis] * x)
        return _quaternions(np.stack([x, y, np.cross(x, y)], axis=-1))


def _unit(vectors: Floats) -> Floats:
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def _quaternions(turns: Floats) -> Rotations:
    """Return the quaternions of rotation matrices, found by the greatest component (Shepperd)."""
    trace = np.einsum("...ii->...", turns)
    diagonal = np.einsum("...ii->...i", turns)
    greatest = np.concatenate([trace[..., np.newaxis], diagonal], axis=-1).argmax(axis=-1)
    result = np.empty((*trace.shape, 4))
    result[..., 0] = 1.0 + trace
    for axis in range(3):
        one, other = (axis + 1) % 3, (axis + 2) % 3
        result[..., axis + 1] = turns[..., other, one] - turns[..., one, other]
    for axis in range(3):
        one, other = (axis + 1) % 3, (axis + 2) % 3
        row = np.empty_like(result)
        row[..., 0] = turns[..., other, one] - turns[..., one, other]
        row[..., axis + 1] = 1.0 + 2.0 * diagonal[..., axis] - trace
        row[..., one + 1] = turns[..., axis, one] + turns[..., one, axis]
        row[..., other + 1] = turns[..., axis, other] + turns[..., other, axis]
        result = np.where((greatest == axis + 1)[..., np.newaxis], row, result)
    return _unit(result)


def matrices_of(rotations: Rotations, positions: Positions, scales: Floats) -> Floats:
    """Return the matrices that first scale, then turn, then move, shape (..., 4, 4).

    What is not finite stays so, without a warning.

    Args:
        rotations: Unit quaternions, shape (..., 4).
        positions: Shape (..., 3).
        scales: Along the axes before the turn, shape (..., 3).
    """
    w, x, y, z = (rotations[..., index] for index in range(4))
    matrices = np.zeros((*rotations.shape[:-1], 4, 4))
    with np.errstate(invalid="ignore", over="ignore"):
        rows = (
            (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
        )
        for row, values in enumerate(rows):
            for column, value in enumerate(values):
                matrices[..., row, column] = value * scales[..., column]
    matrices[..., :3, 3] = positions
    matrices[..., 3, 3] = 1.0
    return matrices
