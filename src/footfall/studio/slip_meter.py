"""How far planted feet slide over the ground, live."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.report import carried_steps
from footfall.support import Support

__all__ = ["SlipMeter"]


class SlipMeter:
    """How far each planted foot has slid since it came down, as the reports measure it."""

    def __init__(self, contact_height: float) -> None:
        """Begin at zero.

        Args:
            contact_height: A foot point is in contact below this height over its lowest one [m].
        """
        self._contact_height = contact_height
        self.slid: Floats = np.zeros(2)
        """Of each foot, since it was planted [m]; of its last span while it swings, shape (2,)."""
        self.total = 0.0
        """Of both feet, since the meter began [m]."""
        self._before: tuple[Positions, Floats] | None = None
        self._planted = (False, False)
        self._lowest: Floats = np.full((2, 2), np.inf)

    def measure(
        self, points: Positions, heights: Floats, carried: Positions, support: Support
    ) -> None:
        """Take one frame.

        Args:
            points: Heel and toe of each foot in the world [m], shape (2, 2, 3).
            heights: Their heights over the ground [m], shape (2, 2).
            carried: How far the ground has taken each foot with it so far [m], shape (2, 3).
            support: What carries the body.
        """
        self._lowest = np.minimum(self._lowest, heights)
        clearances = heights - self._lowest
        places = (points - carried[:, np.newaxis])[..., [0, 2]]
        planted = (support.left, support.right)
        if self._before is not None:
            both = np.stack([self._before[1], clearances])
            ways = np.stack([self._before[0], places])
            for foot in range(2):
                if planted[foot] and self._planted[foot]:
                    touching = both[:, foot] < self._contact_height
                    step = carried_steps(ways[:, foot], both[:, foot], touching)
                    length = float(np.linalg.norm(step))
                    self.slid[foot] += length
                    self.total += length
                elif planted[foot]:
                    self.slid[foot] = 0.0
        self._before = places, clearances
        self._planted = planted
