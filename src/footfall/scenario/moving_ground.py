"""A ground that rises, sinks and tilts, and that is exchanged, while it is walked on."""

from __future__ import annotations

import math

import numpy as np

from footfall.adaptation import AnyGround, HeightField, Plane, Terrain
from footfall.scenario.ground_change import GroundChange
from footfall.scenario.obstacles import Obstacle, Place, grid_line, obstacles_of, raised

__all__ = ["LIFT_SPEED", "TILT_SPEED", "MovingGround"]

LIFT_SPEED = 0.4
"""How fast the ground rises [m/s]."""

TILT_SPEED = 0.1
"""How fast its slope changes [1/s]."""


class MovingGround:
    """What the ground is, and what it is to be."""

    def __init__(self, floor: float, asked: GroundChange | None = None) -> None:
        """Begin with level ground.

        Args:
            floor: Its height [m].
            asked: What it is to become, while somebody stands at the origin.
        """
        self.floor = floor
        self.asked = GroundChange()
        self.height = 0.0
        """How high it is over where it was at first, tilting apart [m]."""
        self.slope = (0.0, 0.0)
        """Rise per meter towards +x and +z."""
        self.rise = 0.0
        """By how much it has risen everywhere in the last step [m]."""
        self._base = 0.0
        self._obstacles: tuple[Obstacle, ...] = ()
        self._place: Place = (0.0, 0.0, 0.0)
        self._exchanged = False
        if asked is not None:
            self.ask(asked, self._place)

    def ask(self, change: GroundChange, place: Place) -> None:
        """Let it become something else; what stands on it is put ahead of a place."""
        if change.kind != self.asked.kind:
            self._obstacles = obstacles_of(change.kind, place)
            self._place = place
            self._exchanged = True
        self.asked = change

    def advance(self, dt: float, place: Place) -> bool:
        """Let time pass [s] for a character at a place; return whether the ground has changed."""
        self.rise = _step(self.height, self.asked.height, LIFT_SPEED * dt)
        self.height += self.rise
        x, z = place[0], place[1]
        before = self.slope
        way = (self.asked.slope[0] - before[0], self.asked.slope[1] - before[1])
        share = min(1.0, TILT_SPEED * dt / max(math.hypot(*way), 1e-12))
        if way != (0.0, 0.0):
            asked = self.asked.slope
            moved = (before[0] + share * way[0], before[1] + share * way[1])
            self.slope = asked if share == 1.0 else moved
            # It tilts about the character: there it is as high as it was.
            self._base += (before[0] - self.slope[0]) * x + (before[1] - self.slope[1]) * z
        changed = self._exchanged or self.rise != 0.0 or self.slope != before
        self._exchanged = False
        return changed

    @property
    def ground(self) -> AnyGround:
        """What the character stands on."""
        plane = Plane(self.floor + self.height + self._base, self.slope)
        if not self._obstacles:
            return plane
        under = self._plane_height(self._place[0], self._place[1])
        parts = tuple(self._laid(one, under) for one in self._obstacles)
        return Terrain((plane, *parts))

    def _plane_height(self, x: float, z: float) -> float:
        level = self.floor + self.height + self._base
        return level + self.slope[0] * x + self.slope[1] * z

    def _laid(self, obstacle: Obstacle, under: float) -> Obstacle:
        """Return an obstacle as it lies on the plane, which is so high where it was asked for."""
        if isinstance(obstacle, HeightField) and self.slope != (0.0, 0.0):
            rows, columns = obstacle.heights.shape
            x, z = grid_line(columns, obstacle.spacing), grid_line(rows, obstacle.spacing)
            tilted = obstacle.heights + self.slope[0] * x + self.slope[1] * z[:, np.newaxis]
            return HeightField(tilted + under, obstacle.spacing, obstacle.middle)
        return raised(obstacle, under)


def _step(now: float, asked: float, longest: float) -> float:
    return min(max(asked - now, -longest), longest)
