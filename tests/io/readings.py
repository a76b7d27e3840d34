"""Files read one after another, each with how long it took and how much memory."""

from __future__ import annotations

import time
import warnings
from collections.abc import Callable
from pathlib import Path

import pytest

from footfall.errors import FootfallError

__all__ = ["MEGABYTE", "Readings"]

MEGABYTE = 1e6

STATUS, PEAK_RESET = Path("/proc/self/status"), Path("/proc/self/clear_refs")
"""Where Linux tells what memory this process takes, and lets its peak be forgotten."""


class Readings:
    """Reads one file after another, and fails where a reader does not keep its word.

    Memory is that which the process really takes, the libraries' own included. What works in a
    process of its own is limited there.
    """

    def __init__(self, reader: Callable[[Path], object], path: Path) -> None:
        self.reader = reader
        self.path = path
        self.count = self.refusals = 0
        self.longest = self.largest = 0.0

    def read(self, data: bytes) -> bool:
        """Read a file of this content, and return whether it was refused."""
        self.path.write_bytes(data)
        bound = 2.0 + 2.0 * len(data) / MEGABYTE
        refused, seconds, size = self._measured()
        for _ in range(2):
            # Another program may have had the machine: what is slow is slow again.
            if seconds > bound:
                refused, seconds, size = self._measured()
        self.count += 1
        self.refusals += refused
        self.longest, self.largest = max(self.longest, seconds), max(self.largest, size)
        assert seconds <= bound, f"took {seconds:.1f} s"
        assert size < 20 * len(data) + 64 * MEGABYTE, f"took {size / MEGABYTE:.0f} MB"
        return refused

    def _measured(self) -> tuple[bool, float, float]:
        before = _peak_from_now()
        start = time.perf_counter()
        refused = _refused(self.reader, self.path)
        seconds = time.perf_counter() - start
        return refused, seconds, _memory("VmHWM") - before

    def __str__(self) -> str:
        return (
            f"{self.refusals} of {self.count} refused, the slowest took {self.longest:.3f} s, the "
            f"greatest {self.largest / MEGABYTE:.1f} MB"
        )


def _refused(reader: Callable[[Path], object], path: Path) -> bool:
    # A fault that NumPy only warns of would be a NaN later.
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            reader(path)
        except FootfallError as error:
            return "\n" not in str(error) or pytest.fail(f"more than a line: {error}")
    return False


def _peak_from_now() -> float:
    """Forget the peak, and return what memory is taken [bytes]; zero where it is not told."""
    if not PEAK_RESET.exists():
        return 0.0
    PEAK_RESET.write_text("5")
    return _memory("VmRSS")


def _memory(what: str) -> float:
    if not PEAK_RESET.exists():
        return 0.0
    for line in STATUS.read_text().splitlines():
        if line.startswith(what):
            return 1024.0 * int(line.split()[1])
    raise LookupError(what)
