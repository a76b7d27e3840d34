"""Files that commands write: checked before the work, written after it."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from footfall.errors import FileFormatError
from footfall.io import (
    save,
    save_gltf,
    save_native,
    save_supports,
    writable_suffixes,
    write_atomically,
)
from footfall.motion import Clip
from footfall.scenario.motions import supports_path
from footfall.support import SupportSequence

__all__ = ["check_beside", "check_folder", "check_output", "save_motion", "write_json"]


def check_output(path: Path) -> None:
    """Refuse a file that no motion can be written to, before any work is done for it.

    Raises:
        FileFormatError: If its suffix is unknown or its folder is missing.
    """
    if not path.name.lower().endswith(writable_suffixes()):
        raise FileFormatError(
            f"cannot be written: its suffix is none of {', '.join(writable_suffixes())}", path=path
        )
    check_folder(path)


def check_folder(path: Path) -> None:
    """Refuse a file whose folder is missing.

    Raises:
        FileFormatError: If it is.
    """
    if not path.parent.is_dir():
        raise FileFormatError(f"there is no folder {path.parent}; make it first", path=path)


def save_motion(
    clip: Clip, path: Path, supports: SupportSequence | None = None, symbols: str | None = None
) -> None:
    """Write a motion, and its supports beside it.

    Args:
        clip: The motion.
        path: The file.
        supports: What carries the body; None: nothing is written beside it.
        symbols: The same frame by frame, for files that keep it.

    Raises:
        FileFormatError: If a file cannot be written, or supports of another motion lie beside it.
    """
    check_beside(path, supports)
    suffix = path.suffix.lower()
    if suffix == ".glb":
        save_gltf(clip, path, supports=symbols)
    elif suffix == ".npz" and not path.name.lower().endswith(".amass.npz"):
        save_native(clip, path, supports=supports)
    else:
        save(clip, path)
    if supports is not None:
        save_supports(supports, supports_path(path))


def check_beside(path: Path, supports: SupportSequence | None) -> None:
    """Refuse to write another motion beside supports that would then be taken for its own.

    Args:
        path: The motion's file.
        supports: Its own, which are to stand beside it instead; None: it has none.

    Raises:
        FileFormatError: If there are any.
    """
    beside = supports_path(path)
    if supports is None and beside.exists():
        raise FileFormatError(
            f"would stand beside {beside.name}, which is of another motion; "
            "delete that file, or choose another name",
            path=path,
        )


def write_json(path: Path, content: Mapping[str, Any]) -> None:
    """Write JSON.

    Raises:
        FileFormatError: If the file cannot be written.
    """
    write_atomically(path, (json.dumps(content, indent=2, ensure_ascii=False) + "\n").encode())
