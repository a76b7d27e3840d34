"""One motion as its card on the page has it: how it starts, and what it waits for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

__all__ = ["PARTS", "Card", "by_part"]

PARTS = ("legs", "trunk", "head", "left_arm", "right_arm")
"""Body parts with a priority of their own, in the order of the engine's."""


@dataclass(eq=False)
class Card:
    """One motion as its card on the page has it."""

    name: str
    """Of the motion."""

    action: str
    """Of the action in the scenario that the next start means."""

    priority: dict[str, float]
    """By body part."""

    fades: tuple[float, float]
    """How long a start and a stop take [s]."""

    gait: tuple[float, float] | None = field(default=None)
    """The speed [m/s] and the turn [rad/s] asked for by hand; None: as it comes."""

    reason: str = field(default="")
    """Why its start waits."""


def by_part(priority: float | Mapping[str, float]) -> dict[str, float]:
    """Return a priority as the sliders show it."""
    if not isinstance(priority, Mapping):
        return dict.fromkeys(PARTS, float(priority))
    both = float(priority.get("arms", 0.0))
    arms = {"left_arm": both, "right_arm": both}
    return {part: float(priority.get(part, arms.get(part, 0.0))) for part in PARTS}
