"""Move points over the ground onto others: the yaw and the level shift that fit best."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.geometry import from_yaw, rotate

__all__ = ["align_on_ground"]


def align_on_ground(
    points: Positions, targets: Positions, weights: Floats | None = None
) -> tuple[Floats, Positions, Positions]:
    """Return the motion over the ground that brings points nearest to their targets.

    The least squares of the level distances, in closed form. Heights are left as they are.

    Args:
        points: Points [m], shape (..., points, 3).
        targets: Where each should go [m], same shape.
        weights: Share of each, > 0, shape (points,); all alike if None.

    Returns:
        The yaw about the origin [rad], shape (...); the level shift after it [m], shape (..., 3);
        and what is left, target minus moved point [m], shape (..., points, 3).
    """
    count = points.shape[-2]
    shares = np.full(count, 1.0 / count) if weights is None else weights / weights.sum()
    center = np.einsum("p,...pi->...i", shares, points)
    goal = np.einsum("p,...pi->...i", shares, targets)
    one = points - center[..., np.newaxis, :]
    other = targets - goal[..., np.newaxis, :]
    cosine = np.einsum("p,...pi,...pi->...", shares, one[..., ::2], other[..., ::2])
    sine = np.einsum(
        "p,...p->...", shares, one[..., 2] * other[..., 0] - one[..., 0] * other[..., 2]
    )
    yaw: Floats = np.arctan2(sine, cosine)
    turn = from_yaw(yaw)
    shift = (goal - rotate(turn, center)) * np.array([1.0, 0.0, 1.0])
    moved = rotate(turn[..., np.newaxis, :], points) + shift[..., np.newaxis, :]
    return yaw, shift, targets - moved
