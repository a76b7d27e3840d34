"""Files damaged in the ways in which files get damaged, and in some in which attackers do it."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator

__all__ = ["mutated", "mutations"]

NUMBERS = (
    b"nan", b"inf", b"-1", b"0", b"1e999", b"-1e-320", b"4294967295", b"9" * 30, b"2147483648",
    b"1e12", b"0x10", b"1_000", b"-0.0", b"1e6", b"65536", b"999999",
)  # fmt: skip
WORDS = (b"{", b"}", b"[", b"]", b'"', b",", b"\x00", b"\xff\xfe", b"null", b"true", b"[[[[", b"\r")
_NUMBER = re.compile(rb"-?\d+\.?\d*(?:[eE][+-]?\d+)?")


def mutated(data: bytes, chance: random.Random) -> bytes:
    """Return data with one to four changes."""
    for _ in range(chance.choice((1, 1, 1, 2, 4))):
        data = _changed(data, chance)
    return data


def mutations(data: bytes, count: int, seed: int) -> Iterator[bytes]:
    """Yield so many damaged copies of data, always the same ones."""
    chance = random.Random(seed)
    for _ in range(count):
        yield mutated(data, chance)


def _changed(data: bytes, chance: random.Random) -> bytes:
    if not data:
        return b"\x00"
    at = chance.randrange(len(data))
    end = min(len(data), at + chance.choice((1, 2, 4, 16, 200)))
    match chance.randrange(9):
        case 0:
            return data[:at]
        case 1:
            return data[:at] + bytes([data[at] ^ (1 << chance.randrange(8))]) + data[at + 1 :]
        case 2:
            return data[:at] + chance.randbytes(end - at) + data[end:]
        case 3:
            return data[:at] + data[end:]
        case 4:
            return data[:end] + data[at:]
        case 5:
            return data[:at] + chance.choice(WORDS) + data[at:]
        case 6:
            four = chance.choice((0, 1, 255, 2**31 - 1, 2**32 - 1)).to_bytes(4, "little")
            return data[:at] + four + data[at + 4 :]
        case _:
            return _other_number(data, at, chance)


def _other_number(data: bytes, at: int, chance: random.Random) -> bytes:
    """Return data with another number in place of the first one after a place."""
    match = _NUMBER.search(data, at) or _NUMBER.search(data)
    if match is None:
        return data
    return data[: match.start()] + chance.choice(NUMBERS) + data[match.end() :]
