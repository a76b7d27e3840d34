"""How the toes are turned while a foot stands flat: some rigs turn their frames at rest."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Positions, Rotations
from footfall.geometry import blend_rotations, conjugate, multiply
from footfall.skeleton import Anatomy, Leg

__all__ = ["flat_toe_turns"]

_LOWEST = 20.0
"""Percentage of the frames that count as standing flat."""


def flat_toe_turns(anatomy: Anatomy, rotations: Rotations, positions: Positions) -> Rotations:
    """Return how the left and the right toes are turned, relative to their feet, on the ground.

    Args:
        anatomy: What the joints are.
        rotations: Joints in the world, shape (frames, joints, 4).
        positions: Joints in the world [m], shape (frames, joints, 3).

    Returns:
        The mean over the frames in which ankle and toe are lowest, shape (2, 4).
    """
    return np.stack([_flat_turn(leg, rotations, positions) for leg in anatomy.legs])


def _flat_turn(leg: Leg, rotations: Rotations, positions: Positions) -> Rotations:
    heights = positions[:, leg.ankle, 1] + positions[:, leg.toe.joint, 1]
    flat = heights <= np.percentile(heights, _LOWEST)
    turns = multiply(conjugate(rotations[flat, leg.ankle]), rotations[flat, leg.toe.joint])
    return blend_rotations(turns, np.full(len(turns), 1.0 / len(turns)))
