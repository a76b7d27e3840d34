"""Where a picture looks from: along the way the body goes."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Positions

__all__ = ["Stage"]

STANDING = 0.5
"""Bodies that get less far than this are looked at as if they went along +z [m]."""


@dataclass(frozen=True, eq=False)
class Stage:
    """Axes on the ground: ahead, and to the left of it."""

    ahead: Floats
    """Unit vector x, z, shape (2,)."""

    @classmethod
    def of(cls, paths: Iterable[Positions]) -> Stage:
        """Return the stage of bodies whose pelvis took these paths, each (frames, 3)."""
        ways = [(path[-1] - path[0])[[0, 2]] for path in paths]
        longest = max(ways, key=lambda way: float(np.linalg.norm(way)))
        length = float(np.linalg.norm(longest))
        return cls(longest / length if length >= STANDING else np.array([0.0, 1.0]))

    def along(self, points: Positions) -> Floats:
        """Return how far ahead points (..., 3) are [m]."""
        return points[..., 0] * self.ahead[0] + points[..., 2] * self.ahead[1]

    def leftward(self, points: Positions) -> Floats:
        """Return how far to the left points (..., 3) are [m]."""
        return points[..., 0] * self.ahead[1] - points[..., 2] * self.ahead[0]
