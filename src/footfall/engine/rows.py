"""Rows of a crowd: which ones a caller means, and where they are put."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.arrays import Indices
from footfall.errors import ArgumentError

__all__ = ["Rows", "check_present", "check_rows", "place_characters"]

Rows = Sequence[int] | npt.NDArray[Any] | None
"""Row numbers, a mask, or None for all."""


def check_rows(rows: Rows, size: int) -> Indices:
    """Return the numbers of some rows of a crowd.

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


def check_present(rows: Rows, characters: npt.NDArray[Any]) -> Indices:
    """Return the numbers of some rows of a crowd in which there is somebody; None means all those.

    Raises:
        ArgumentError: As `check_rows`, or if somebody has been removed.
    """
    if rows is None:
        return np.flatnonzero(characters["present"])
    chosen = check_rows(rows, len(characters))
    gone = chosen[characters["present"][chosen] == 0]
    if len(gone):
        raise ArgumentError(f"nobody is in row {gone[0]}; whoever was has been removed")
    return chosen


def place_characters(
    characters: npt.NDArray[Any],
    rows: Indices,
    position: npt.ArrayLike,
    heading: npt.ArrayLike,
) -> None:
    """Put characters at x and z [m], turned by a heading [rad]; footprints are forgotten.

    Raises:
        ArgumentError: If a number is not finite.
    """
    places = np.broadcast_to(np.asarray(position, dtype=np.float64), (len(rows), 2))
    headings = np.broadcast_to(np.asarray(heading, dtype=np.float64), (len(rows),))
    if not (np.isfinite(places).all() and np.isfinite(headings).all()):
        raise ArgumentError("a position or heading is not finite; finite numbers are needed")
    characters["root"][rows, :2] = places
    characters["root"][rows, 2] = headings
    for field in ("foot_offset", "foot_velocity", "toe_velocity"):
        characters[field][rows] = 0.0
    characters["placed"][rows] = True
