"""The MOTION half of a BVH file: its frames as one array, read strictly and at once."""

from __future__ import annotations

import re
from dataclasses import dataclass
from decimal import Decimal, localcontext
from pathlib import Path

import numpy as np

from footfall.arrays import Floats
from footfall.errors import FileFormatError
from footfall.io.bvh_hierarchy import GREATEST, finite_number
from footfall.io.number_table import parse_table

__all__ = ["BvhMotion", "parse_motion"]

_FRAMES = re.compile(r"\s*frames\s*:\s*(\S.*?)?\s*", re.IGNORECASE)
_FRAME_TIME = re.compile(r"\s*frame\s*time\s*:\s*(\S.*?)?\s*", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class BvhMotion:
    """The frames of a file."""

    values: Floats
    """One row a frame, one column a channel, as in the file, shape (frames, channels)."""

    declared_frames: int
    """What ``Frames:`` says; one less than there are, where a file holds one too many."""

    frame_time: Decimal
    """What ``Frame Time:`` says, digit by digit [s]."""


def parse_motion(lines: list[str], first: int, channels: int, path: Path) -> BvhMotion:
    """Read the frames.

    Args:
        lines: The lines of the file.
        first: Index of the line on which MOTION is looked for.
        channels: How many values a frame has.
        path: The file, for messages.

    Raises:
        FileFormatError: If a keyword is missing, a count is wrong, or a value is no finite
            number. One whole frame more than declared is read and left to the caller to tell:
            it is common, and loses nothing.
    """
    motion = _next_line(lines, first, path, "MOTION")
    if lines[motion].split() != ["MOTION"]:
        raise FileFormatError(
            f"MOTION is expected after the hierarchy, not {lines[motion].strip()[:40]!r}",
            path=path,
            line=motion + 1,
        )
    declared, counted = _declared_frames(lines, motion + 1, path)
    frame_time, timed = _frame_time(lines, counted + 1, path)
    rows = [index for index in range(timed + 1, len(lines)) if lines[index].strip()]
    if not rows:
        raise FileFormatError(
            f"no frame follows Frame Time, though {declared} are declared; the file was cut short",
            path=path,
            line=timed + 1,
        )
    values = _values(lines, rows, channels, path)
    if not declared <= len(rows) <= declared + 1:
        fault = "was cut short" if len(rows) < declared else "holds something else"
        raise FileFormatError(
            f"{declared} frames are declared, but {len(rows)} follow; the file {fault}, "
            f"or else it should say Frames: {len(rows)}",
            path=path,
            line=counted + 1,
        )
    return BvhMotion(values, declared, frame_time)


def _next_line(lines: list[str], first: int, path: Path, wanted: str) -> int:
    for index in range(first, len(lines)):
        if lines[index].strip():
            return index
    raise FileFormatError(
        f"the file ends where {wanted} is expected; it was cut short",
        path=path,
        line=max(len(lines), 1),
    )


def _declared_frames(lines: list[str], first: int, path: Path) -> tuple[int, int]:
    index = _next_line(lines, first, path, "Frames:")
    match = _FRAMES.fullmatch(lines[index])
    count = match[1] if match is not None else None
    if count is None or not (count.isascii() and count.isdigit() and len(count) < 10):
        raise FileFormatError(
            f"'Frames:' and a whole number are expected, not {lines[index].strip()[:40]!r}",
            path=path,
            line=index + 1,
        )
    if int(count) == 0:
        raise FileFormatError(
            "the file declares no frames; a motion needs at least one", path=path, line=index + 1
        )
    return int(count), index


def _frame_time(lines: list[str], first: int, path: Path) -> tuple[Decimal, int]:
    index = _next_line(lines, first, path, "Frame Time:")
    match = _FRAME_TIME.fullmatch(lines[index])
    seconds = match[1] if match is not None else None
    value = finite_number(seconds) if seconds is not None else None
    if seconds is None or value is None:
        raise FileFormatError(
            f"'Frame Time:' and a number of seconds are expected, not "
            f"{lines[index].strip()[:40]!r}",
            path=path,
            line=index + 1,
        )
    if not 1e-6 <= value <= 1e6:
        raise FileFormatError(
            f"a frame lasts {seconds} s; it must last longer than zero, "
            "such as 0.033333 for 30 frames per second",
            path=path,
            line=index + 1,
        )
    with localcontext() as context:
        context.prec = 50
        return +Decimal(seconds), index


def _values(lines: list[str], rows: list[int], channels: int, path: Path) -> Floats:
    """Parse all rows at once; only where that fails, look for the line that is to blame."""
    text = "\n".join(lines[rows[0] :]).encode("latin-1", errors="replace")
    values = parse_table(text, len(rows), channels)
    if values is not None and (np.abs(values) < GREATEST).all():
        return values
    for frame, row in enumerate(rows):
        words = lines[row].split()
        if len(words) != channels:
            cut = frame == len(rows) - 1 and len(words) < channels
            hint = "; the file was cut short" if cut else ""
            raise FileFormatError(
                f"frame {frame} has {len(words)} values, but the hierarchy declares "
                f"{channels} channels{hint}",
                path=path,
                line=row + 1,
            )
        for column, word in enumerate(words):
            if finite_number(word) is None:
                raise FileFormatError(
                    f"value {column + 1} of frame {frame} is {word[:40]!r}, which is no finite "
                    "number below 1e12",
                    path=path,
                    line=row + 1,
                )
    raise FileFormatError("its frames are no plain table of numbers", path=path)
