"""The bytes of a file, unpacked where it is packed, or one line about why not."""

from __future__ import annotations

import gzip
import zlib
from pathlib import Path

from footfall.errors import FileFormatError

__all__ = ["decoded", "read_bytes"]


def read_bytes(path: Path) -> bytes:
    """Return the content of a file; a name that ends in ``.gz`` is unpacked.

    Raises:
        FileFormatError: If the file is missing, is a folder, cannot be read, or is packed and
            damaged.
    """
    try:
        data = path.read_bytes()
    except FileNotFoundError:
        raise FileFormatError("there is no such file; check the name", path=path) from None
    except IsADirectoryError:
        raise FileFormatError("it is a folder; name a file", path=path) from None
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise FileFormatError(f"cannot be read: {reason}", path=path) from error
    except ValueError as error:
        raise FileFormatError(f"is no name of a file: {error}", path=path) from error
    if path.suffix.lower() != ".gz":
        return data
    try:
        return gzip.decompress(data)
    except (OSError, EOFError, zlib.error) as error:
        raise FileFormatError(
            "is not a whole gzip file; fetch it again, or unpack it first", path=path
        ) from error


def decoded(data: bytes) -> str:
    """Return text that is UTF-8, with or without a byte order mark, or else Latin-1."""
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")
