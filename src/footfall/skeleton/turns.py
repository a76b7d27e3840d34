"""Turns of bones: from one direction to another, and what is then still free."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Positions, Rotations
from footfall.geometry import from_matrix, multiply, quaternions, rotate

__all__ = ["across", "frame_turn", "unfolding"]

FOLDED = np.cos(np.radians(100.0))
"""A limb farther than this from where it should point is folded back at rest."""

_SHORTEST = 1e-6


def across(vector: Positions, line: Positions) -> Positions:
    """Return the unit part of a vector across a line, shorter where it is nearly along it."""
    length, size = float(np.linalg.norm(line)), float(np.linalg.norm(vector))
    if length < _SHORTEST or size < _SHORTEST:
        return np.zeros(3)
    part = vector / size - float(vector @ line) / (size * length**2) * line
    share = float(np.linalg.norm(part))
    return part / share if share > 0.2 else np.zeros(3)


def frame_turn(one: Positions, other: Positions, goal: Positions, axis: Positions) -> Rotations:
    """Return the rotation of one direction to a goal, and of one across it to an axis."""
    own = np.stack([one / np.linalg.norm(one), other, np.cross(one, other) / np.linalg.norm(one)])
    return from_matrix(np.stack([goal, axis, np.cross(goal, axis)]).T @ own)


def unfolding(bone: Positions, goal: Positions) -> Rotations:
    """Return the shortest turn of a bone to its goal, sideways first where it is folded back."""
    size = float(np.linalg.norm(bone))
    first = np.array([1.0, 0.0, 0.0, 0.0])
    level = float(np.hypot(bone[0], bone[1]))
    if float(bone @ goal) < FOLDED * size and level > 0.1 * size:
        x = float(bone[0] * goal[0] + bone[1] * goal[1])
        y = float(bone[0] * goal[1] - bone[1] * goal[0])
        half = 0.5 * float(np.arctan2(y, x))
        first = np.array([np.cos(half), 0.0, 0.0, np.sin(half)])
    turned = rotate(first, bone)
    shortest = np.array(_between(turned, goal))
    return multiply(shortest, first)


def _between(one: Positions, other: Positions) -> tuple[float, float, float, float]:
    ax, ay, az = one.tolist()
    bx, by, bz = other.tolist()
    return quaternions.between(ax, ay, az, bx, by, bz)
