"""Reads files in a process of its own, so that a crash or a hang is one line for the user.

A child is started for one file, or kept for many: within `kept_children` the same child reads one
file after another, which spares the 0.2 s of its start. Where a kept child crashes, the file in
hand is tried again in a new one before it is blamed: what crashed may have been left behind by a
file before it.
"""

from __future__ import annotations

import io
import json
import zipfile
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.errors import FileFormatError
from footfall.io.guarded_child import ChildEndedError, GuardedChild, Question

__all__ = ["keep_children", "kept_children", "memory_allowed", "read_guarded", "time_allowed"]

LEAST_SECONDS, SECONDS_PER_MEGABYTE = 2.0, 2.0
"""What reading may take: so much, and so much per megabyte of the file [s]."""

LEAST_MEMORY, MEMORY_PER_BYTE = 48_000_000, 16
"""What reading may allocate: so much, and so much per byte of the file [bytes]."""


def time_allowed(size: int) -> float:
    """Return how long reading a file of so many bytes may take [s]."""
    return LEAST_SECONDS + SECONDS_PER_MEGABYTE * size / 1e6


def memory_allowed(size: int) -> int:
    """Return how much memory reading a file of so many bytes may take [bytes]."""
    return LEAST_MEMORY + MEMORY_PER_BYTE * size


_kept: dict[Path, GuardedChild] | None = None


def keep_children() -> None:
    """Let this process keep its children from now on: for workers that read many files.

    They end when this process does: their standard input ends then.
    """
    global _kept
    _kept = {} if _kept is None else _kept


@contextmanager
def kept_children() -> Generator[None]:
    """Keep the children within a block, and end them after it."""
    global _kept
    keep_children()
    try:
        yield
    finally:
        for child in (_kept or {}).values():
            child.close()
        _kept = None


def read_guarded(
    script: Path,
    words: Sequence[str],
    data: bytes,
    path: Path,
    *,
    size: int,
    seconds: float | None = None,
) -> tuple[dict[str, Any], dict[str, npt.NDArray[Any]]]:
    """Let a script read a file in another process, and return what it answers.

    Args:
        script: The script; see `footfall.io.guarded_server` for what it holds.
        words: What it is told.
        data: The content it is given.
        path: The file, for messages.
        size: The file's [bytes]: from it follows how much memory reading it may take.
        seconds: When it is ended, from when its library is loaded [s]; by its size where not
            given.

    Returns:
        Facts by name, and arrays by name.

    Raises:
        FileFormatError: If the script says so, crashes, fails, or does not end in time.
    """
    seconds = time_allowed(size) if seconds is None else seconds
    question = Question(tuple(words), data, memory_allowed(size), seconds)
    try:
        answer = _asked(script, question)
    except ChildEndedError as ended:
        raise FileFormatError(ended.told, path=path) from None
    except OSError as error:
        raise FileFormatError(
            f"needs a process of its own to be read, which cannot be started: {error}", path=path
        ) from error
    try:
        with np.load(io.BytesIO(answer), allow_pickle=False) as stored:
            arrays = {name: stored[name] for name in stored.files}
    except (OSError, ValueError, EOFError, zipfile.BadZipFile) as error:
        raise FileFormatError("made its parser stop half-way; it is damaged", path=path) from error
    facts: dict[str, Any] = json.loads(arrays.pop("header").tobytes())
    if "error" in facts:
        raise FileFormatError(str(facts["error"]), path=path)
    return facts, arrays


def _asked(script: Path, question: Question) -> bytes:
    """Return the answer of a child, a new one where a kept one crashed."""
    kept = None if _kept is None else _kept.pop(script, None)
    child = GuardedChild(script) if kept is None else kept
    try:
        answer = child.ask(question)
    except BaseException as error:
        child.close()
        if kept is not None and isinstance(error, ChildEndedError) and error.crashed:
            return _asked(script, question)
        raise
    if _kept is None or child.worn or _kept.setdefault(script, child) is not child:
        child.close()
    return answer
