"""What becomes of a start: it runs, it waits, or it cannot be."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["Impossible", "Started", "Waiting"]


@dataclass(frozen=True, slots=True)
class Started:
    """The action runs."""

    at: float
    """Clock time of the start [s]."""


@dataclass(frozen=True, slots=True)
class Waiting:
    """The action cannot be synchronized now; it starts by itself as soon as it can."""

    reason: str
    """What it waits for and why, such as ``waits for 'walk' R→D, 0.31 s: L of 'hop' conflicts
    with R of 'walk'``."""

    until: float | None
    """Clock time at which it will start if no other command comes [s]; None if that is too far
    to be foreseen."""


@dataclass(frozen=True, slots=True)
class Impossible(Waiting):
    """The action can never start beside those that run: every joint state has been tried.

    It waits for one of them to leave.
    """
