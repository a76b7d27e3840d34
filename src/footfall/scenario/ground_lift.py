"""A level ground that rises and sinks while it is walked on."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["LIFT_SPEED", "GroundLift"]

LIFT_SPEED = 0.4
"""How fast the ground moves [m/s]."""


@dataclass(slots=True)
class GroundLift:
    """How high the ground is over where it was at first, and how high it is to be."""

    height: float = 0.0
    """Now [m]."""

    asked: float = 0.0
    """In the end [m]."""

    def advance(self, dt: float) -> bool:
        """Let time pass [s]; return whether the ground has moved."""
        way = self.asked - self.height
        step = LIFT_SPEED * dt
        self.height += min(max(way, -step), step)
        return way != 0.0
