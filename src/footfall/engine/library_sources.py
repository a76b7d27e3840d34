"""Motions of a library that programs of the user's make."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from footfall.actions import MotionSource, ask_source
from footfall.engine.action import Action
from footfall.engine.library_layers import LibraryLayers
from footfall.engine.priorities import parse_priority
from footfall.errors import ArgumentError

__all__ = ["LibrarySources"]


class LibrarySources(LibraryLayers):
    """The part of a motion library that asks users' programs for their motions."""

    @property
    def revision(self) -> int:
        """A number that grows whenever an action or a layer is added, or its motion changes."""
        return self.size + self._resampled

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
        values = parse_priority(priority)
        clip, supports = ask_source(name, source)
        with self._unchanged_if_refused():
            clip, packed = self._packed(repr(name), clip, supports)
        self._actions.append(
            Action(name, clip, supports, values, fade_in, fade_out, packed, source=source)
        )
        return len(self._actions) - 1

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
        clip, packed = self._packed(repr(name), clip, supports)
        self._actions[index] = replace(action, clip=clip, packed=packed)
        self._resampled += 1
