"""The bytes of a file, unpacked where it is packed, or one line about why not."""

from __future__ import annotations

import gzip
import io
import zlib
from pathlib import Path

from footfall.errors import FileFormatError

__all__ = ["BOMB_RATIO", "BOMB_START", "decoded", "read_bytes"]

BOMB_RATIO = 100
"""Packed motions unpack to three to ten times their size, a body that stands still to fifty.
What unpacks to more than this is made to fill the memory …"""

BOMB_START = 2**22
"""… unless it is no more than these bytes in all."""


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
    limit = BOMB_RATIO * len(data) + BOMB_START
    try:
        with gzip.GzipFile(fileobj=io.BytesIO(data)) as packed:
            content = packed.read(limit + 1)
            if len(content) > limit:
                raise FileFormatError(
                    f"unpacks from {len(data)} to more than {limit} bytes, which no motion does; "
                    "it is not read",
                    path=path,
                )
            # Reading on to the end is what checks that the file is whole.
            packed.read(1)
            return content
    except FileFormatError:
        raise
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
