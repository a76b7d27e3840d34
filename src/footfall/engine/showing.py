"""Showing a character without knowing any viewer: viewers register themselves.

A viewer is an entry point of the group `VIEWERS`: a function of a `Character`. So the engine
names none, and loads one only when it is asked to show something.
"""

from __future__ import annotations

from importlib.metadata import entry_points
from typing import TYPE_CHECKING

from footfall.errors import MissingViewerError

if TYPE_CHECKING:
    from footfall.engine.character import Character

__all__ = ["VIEWERS", "show_character"]

VIEWERS = "footfall.viewers"
"""The group of entry points that viewers are found in."""


def show_character(character: Character) -> object:
    """Hand a character to the first viewer that is installed, by name.

    Raises:
        MissingViewerError: If there is none.
    """
    viewers = sorted(entry_points(group=VIEWERS), key=lambda viewer: viewer.name)
    if not viewers:
        raise MissingViewerError(
            f"no viewer is registered as {VIEWERS!r}; reinstall footfall, or install a viewer"
        )
    return viewers[0].load()(character)
