"""A path on the ground: a line through points, measured along its length."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from footfall.arrays import Floats, frozen
from footfall.errors import ArgumentError

__all__ = ["GroundPath", "wrapped"]

SHORTEST = 1e-6
"""Length of a path below which it leads nowhere [m]."""


def wrapped(angle: float) -> float:
    """Return the same angle between -π and π [rad]."""
    return math.remainder(angle, math.tau)


@dataclass(frozen=True, eq=False)
class GroundPath:
    """A line through points on the ground, straight between them.

    Raises:
        ArgumentError: If there are not two points of two finite numbers, or they are all one.
    """

    points: Floats
    """x and z [m], shape (points, 2); two or more."""

    distances: Floats
    """How far along the path each of them is [m], shape (points,)."""

    @classmethod
    def through(cls, points: npt.ArrayLike) -> GroundPath:
        """Return the path through some points, x and z [m], shape (points, 2)."""
        try:
            places = frozen(points)
        except (TypeError, ValueError):
            raise ArgumentError("a path must be an array of numbers, x and z a point") from None
        if places.ndim != 2 or places.shape[1] != 2 or len(places) < 2:
            raise ArgumentError(
                f"a path of shape {places.shape}; two points or more are needed, x and z of each"
            )
        if not np.isfinite(places).all():
            point = int(np.argwhere(~np.isfinite(places))[0][0])
            raise ArgumentError(f"point {point} of the path is not finite; give x and z [m]")
        lengths = np.linalg.norm(np.diff(places, axis=0), axis=1)
        if not SHORTEST < float(lengths.sum()) < math.inf:
            raise ArgumentError(f"a path of {lengths.sum():g} m; it must lead somewhere")
        return cls(places, frozen(np.concatenate([[0.0], np.cumsum(lengths)])))

    @property
    def length(self) -> float:
        """From its first to its last point [m]."""
        return float(self.distances[-1])

    def at(self, distance: float) -> tuple[float, float]:
        """Return x and z so far along the path [m]; before and after it, straight on."""
        last = len(self.points) - 2
        i = min(max(int(np.searchsorted(self.distances, distance, side="right")) - 1, 0), last)
        first, far = (0, last) if distance < 0.0 else (i, i)
        i = first if distance < 0.0 else far
        while self.distances[i + 1] == self.distances[i]:
            i += 1 if distance < 0.0 or i == 0 else -1
        share = (distance - self.distances[i]) / (self.distances[i + 1] - self.distances[i])
        x, z = self.points[i] + share * (self.points[i + 1] - self.points[i])
        return float(x), float(z)

    def direction(self, distance: float, over: float) -> float:
        """Return where the path leads there, over a length of it [m]: yaw, 0 to +z [rad]."""
        x, z = self.at(distance - 0.5 * over)
        far_x, far_z = self.at(distance + 0.5 * over)
        return math.atan2(far_x - x, far_z - z)

    def nearest(self, x: float, z: float, first: float, last: float) -> tuple[float, float]:
        """Return how far along the path its nearest place is [m], and how far that is away [m].

        Args:
            x: A place [m].
            z: Likewise.
            first: Where on the path to look from [m].
            last: And to where, the first of equally near places counting.

        Returns:
            The distance along the path, and how far the place is to the left of it [m].
        """
        place = np.array([x, z])
        inside = (self.distances > first) & (self.distances < last)
        knots = np.concatenate([[first], self.distances[inside], [last]])
        corners = np.array([self.at(float(knot)) for knot in knots])
        ways = np.diff(corners, axis=0)
        squares = np.maximum((ways**2).sum(axis=1), SHORTEST**2)
        shares = np.clip(((place - corners[:-1]) * ways).sum(axis=1) / squares, 0.0, 1.0)
        away = place - corners[:-1] - shares[:, np.newaxis] * ways
        gaps = np.linalg.norm(away, axis=1)
        i = int(np.flatnonzero(gaps <= gaps.min() + SHORTEST)[0])
        leftward = ways[i, 1] * away[i, 0] - ways[i, 0] * away[i, 1]
        distance = knots[i] + shares[i] * (knots[i + 1] - knots[i])
        return float(distance), math.copysign(float(gaps[i]), leftward)
