"""What stands in a cue sheet: an action, and a command at a time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from footfall.engine.layer import UPPER_BODY
from footfall.scenario.ground_change import GroundChange

__all__ = ["ActionEntry", "Cue", "LayerEntry"]

Priority = float | Mapping[str, float]

LEVEL = GroundChange()
"""The ground as it is at first."""


@dataclass(frozen=True, slots=True)
class ActionEntry:
    """A motion that cues may start and stop."""

    name: str
    """What cues call it."""

    motion: str
    """A file beside the scenario, or ``sample:NAME``."""

    priority: Priority = 1.0
    """Of the whole body, or by body part."""

    fade_in: float = 0.3
    """How long a start takes to become complete [s]."""

    fade_out: float = 0.3
    """How long a stop takes to become complete [s]."""

    cyclic: bool | None = None
    """Whether it starts over after its end; None: as the motion itself says."""

    supports: str | None = None
    """A file beside the scenario: the supports of the motion as it is performed."""

    mirror: bool = False
    """Whether left and right are exchanged."""

    crop: tuple[float, float] | None = None
    """Only this part of the motion [s]."""

    clean: bool = False
    """Whether its own planted feet are pinned at import."""

    others: tuple[str, ...] = ()
    """More motions, of other speeds or turns, where the action is a gait that follows them."""

    speed: float | None = None
    """Forward, with which such a gait begins [m/s]; None: that of its first motion."""

    turn: float | None = None
    """To the left, likewise [rad/s]."""


@dataclass(frozen=True, slots=True)
class LayerEntry:
    """A motion that cues may lay over others."""

    name: str
    """What cues call it."""

    motion: str
    """A file beside the scenario, or ``sample:NAME``."""

    parts: tuple[str, ...] = UPPER_BODY
    """The body parts that it turns."""

    reference: str | None = None
    """The motion over whose first pose it comes out as it is; None: its own."""

    fade_in: float = 0.3
    """How long it takes to come [s]."""

    fade_out: float = 0.3
    """How long it takes to go [s]."""

    cyclic: bool | None = None
    """Whether it starts over after its end; None: as the motion itself says."""

    mirror: bool = False
    """Whether left and right are exchanged."""

    crop: tuple[float, float] | None = None
    """Only this part of the motion [s]."""


@dataclass(frozen=True, slots=True)
class Cue:
    """A command at a time."""

    at: float
    """When [s]."""

    kind: Literal["start", "stop", "priority", "ground", "speed", "turn", "layer"]
    """What is commanded."""

    action: str = ""
    """The name of the action or layer it is about; empty where it is about the ground."""

    priority: Priority | None = None
    """The new priority, where it is one."""

    parameter: float = 0.0
    """The new speed [m/s], turn [rad/s] or weight of a layer, 0 to let it go, where it is one."""

    ground: GroundChange = LEVEL
    """How the ground is to be, where it is about it."""
