"""What a form of file says by itself, so that nothing need be concluded about it."""

from __future__ import annotations

from dataclasses import dataclass

from footfall.io.conclusions import Conclusion
from footfall.io.units import Unit

__all__ = ["Stated"]


@dataclass(frozen=True, slots=True)
class Stated:
    """Facts with their reasons; None where the form of file leaves one open."""

    unit: Conclusion[Unit] | None = None
    """The unit of length."""

    up: Conclusion[str] | None = None
    """The upward axis, ``"y"`` or ``"z"``."""

    fps: Conclusion[float] | None = None
    """Frames per second."""

    frames: Conclusion[int] | None = None
    """How many frames there are."""

    cyclic: Conclusion[bool] | None = None
    """Whether the last frame is the first one again."""

    name: str | None = None
    """What the clip is called; None: as the file."""

    notes: tuple[str, ...] = ()
    """What else the clip's provenance is to remember."""
