"""The one door into the studio: what it needs is loaded here, or told to be missing."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from footfall.errors import MissingViewerError
from footfall.scenario.cue_sheet import Scenario

if TYPE_CHECKING:
    from footfall.studio.launch import Studio
    from footfall.studio.motion_list import LoadedMotion

__all__ = ["open_studio"]


def open_studio(
    files: Sequence[str | Path] = (),
    *,
    folder: Path | str = ".",
    host: str = "127.0.0.1",
    port: int = 8080,
    page_writer: Callable[[Scenario], str] | None = None,
    motions: Sequence[LoadedMotion] = (),
) -> Studio:
    """Open a studio, and return it.

    Args:
        files: Motions to load, files or ``sample:NAME``; by default some samples.
        folder: The only place where anything is written.
        host: Address to bind to.
        port: Of the page, or the first free one after it; the 3D scene takes the next free one.
            0 for any.
        page_writer: Returns a page that plays a scenario without a network.
        motions: Motions that are loaded already, instead of the samples.

    Raises:
        MissingViewerError: If the extra is not installed.
        FileFormatError: If no port is free.
    """
    try:
        from footfall.studio.launch import Studio
    except ModuleNotFoundError as error:
        if error.name is not None and error.name.split(".")[0] in ("viser", "websockets"):
            raise MissingViewerError(
                f"the studio needs {error.name}; install it with: pip install 'footfall[studio]'"
            ) from error
        raise
    return Studio(
        files, folder=folder, host=host, port=port, page_writer=page_writer, motions=motions
    )
