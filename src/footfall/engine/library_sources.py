"""Motions of a library that programs of the user's make."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import replace

from footfall.actions import MotionSource, ask_source
from footfall.engine.library_layers import LibraryLayers
from footfall.engine.priorities import parse_priority
from footfall.errors import ArgumentError
from footfall.motion import Clip
from footfall.support import SupportSequence

__all__ = ["LibrarySources"]


class LibrarySources(LibraryLayers, ABC):
    """The part of a motion library that asks users' programs for their motions."""

    @property
    def revision(self) -> int:
        """A number that grows whenever an action or a layer is added, or its motion changes."""
        return self.size + self._resampled

    @abstractmethod
    def add(
        self,
        name: str,
        clip: Clip,
        supports: SupportSequence,
        *,
        priority: float | Mapping[str, float] = 1.0,
        fade_in: float = 0.3,
        fade_out: float = 0.3,
    ) -> int:
        """Add a motion, keep what was given in `_given`, and return its id."""

    def add_source(
        self,
        name: str,
        source: MotionSource,
        *,
        priority: float | Mapping[str, float] = 1.0,
        fade_in: float = 0.3,
        fade_out: float = 0.3,
    ) -> int:
        """Add a motion that a program of the user's makes, and return its id.

        The program is asked for all its poses here, and not while time passes; `resample` asks
        it again.

        Args:
            name: What commands will call it; new to this library.
            source: The program.
            priority: Of the whole body or by body part, as in `parse_priority`.
            fade_in: How long a start takes to become complete [s], >= 0.
            fade_out: How long a stop takes to become complete [s], >= 0.

        Raises:
            SourceError: If the program raises anything; nothing is added then.
            ArgumentError: As of `add`; also if the body, rate or supports of the source are none.
            SkeletonError: As of `add`.
            ClipError: As of `add`; also if the source gives anything but a pose for each time.
            SupportSequenceError: As of `add`.
        """
        self._check_new(name, fade_in, fade_out)
        parse_priority(priority)
        clip, supports = ask_source(name, source)
        index = self.add(
            name, clip, supports, priority=priority, fade_in=fade_in, fade_out=fade_out
        )
        self._actions[index] = replace(self._actions[index], source=source)
        return index

    def resample(self, name: str) -> None:
        """Ask the source of an action for its poses again; they are played from now on.

        What is running goes on where it is: a source should change its motion by little at a
        time, or while it is not shown.

        Raises:
            UnknownNameError: If there is no action of this name.
            ArgumentError: If it has no source, or the source has other supports than before.
            SourceError: If the program raises anything; what it gave before is played on.
            SkeletonError: As of `add_source`.
            ClipError: As of `add_source`.
        """
        index = self.index(name)
        action = self._actions[index]
        if action.source is None:
            raise ArgumentError(f"{name!r} has no source to ask again; `add_source` gives it one")
        clip, supports = ask_source(name, action.source)
        if supports != action.supports:
            raise ArgumentError(
                f"the source of {name!r} now has the supports {supports}; those it was added "
                f"with are needed: {action.supports}"
            )
        self._exchange(index, clip)
        self._given[name] = clip
        for other in self._adapted:
            if index < len(other._actions):
                other._exchange(index, clip)

    def _exchange(self, index: int, clip: Clip) -> None:
        """Let an action have another motion from now on, with the same supports."""
        action = self._actions[index]
        clip, packed = self._packed(repr(action.name), clip, action.supports)
        self._actions[index] = replace(action, clip=clip, packed=packed)
        self._resampled += 1
