"""Motions that commands read."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

from footfall.errors import ClipError, FileFormatError, FootfallError
from footfall.motion import Clip
from footfall.scenario.motions import load_motion
from footfall.support import SupportSequence

__all__ = ["about", "origin_of", "read_motion"]


def read_motion(name: str) -> tuple[Clip, SupportSequence | None]:
    """Return a motion, and the supports that travel with it.

    Args:
        name: A file, or ``sample:NAME``.

    Raises:
        FootfallError: If there is none, or it cannot be read.
    """
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
