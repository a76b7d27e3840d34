"""Supports as a table, for those who keep labels in spreadsheets or in columns.

A table has one of two forms, told by its columns:

- one row a phase: ``support`` (R, L, D or -), ``start`` and ``seconds`` [s], ``cyclic``;
- one row a frame: ``time`` [s], and ``support``, or else ``left`` and ``right`` (whether each foot
  carries). The support changes half-way between two frames.

Other columns are not looked at.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from footfall.errors import FileFormatError, SupportSequenceError
from footfall.support import Support, SupportPhase, SupportSequence

__all__ = ["FRAME_COLUMNS", "PHASE_COLUMNS", "frame_columns", "phase_columns", "supports_of"]

PHASE_COLUMNS = ("support", "start", "seconds", "cyclic")
"""Of a table with one row a phase, in the order in which they are written."""

FRAME_COLUMNS = ("time", "support", "left", "right")
"""Of a table with one row a frame."""

UNEVEN = 0.01
"""Two frames may be this share of the usual time further apart, or nearer."""

_TRUE = {"true", "1", "yes", "1.0"}
_FALSE = {"false", "0", "no", "0.0"}

Columns = Mapping[str, Sequence[Any]]
"""The cells of a table by the names of its columns, each as long as the others."""


def phase_columns(sequence: SupportSequence) -> dict[str, list[Any]]:
    """Return a sequence as a table with one row a phase; nothing of it is lost."""
    return {
        "support": [phase.support.symbol for phase in sequence.phases],
        "start": list(sequence.boundaries[:-1]),
        "seconds": [phase.duration for phase in sequence.phases],
        "cyclic": [sequence.cyclic] * len(sequence.phases),
    }


def frame_columns(sequence: SupportSequence, fps: float, frames: int) -> dict[str, list[Any]]:
    """Return a sequence as a table with one row a frame.

    Args:
        sequence: The supports.
        fps: Frames per second, > 0.
        frames: How many.
    """
    times = [frame / fps for frame in range(frames)]
    supports = [sequence.support_at(time) for time in times]
    return {
        "time": times,
        "support": [support.symbol for support in supports],
        "left": [support.left for support in supports],
        "right": [support.right for support in supports],
    }


def supports_of(columns: Columns, path: Path) -> SupportSequence:
    """Return the supports that a table means.

    Args:
        columns: Its cells.
        path: The file, for messages; its line 1 holds the names of the columns.

    Raises:
        FileFormatError: If the columns are of neither form, or a cell is not what it should be.
    """
    if not columns or not len(next(iter(columns.values()))):
        raise FileFormatError("holds no row; each phase or each frame is one", path=path)
    try:
        if {"support", "seconds"} <= columns.keys():
            return _from_phases(columns, path)
        if "time" in columns and ("support" in columns or {"left", "right"} <= columns.keys()):
            return _from_frames(columns, path)
    except SupportSequenceError as error:
        raise FileFormatError(str(error), path=path) from error
    there = ", ".join(str(name) for name in columns)[:120]
    raise FileFormatError(
        f"has the columns {there}; it needs support and seconds (one row a phase), or time and "
        "support, or time, left and right (one row a frame)",
        path=path,
    )


def _from_phases(columns: Columns, path: Path) -> SupportSequence:
    phases = tuple(
        SupportPhase(_support(symbol, path, line), _number("seconds", seconds, path, line))
        for line, (symbol, seconds) in enumerate(
            zip(columns["support"], columns["seconds"], strict=True), start=2
        )
    )
    flags = columns.get("cyclic", ["false"] * len(phases))
    claims = {_flag("cyclic", flag, path, line) for line, flag in enumerate(flags, start=2)}
    if len(claims) > 1:
        raise FileFormatError("is cyclic in some rows and not in others", path=path)
    start = _number("start", columns["start"][0], path, 2) if "start" in columns else 0.0
    return SupportSequence(phases, claims.pop(), start)


def _from_frames(columns: Columns, path: Path) -> SupportSequence:
    times = [_number("time", time, path, line) for line, time in enumerate(columns["time"], 2)]
    if len(times) < 2:
        raise FileFormatError("holds a single frame, which lasts no time", path=path)
    usual = (times[-1] - times[0]) / (len(times) - 1)
    for index in range(1, len(times)):
        step = times[index] - times[index - 1]
        if not abs(step - usual) <= UNEVEN * usual:
            raise FileFormatError(
                f"this frame comes {step:g} s after the one before, but most come after "
                f"{usual:g} s; frames must be evenly spaced",
                path=path,
                line=index + 2,
            )
    supports = _frame_supports(columns, path)
    begins = [index for index in range(len(times)) if index == 0 or _changes(supports, index)]
    bounds = [0.0, *((index - 0.5) * usual for index in begins[1:]), (len(times) - 1) * usual]
    return SupportSequence(
        tuple(
            SupportPhase(supports[begin], bounds[place + 1] - bounds[place])
            for place, begin in enumerate(begins)
        )
    )


def _changes(supports: Sequence[Support], index: int) -> bool:
    return supports[index] is not supports[index - 1]


def _frame_supports(columns: Columns, path: Path) -> list[Support]:
    if "support" in columns:
        return [_support(cell, path, line) for line, cell in enumerate(columns["support"], 2)]
    return [
        Support.from_feet(_flag("left", left, path, line), _flag("right", right, path, line))
        for line, (left, right) in enumerate(
            zip(columns["left"], columns["right"], strict=True), start=2
        )
    ]


def _support(cell: Any, path: Path, line: int) -> Support:
    symbol = str(cell).strip()
    if symbol not in ("R", "L", "D", "-"):
        raise FileFormatError(
            f"support is {symbol[:40]!r}; it must be R, L, D or -", path=path, line=line
        )
    return Support.from_symbol(symbol)


def _number(name: str, cell: Any, path: Path, line: int) -> float:
    try:
        number = float(cell)
    except (TypeError, ValueError):
        number = math.nan
    if not math.isfinite(number):
        raise FileFormatError(
            f"{name} is {str(cell)[:40]!r}; it must be a finite number of seconds",
            path=path,
            line=line,
        )
    return number


def _flag(name: str, cell: Any, path: Path, line: int) -> bool:
    word = str(cell).strip().lower()
    if word not in _TRUE | _FALSE:
        raise FileFormatError(
            f"{name} is {str(cell)[:40]!r}; it must be true or false, or 1 or 0",
            path=path,
            line=line,
        )
    return word in _TRUE
