"""A body that is little more than its feet, put where a test wants them."""

from __future__ import annotations

from typing import Any

import numpy as np

from footfall.arrays import Floats, Positions, Supports
from footfall.report import Trace
from footfall.skeleton import Anatomy, FootPoint, Leg
from footfall.support import Support

FOOT_LENGTH = 0.2
"""From heel to toe [m]."""

HEEL, TOE = 0, 1
LEFT, RIGHT = 0, 1


def _leg(first: int) -> Leg:
    ankle, toe = first + 2, first + 3
    at_joint = (0.0, 0.0, 0.0)
    return Leg(first, first + 1, ankle, FootPoint(ankle, at_joint), FootPoint(toe, at_joint))


ANATOMY = Anatomy(_leg(1), _leg(5), np.zeros(9, dtype=np.int64), ())
"""Pelvis, then hip, knee, ankle and toe of the left and of the right leg."""


def supports(text: str) -> Supports:
    """Return the supports that a letter a frame means."""
    return np.array([Support.from_symbol(symbol) for symbol in text], dtype=np.int64)


def resting_feet(frames: int) -> Positions:
    """Return both feet flat on the ground, shape (frames, 2, 2, 3), the left at x = 0.1."""
    points = np.zeros((frames, 2, 2, 3))
    points[:, LEFT, :, 0] = 0.1
    points[:, RIGHT, :, 0] = -0.1
    points[:, :, TOE, 2] = FOOT_LENGTH
    return points


def trace_of(points: Positions, commanded: Supports | str, fps: float = 60.0, **more: Any) -> Trace:
    """Return a trace with heels and toes there; they rest at 0 and touch below 40 mm."""
    frames = len(points)
    joints = np.zeros((frames, 9, 3))
    joints[:, 0, 1] = 0.9
    for foot, first in ((LEFT, 1), (RIGHT, 5)):
        joints[:, first : first + 2] = points[:, foot, [HEEL]] + [[0.0, 0.8, 0.0], [0.0, 0.4, 0.0]]
        joints[:, first + 2 : first + 4] = points[:, foot]
    options: dict[str, Any] = {"resting_levels": np.zeros((2, 2)), "contact_height": 0.04, **more}
    return Trace(
        positions=joints,
        rotations=np.tile([1.0, 0.0, 0.0, 0.0], (frames, 9, 1)),
        anatomy=ANATOMY,
        fps=fps,
        supports=supports(commanded) if isinstance(commanded, str) else commanded,
        **options,
    )


def slide(frames: int, length: float) -> Floats:
    """Return an even way from 0 to `length` [m] in `frames` frames."""
    return np.linspace(0.0, length, frames)
