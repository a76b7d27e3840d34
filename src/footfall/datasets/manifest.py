"""What of an archive is done: one line a file, so that a run can be broken off and go on.

``manifest.jsonl`` begins with a line about the run (format, version, the detector's limits); each
other line is a row of the table. While a run goes on, a line is added when its file is done; a line
that was cut short by a crash is dropped when the manifest is next opened, and its file done again.
Opening and closing write the whole manifest anew, in the order of the files, atomically.
"""

from __future__ import annotations

import json
import os
from dataclasses import asdict
from pathlib import Path
from types import TracebackType
from typing import Any, BinaryIO, cast

from footfall.datasets.clip_annotation import ClipAnnotation, Limits
from footfall.errors import FileFormatError
from footfall.io import write_atomically
from footfall.io.raw_file import read_bytes

__all__ = ["MANIFEST", "Manifest"]

MANIFEST = "manifest.jsonl"
"""Its name in the folder of the results."""

FORMAT = "footfall annotations"
VERSION = 1


class Manifest:
    """The rows of all files that are done, on disk and in memory.

    Use it in a ``with`` statement: leaving that writes the manifest in order.

    Raises:
        FileFormatError: If the folder holds a manifest of other limits, of another version, or
            none of ours, or cannot be written to.
    """

    def __init__(self, folder: Path, limits: Limits) -> None:
        self._path = folder / MANIFEST
        self._head = {"format": FORMAT, "version": VERSION, **asdict(limits)}
        self._rows: dict[str, ClipAnnotation] = {}
        if self._path.exists():
            self._read()
        self._write()
        self._file: BinaryIO = open(self._path, "ab", buffering=0)  # noqa: SIM115

    def __enter__(self) -> Manifest:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._file.close()
        self._write()

    @property
    def rows(self) -> tuple[ClipAnnotation, ...]:
        """The rows so far, in the order of the files' names."""
        return tuple(self._rows[file] for file in sorted(self._rows))

    def row(self, file: str) -> ClipAnnotation | None:
        """Return the row of a file; None where it is not done."""
        return self._rows.get(file)

    def add(self, row: ClipAnnotation) -> None:
        """Write down that a file is done; what is written is on the disk.

        Raises:
            FileFormatError: If it cannot be written.
        """
        self._rows[row.file] = row
        try:
            self._file.write(_line(row.to_row()))
            os.fsync(self._file.fileno())
        except OSError as error:
            reason = (error.strerror or str(error)).lower()
            raise FileFormatError(f"cannot be written: {reason}", path=self._path) from error

    def keep_only(self, files: set[str]) -> None:
        """Forget the files that are no longer there."""
        self._rows = {file: row for file, row in self._rows.items() if file in files}

    def _read(self) -> None:
        lines = read_bytes(self._path).split(b"\n")
        head = _parsed(lines[0])
        if head is None or head.get("format") != FORMAT or head.get("version") != VERSION:
            raise FileFormatError(
                f"is no manifest of version {VERSION}; use another folder", path=self._path
            )
        if head != self._head:
            was = {name: head.get(name) for name in ("height", "speed")}
            raise FileFormatError(
                f"was made with height={was['height']} and speed={was['speed']}; go on with "
                "these, or use another folder",
                path=self._path,
            )
        for line in lines[1:]:
            row = _parsed(line)
            try:
                known = None if row is None else ClipAnnotation.from_row(row)
            except TypeError:
                known = None
            if known is not None:
                self._rows[known.file] = known

    def _write(self) -> None:
        lines = [_line(self._head), *(_line(row.to_row()) for row in self.rows)]
        write_atomically(self._path, b"".join(lines))


def _line(content: dict[str, Any]) -> bytes:
    return json.dumps(content, ensure_ascii=False).encode() + b"\n"


def _parsed(line: bytes) -> dict[str, Any] | None:
    """Return the object of a line; None where the line is cut short."""
    try:
        content: Any = json.loads(line)
    except ValueError:
        return None
    # json gives a dict of texts, or no dict.
    return cast("dict[str, Any]", content) if isinstance(content, dict) else None
