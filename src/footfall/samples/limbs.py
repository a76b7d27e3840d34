"""From what a motion prescribes (feet, trunk, arm angles) to the joints' rotations.

The legs follow from the hip and the ankle: the knee is a hinge whose axis stays sideways.
"""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Positions, Rotations
from footfall.geometry import conjugate, from_axis_angle, from_euler, multiply
from footfall.samples.body import SHANK, THIGH

__all__ = ["arm_rotations", "extension", "from_axes", "leg_rotations", "relative", "share"]


def extension(hips: Positions, ankles: Positions) -> Floats:
    """Return how straight a leg is: hip to ankle as a share of its length, shape (...)."""
    return np.linalg.norm(ankles - hips, axis=-1) / (THIGH + SHANK)


def from_axes(x_axes: Positions, y_axes: Positions) -> Rotations:
    """Return the rotations that turn x and y into these orthonormal axes, shape (..., 4)."""
    z_axes = np.cross(x_axes, y_axes)
    m = np.stack([x_axes, y_axes, z_axes], axis=-1)
    trace = np.einsum("...ii", m)
    diagonal = [m[..., i, i] for i in range(3)]
    # One row each for w, x, y, z as the component that is divided by: the largest is safe.
    squares = np.stack([trace, *(2.0 * value - trace for value in diagonal)], axis=-1) + 1.0
    skew = [m[..., 2, 1], m[..., 0, 2], m[..., 1, 0]]
    turned = [m[..., 1, 2], m[..., 2, 0], m[..., 0, 1]]
    wx, wy, wz = (one - other for one, other in zip(skew, turned, strict=True))
    yz, zx, xy = (one + other for one, other in zip(skew, turned, strict=True))
    rows = np.stack(
        [
            np.stack([squares[..., 0], wx, wy, wz], axis=-1),
            np.stack([wx, squares[..., 1], xy, zx], axis=-1),
            np.stack([wy, xy, squares[..., 2], yz], axis=-1),
            np.stack([wz, zx, yz, squares[..., 3]], axis=-1),
        ],
        axis=-2,
    )
    best = squares.argmax(axis=-1)[..., np.newaxis, np.newaxis]
    chosen = np.take_along_axis(rows, best, axis=-2)[..., 0, :]
    return chosen / np.linalg.norm(chosen, axis=-1, keepdims=True)


def leg_rotations(
    hips: Positions, ankles: Positions, headings: Floats
) -> tuple[Rotations, Rotations]:
    """Return the world rotations of thigh and shank that lead from hip to ankle.

    Args:
        hips: Upper ends of the thighs [m], shape (..., 3).
        ankles: Lower ends of the shanks [m], shape (..., 3); within the leg's reach.
        headings: Turn about the vertical in which the knees bend forward [rad], shape (...).
    """
    line = ankles - hips
    distance = np.linalg.norm(line, axis=-1, keepdims=True)
    line = line / distance
    sideways = np.stack([np.cos(headings), np.zeros_like(headings), -np.sin(headings)], axis=-1)
    hinge = sideways - np.sum(sideways * line, axis=-1, keepdims=True) * line
    hinge = hinge / np.linalg.norm(hinge, axis=-1, keepdims=True)
    forward = np.cross(line, hinge)
    along = (THIGH**2 + distance**2 - SHANK**2) / (2.0 * distance)
    across = np.sqrt(np.maximum(THIGH**2 - along**2, 0.0))
    thigh = (along * line + across * forward) / THIGH
    shank = (distance * line - THIGH * thigh) / SHANK
    return from_axes(hinge, -thigh), from_axes(hinge, -shank)


def arm_rotations(angles: Floats, side: float) -> tuple[Rotations, Rotations]:
    """Return the rotations of upper arm and forearm, relative to their parents.

    Args:
        angles: [rad], shape (..., 5): turn outward about the trunk's vertical, flexion forward,
            abduction, external rotation, flexion of the elbow. All zero is a hanging arm.
        side: 1 for the left arm, -1 for the right.
    """
    turn, flexion, abduction, external, elbow = (angles[..., i] for i in range(5))
    hanging = from_axis_angle(np.array([0.0, 0.0, 1.0]), np.asarray(-side * np.pi / 2.0))
    raised = from_euler(
        "YXZY", np.stack([side * turn, -flexion, side * abduction, side * external], axis=-1)
    )
    forearm = from_axis_angle(np.array([0.0, 1.0, 0.0]), -side * elbow)
    return multiply(raised, hanging), forearm


def share(rotations: Rotations, fraction: float) -> Rotations:
    """Return a fraction of each rotation about its own axis."""
    positive = np.where(rotations[..., :1] < 0.0, -rotations, rotations)
    vector = positive[..., 1:]
    sine = np.linalg.norm(vector, axis=-1, keepdims=True)
    half = fraction * np.arctan2(sine, positive[..., :1])
    axis = vector / np.maximum(sine, 1e-12)
    return np.concatenate([np.cos(half), np.sin(half) * axis], axis=-1)


def relative(parents: Rotations, children: Rotations) -> Rotations:
    """Return children's world rotations as seen from their parents."""
    return multiply(conjugate(parents), children)
