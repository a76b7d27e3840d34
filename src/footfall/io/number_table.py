"""Numbers in text, parsed at once: what makes a large BVH file quick to read.

A table is rows of numbers separated by blanks, one row a line, nothing else. The kernel reads
decimal notation only (no nan, no inf, no hexadecimal) and gives, digit for digit, what Python's
`float` gives: up to 2⁵³ and within 10^±22 one rounded operation is exact (Clinger 1990, "How to
read floating point numbers accurately"); the few numbers beyond are left to `float`.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from footfall.arrays import Floats, Indices
from footfall.compilation import kernel

__all__ = ["parse_table"]

Bytes = npt.NDArray[np.uint8]

_POWERS = np.array([float(f"1e{power}") for power in range(23)])
_EXACT = 2**53
_LINE_END, _PLUS, _MINUS, _POINT, _ZERO, _NINE = 10, 43, 45, 46, 48, 57
_LOWER_E, _UPPER_E = 101, 69


def parse_table(text: bytes, rows: int, columns: int) -> Floats | None:
    """Return the numbers of a table, shape (rows, columns), or None where it is no such table.

    Args:
        text: The lines; blank ones are skipped.
        rows: How many lines are not blank.
        columns: How many numbers stand in each.
    """
    # Each number takes a character at least: a false promise of columns is not allocated.
    if rows * columns > len(text):
        return None
    table = np.empty(rows * columns)
    left = np.empty((rows * columns, 3), dtype=np.int64)
    count = _parse(np.frombuffer(text, dtype=np.uint8), columns, _POWERS, table, left)
    if count < 0:
        return None
    for index, begin, end in left[:count].tolist():
        table[index] = float(text[begin:end])
    return table.reshape(rows, columns)


@kernel
def _parse(text: Bytes, columns: int, powers: Floats, table: Floats, left: Indices) -> int:
    """Write the numbers; note index, begin and end of those beyond; return how many, or -1."""
    index = 0
    in_row = 0
    beyond = 0
    at = 0
    while at < text.size:
        byte = int(text[at])
        if byte == _LINE_END:
            if in_row not in (0, columns):
                return -1
            in_row = 0
            at += 1
        elif byte == 32 or 9 <= byte <= 13:
            at += 1
        else:
            if in_row == columns or index == table.size:
                return -1
            end, mantissa, scale = _number(text, at)
            if end < 0:
                return -1
            if mantissa >= _EXACT or abs(scale) > 22:
                left[beyond, 0] = index
                left[beyond, 1] = at
                left[beyond, 2] = end
                beyond += 1
                value = 0.0
            elif scale < 0:
                value = mantissa / powers[-scale]
            else:
                value = mantissa * powers[scale]
            table[index] = -value if byte == _MINUS else value
            index += 1
            in_row += 1
            at = end
    if in_row not in (0, columns) or index != table.size:
        return -1
    return beyond


@kernel
def _number(text: Bytes, at: int) -> tuple[int, int, int]:
    """Return where a number ends (-1 where none stands), its digits, and its power of ten."""
    if text[at] == _PLUS or text[at] == _MINUS:
        at += 1
    mantissa = 0
    scale = 0
    digits = 0
    point = False
    while at < text.size:
        byte = int(text[at])
        if _ZERO <= byte <= _NINE:
            digits += 1
            # Beyond the limit no further digit is kept: `float` reads such a number anyway.
            if mantissa < _EXACT:
                mantissa = 10 * mantissa + (byte - _ZERO)
                scale -= point
        elif byte == _POINT and not point:
            point = True
        else:
            break
        at += 1
    if digits == 0:
        return -1, 0, 0
    if at < text.size and (text[at] == _LOWER_E or text[at] == _UPPER_E):
        at, exponent = _exponent(text, at + 1)
        if at < 0:
            return -1, 0, 0
        scale += exponent
    if at < text.size and not (text[at] == 32 or 9 <= text[at] <= 13):
        return -1, 0, 0
    return at, mantissa, scale


@kernel
def _exponent(text: Bytes, at: int) -> tuple[int, int]:
    """Return where an exponent ends (-1 where none stands), and what it is."""
    negative = False
    if at < text.size and (text[at] == _PLUS or text[at] == _MINUS):
        negative = text[at] == _MINUS
        at += 1
    first = at
    exponent = 0
    while at < text.size and _ZERO <= text[at] <= _NINE:
        exponent = min(10 * exponent + (int(text[at]) - _ZERO), 100_000)
        at += 1
    if at == first:
        return -1, 0
    return at, -exponent if negative else exponent
