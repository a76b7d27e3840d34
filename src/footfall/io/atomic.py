"""Writing a file so that nobody ever sees half of it."""

from __future__ import annotations

import os
import secrets
from pathlib import Path

from footfall.errors import FileFormatError

__all__ = ["write_atomically"]


def write_atomically(path: Path, data: bytes) -> None:
    """Write a file whole, or not at all.

    The bytes go to a temporary file in the same folder, to the disk, and only then under the
    name asked for: a reader sees the old file or the new one, also after a crash.

    Args:
        path: The file; replaced if it exists.
        data: Its new content.

    Raises:
        FileFormatError: If the folder is missing or cannot be written to, or if `path` is a
            folder.
    """
    path = Path(path)
    folder = path.parent
    if not folder.is_dir():
        raise FileFormatError(
            f"cannot be written: there is no folder {str(folder)!r}; make it first", path=path
        )
    if path.is_dir():
        raise FileFormatError("cannot be written: it is a folder; name a file", path=path)
    temporary = folder / f".{path.name[:64]}.{secrets.token_hex(8)}.part"
    try:
        _write_through(temporary, data)
        os.replace(temporary, path)
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise FileFormatError(
            f"cannot be written: {reason}; choose a place that can be written to", path=path
        ) from error
    finally:
        temporary.unlink(missing_ok=True)


def _write_through(path: Path, data: bytes) -> None:
    # Not tempfile: its files are private, and the finished file is to follow the user's mask.
    handle = os.open(path, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666)
    with os.fdopen(handle, "wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())
