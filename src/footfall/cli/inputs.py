"""Motions that commands read, and what their users may know of them better than the files."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, Literal

from cyclopts import Parameter

from footfall.errors import ArgumentError, ClipError, FileFormatError, FootfallError
from footfall.motion import Clip
from footfall.scenario.motions import SAMPLE, load_motion, load_with_supports
from footfall.support import SupportSequence

__all__ = ["Known", "about", "origin_of", "read_motion"]


@Parameter(name="*")
@dataclass(frozen=True)
class Known:
    """What is known about a file, where it cannot be told from the file itself."""

    unit: str | None = None
    """Its unit of length: m, foot, dm, cmu, inch, cm, mm, or a number of metres."""

    up: Literal["y", "z"] | None = None
    """The axis that points up in it."""

    fps: float | None = None
    """Its frames per second; of a glTF file, the rate at which its keys are sampled."""

    model: Path | None = None
    """The file of the body it is for: a SMPL model (AMASS), or a character (DeepMimic)."""

    def options(self) -> dict[str, Any]:
        """Return the arguments of `footfall.io.load` that say the same.

        Raises:
            ArgumentError: If the unit is neither a name nor a number.
        """
        unit: str | float | None = self.unit
        if unit is not None and not unit.isalpha():
            try:
                unit = float(unit)
            except ValueError:
                raise ArgumentError(
                    f"--unit is {unit!r}; it must be a unit's name or a number of metres"
                ) from None
        return {"unit": unit, "up": self.up, "fps": self.fps, "body": self.model}


NOTHING = Known()
"""Nothing is known better than the file knows it."""


def read_motion(name: str, known: Known | None = None) -> tuple[Clip, SupportSequence | None]:
    """Return a motion, and the supports that travel with it.

    Args:
        name: A file, or ``sample:NAME``.
        known: What is known about the file.

    Raises:
        FootfallError: If there is none, or it cannot be read.
    """
    known = known or NOTHING
    if not name.startswith(SAMPLE):
        return load_with_supports(Path(name), **known.options())
    for option in fields(known):
        if getattr(known, option.name) is not None:
            raise ArgumentError(f"{name} is no file; --{option.name} is for files")
    return load_motion(name, Path())


def origin_of(known: SupportSequence | None) -> str:
    """Return where supports come from; `known` are those that travel with the motion."""
    return "detected" if known is None else "as they came with the motion"


@contextmanager
def about(name: str) -> Generator[None]:
    """Let every message about a motion name it.

    Raises:
        FootfallError: What was raised inside, with the name before it.
    """
    try:
        yield
    except FileFormatError:
        raise
    except FootfallError as error:
        raise ClipError(f"{name}: {error}") from error
