"""What a cue asks of the ground: how high, how tilted, and what stands on it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

__all__ = ["GROUND_KINDS", "HIGHEST", "STEEPEST", "GroundChange", "GroundKind"]

GroundKind = Literal["level", "ramp", "stairs", "hills", "moving plate", "turning plate", "course"]
"""What stands on the plane. Each is put ahead of the character when a cue asks for it."""

GROUND_KINDS: tuple[GroundKind, ...] = get_args(GroundKind)
"""All of them."""

HIGHEST = 10.0
"""How far the ground may rise or sink [m]."""

STEEPEST = 0.4
"""Greatest rise per meter along each axis."""


@dataclass(frozen=True, slots=True)
class GroundChange:
    """How the ground is to be; it moves there at a pace at which it can be walked on."""

    height: float = 0.0
    """How high over where it was at first [m]."""

    slope: tuple[float, float] = (0.0, 0.0)
    """Rise per meter towards +x and towards +z. It tilts about where the character is."""

    kind: GroundKind = "level"
    """What stands on it."""
