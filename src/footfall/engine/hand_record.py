"""What a hand remembers from frame to frame: one record."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.arrays import Positions

__all__ = ["FREE", "HOLDS", "REACHES", "Hand", "hand_type", "new_hands"]

FREE, REACHES, HOLDS = 0, 1, 2
"""What `Hand.task` says: nothing, go for the point, carry the object."""


class Hand:
    """One hand of one character: a record of `hand_type`."""

    task: int
    """`FREE`, `REACHES` or `HOLDS`."""

    closes: bool
    """Whether it takes what it reaches."""

    progress: float
    """How far it has faded in, 0 to 1."""

    fade: float
    """How long that takes [s], > 0."""

    point: Positions
    """What it goes for, in the world [m], shape (3,)."""

    aim: Positions
    """Where it is on its way after that [m], shape (3,)."""

    aim_velocity: Positions
    """How fast that changes [m/s], shape (3,)."""

    missing: float
    """How far the palm stays from its aim because the arm is too short [m]."""

    palm: Positions
    """Where the palm is in the world [m], shape (3,)."""

    grip: Positions
    """The object in the frame of the hand, from the palm [m], shape (3,)."""

    held: Positions
    """Where the object is in the world: at its point until it is taken [m], shape (3,)."""


_VECTORS = ("point", "aim", "aim_velocity", "palm", "grip", "held")

hand_type = np.dtype(
    [
        ("task", np.int64),
        ("closes", np.int8),
        ("progress", np.float64),
        ("fade", np.float64),
        ("missing", np.float64),
        *((name, np.float64, (3,)) for name in _VECTORS),
    ],
    align=True,
)
"""The memory layout of `Hand`."""


def new_hands(rows: int) -> npt.NDArray[Any]:
    """Return free hands, left and right, shape (rows, 2)."""
    hands = np.zeros((rows, 2), dtype=hand_type)
    hands["fade"] = 1.0
    return hands
