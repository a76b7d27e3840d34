"""Which characters of a crowd a command is for, as a user names them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.arrays import Indices
from footfall.errors import ArgumentError

__all__ = ["Rows", "row_numbers"]

Rows = Sequence[int] | npt.NDArray[Any] | None
"""Row numbers, a mask, or None for all."""


def row_numbers(rows: Rows, size: int) -> Indices:
    """Return the numbers of the rows that are meant, of a crowd of `size`.

    Raises:
        ArgumentError: If they are neither row numbers nor a mask, or one does not exist.
    """
    if rows is None:
        return np.arange(size)
    chosen = np.asarray(rows)
    if chosen.dtype == np.bool_ and chosen.shape == (size,):
        return np.flatnonzero(chosen)
    if chosen.ndim != 1 or (chosen.size and not np.issubdtype(chosen.dtype, np.integer)):
        raise ArgumentError(
            f"rows of shape {chosen.shape} and type {chosen.dtype}; a list of row numbers or "
            f"a mask of shape ({size},) is needed"
        )
    if chosen.size and not (chosen.min() >= 0 and chosen.max() < size):
        raise ArgumentError(
            f"rows {chosen.min()}..{chosen.max()}; this crowd has rows 0..{size - 1}"
        )
    return chosen.astype(np.int64)
