"""Damaged files: cut short, with bytes changed, dropped, doubled, and numbers made absurd."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

__all__ = ["mutations"]

ABSURD = (b"nan", b"-1", b"1e308", b"99999999999999999999", b"0", b"", b"inf")
NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def mutations(data: bytes, count: int, seed: int) -> Iterator[bytes]:
    """Yield so many damaged files, always the same ones."""
    random = np.random.default_rng(seed)
    numbers = [match.span() for match in NUMBER.finditer(data[:50_000])]
    for _ in range(count):
        kind = int(random.integers(6))
        damaged = bytearray(data)
        at = int(random.integers(len(data)))
        if kind == 0:
            del damaged[at:]
        elif kind == 1:
            for place in random.integers(0, len(data), int(random.integers(1, 9))).tolist():
                damaged[place] = int(random.integers(256))
        elif kind == 2:
            del damaged[at : at + int(random.integers(1, 64))]
        elif kind == 3:
            damaged[at:at] = damaged[at : at + int(random.integers(1, 64))]
        elif kind == 4:
            damaged[at : at + 4] = int(random.choice([0, 1, 2**31 - 1, 2**32 - 1])).to_bytes(
                4, "little"
            )
        elif numbers:
            start, end = numbers[int(random.integers(len(numbers)))]
            damaged[start:end] = ABSURD[int(random.integers(len(ABSURD)))]
        yield bytes(damaged)
