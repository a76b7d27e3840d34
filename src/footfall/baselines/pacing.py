"""What a way to keep motions in step must answer: where each clip is after the next step."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, Protocol

from footfall.support import SupportSequence

__all__ = ["Pacing", "Playing"]


class Playing(NamedTuple):
    """One action that runs or fades."""

    supports: SupportSequence
    """Of its motion."""

    clip_time: float
    """Where its clip is, cycles counted on [s]."""

    weight: float
    """Its weight on the legs, 0 to 1."""

    entering: bool
    """Whether it has just been started: it may then enter anywhere."""


class Pacing(Protocol):
    """A way to keep motions in step."""

    def clip_times(self, playing: Sequence[Playing], dt: float) -> list[float]:
        """Return where each clip is `dt` seconds later [s].

        Args:
            playing: What plays, the oldest first.
            dt: The step [s], > 0.

        Returns:
            A clip time each, never before the present one, but for what is entering.
        """
        ...
