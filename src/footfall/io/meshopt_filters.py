"""Filters of EXT_meshopt_compression: what compresses well, turned back into vertex data."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["FILTERS"]

Bytes = npt.NDArray[np.uint8]


def _unfiltered(vertices: Bytes) -> npt.NDArray[Any]:
    return vertices


def _octahedral(vertices: Bytes) -> npt.NDArray[Any]:
    """Return unit vectors that were folded onto a square; the fourth number is left alone."""
    kind: Any = np.int8 if vertices.shape[1] == 4 else np.int16
    stored = vertices.view(kind).reshape(-1, 4)
    x, y, one = (stored[:, column].astype(np.float64) for column in range(3))
    z = one - np.abs(x) - np.abs(y)
    fold = np.minimum(z, 0.0)
    x = x + np.where(x >= 0.0, fold, -fold)
    y = y + np.where(y >= 0.0, fold, -fold)
    length = np.sqrt(x * x + y * y + z * z)
    scale = np.iinfo(kind).max / np.where(length > 0.0, length, 1.0)
    result = stored.copy()
    for column, values in enumerate((x, y, z)):
        result[:, column] = _rounded(values * scale)
    return result


def _quaternion(vertices: Bytes) -> npt.NDArray[Any]:
    """Return quaternions of which the largest number was left out."""
    stored = vertices.view(np.int16).reshape(-1, 4)
    last = stored[:, 3].astype(np.int64)
    scale = np.sqrt(0.5) / (last | 3)
    parts = stored[:, :3] * scale[:, np.newaxis]
    largest = np.sqrt(np.maximum(0.0, 1.0 - (parts * parts).sum(axis=1)))
    result = np.empty_like(stored)
    rows = np.arange(len(stored))
    for offset, values in enumerate((*parts.T, largest)):
        place = ((last & 3) + 1 + offset) & 3
        result[rows, place] = _rounded(values * 32767.0)
    return result


def _exponential(vertices: Bytes) -> npt.NDArray[Any]:
    """Return numbers of a mantissa of 24 bits and an exponent of 8."""
    stored = vertices.view(np.int32)
    mantissas = (stored << 8) >> 8
    with np.errstate(over="ignore"):
        return np.ldexp(mantissas.astype(np.float64), stored >> 24).astype(np.float32)


def _rounded(values: npt.NDArray[np.float64]) -> npt.NDArray[np.int64]:
    """Return the nearest whole numbers, halves away from zero."""
    return (values + np.where(values >= 0.0, 0.5, -0.5)).astype(np.int64)


FILTERS: Mapping[str, Callable[[Bytes], npt.NDArray[Any]]] = {
    "NONE": _unfiltered,
    "OCTAHEDRAL": _octahedral,
    "QUATERNION": _quaternion,
    "EXPONENTIAL": _exponential,
}
"""What undoes each filter: from bytes, shape (count, stride), to the numbers of the elements."""
