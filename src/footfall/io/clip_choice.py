"""Files that hold several clips: ``walk.glb#Walk_Loop`` names one of them."""

from __future__ import annotations

import re
from pathlib import Path

__all__ = ["CHOOSING", "split_choice"]

CHOOSING = (".fbx", ".fbx.gz", ".glb", ".gltf")
"""Suffixes of files in which a clip can be chosen."""

_CHOICE = re.compile(r"(.+\.(?:fbx|fbx\.gz|glb|gltf))#(.+)", re.IGNORECASE | re.DOTALL)


def split_choice(path: Path | str) -> tuple[Path, str | None]:
    """Return the file, and the clip in it that is chosen by name or number; None without a choice.

    A file whose own name holds the sign is that file.

    >>> split_choice("moves/walk.glb#Walk_Loop")[1]
    'Walk_Loop'
    """
    match = _CHOICE.fullmatch(str(path))
    try:
        if match is None or Path(path).exists():
            return Path(path), None
    except (OSError, ValueError):
        return Path(path), None
    return Path(match[1]), match[2]
