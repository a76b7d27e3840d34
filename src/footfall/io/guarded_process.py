"""Runs a script in a process of its own, so that its crash or its hang is one line for the user."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from footfall.errors import FileFormatError

__all__ = ["run_guarded", "time_allowed"]

START_SECONDS = 20.0
"""For Python and the library to start, on a busy machine [s]."""

SECONDS_PER_MEGABYTE = 2.0
"""What reading may take beyond that [s]."""


def time_allowed(size: int) -> float:
    """Return how long reading a file of so many bytes may take [s]."""
    return START_SECONDS + SECONDS_PER_MEGABYTE * size / 1e6


def run_guarded(
    script: Path, words: Sequence[str], data: bytes, path: Path, *, seconds: float
) -> bytes:
    """Run a Python script on the content of a file, and return what it writes.

    A new interpreter is started, rather than a `multiprocessing` child, so that programs need no
    ``if __name__ == "__main__"`` to read a file.

    Args:
        script: The script.
        words: Its arguments.
        data: What it reads from its standard input.
        path: The file the data is from, for messages.
        seconds: When it is ended.

    Raises:
        FileFormatError: If the script crashes, fails, or does not end in time.
    """
    # -P: the script's own folder must not hide a library by a module of the same name.
    command = [sys.executable, "-P", str(script), *words]
    try:
        done = subprocess.run(command, input=data, capture_output=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        raise FileFormatError(
            f"was still being read after {seconds:.0f} s, and was given up; it is damaged, or "
            "far too large",
            path=path,
        ) from None
    except OSError as error:
        raise FileFormatError(
            f"needs a process of its own to be read, which cannot be started: {error}", path=path
        ) from error
    if done.returncode != 0:
        last = done.stderr.decode(errors="replace").strip().splitlines()[-1:]
        told = f": {last[0][:160]}" if last else ""
        raise FileFormatError(
            f"made its parser fail (exit code {done.returncode}){told}; the file is damaged, or "
            "holds what the parser does not know",
            path=path,
        )
    return done.stdout
