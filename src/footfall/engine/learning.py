"""What a character can perform: actions are added by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from footfall.actions import MotionSource
from footfall.engine.library import MotionLibrary
from footfall.motion import Clip
from footfall.support import SupportSequence

__all__ = ["Learning"]


class Learning:
    """The part of a character that learns actions."""

    library: MotionLibrary

    def add(
        self,
        name: str,
        clip: Clip,
        supports: SupportSequence,
        *,
        priority: float | Mapping[str, float] = 1.0,
        fade_in: float = 0.3,
        fade_out: float = 0.3,
    ) -> None:
        """Add an action; arguments and errors as of `MotionLibrary.add`."""
        self.library.add(
            name, clip, supports, priority=priority, fade_in=fade_in, fade_out=fade_out
        )

    def add_source(
        self,
        name: str,
        source: MotionSource,
        *,
        priority: float | Mapping[str, float] = 1.0,
        fade_in: float = 0.3,
        fade_out: float = 0.3,
    ) -> None:
        """Add a motion that a program of the user's makes; as `MotionLibrary.add_source`."""
        self.library.add_source(name, source, priority=priority, fade_in=fade_in, fade_out=fade_out)

    def add_locomotion(
        self,
        name: str,
        clips: Sequence[tuple[Clip, SupportSequence]],
        *,
        speed: float | None = None,
        turn: float | None = None,
        priority: float | Mapping[str, float] = 1.0,
        fade_in: float = 0.3,
        fade_out: float = 0.3,
    ) -> None:
        """Add a gait that follows a speed and a turn; as `MotionLibrary.add_locomotion`."""
        self.library.add_locomotion(
            name,
            clips,
            speed=speed,
            turn=turn,
            priority=priority,
            fade_in=fade_in,
            fade_out=fade_out,
        )
