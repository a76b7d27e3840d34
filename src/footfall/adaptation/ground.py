"""What a character stands on."""

from __future__ import annotations

import math
from dataclasses import dataclass

from footfall.errors import ArgumentError

__all__ = ["Plane"]


@dataclass(frozen=True, slots=True)
class Plane:
    """Flat, level ground.

    Raises:
        ArgumentError: If the height is not finite.
    """

    height: float = 0.0
    """Where it lies, y [m]."""

    def __post_init__(self) -> None:
        if not math.isfinite(self.height):
            raise ArgumentError(f"ground at height {self.height}; it must be a finite number [m]")
