"""The layers of one character: commands with names instead of numbers."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence

from footfall.engine.crowd import Crowd
from footfall.engine.layer import UPPER_BODY
from footfall.engine.library import MotionLibrary
from footfall.motion import Clip

__all__ = ["Layered"]


class Layered(ABC):
    """The part of a character that lays motions over others."""

    library: MotionLibrary

    @property
    @abstractmethod
    def crowd(self) -> Crowd:
        """The crowd of one that this character is."""

    def add_layer(
        self,
        name: str,
        clip: Clip,
        *,
        parts: Sequence[str] = UPPER_BODY,
        reference: Clip | None = None,
        fade_in: float = 0.3,
        fade_out: float = 0.3,
    ) -> None:
        """Add a motion to be laid over others; as `MotionLibrary.add_layer`."""
        self.library.add_layer(
            name, clip, parts=parts, reference=reference, fade_in=fade_in, fade_out=fade_out
        )

    def start_layer(self, name: str, *, weight: float = 1.0) -> None:
        """Lay a layer over whatever plays; as `Crowd.start_layer`.

        Raises:
            UnknownNameError: If there is no layer of this name.
            ArgumentError: If the weight is out of range, too many layers are on, or there is no
                action yet.
        """
        self.crowd.start_layer(self.library.layer_index(name), weight=weight)

    def stop_layer(self, name: str) -> None:
        """Let a layer fade out.

        Raises:
            UnknownNameError: If there is no layer of this name.
        """
        self.crowd.stop_layer(self.library.layer_index(name))

    def layer_weight(self, name: str) -> float:
        """Return how much of a layer lies over what plays by now, 0 to 1.

        Raises:
            UnknownNameError: If there is no layer of this name.
        """
        return float(self.crowd.layer_weights(self.library.layer_index(name))[0])
