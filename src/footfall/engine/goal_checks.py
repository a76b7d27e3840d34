"""What the goals of characters are checked for when they are set."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from footfall.arrays import Floats
from footfall.errors import ArgumentError

__all__ = ["check_fading", "heights_of", "places_of"]


def check_fading(weight: float, fade: float) -> None:
    """Refuse a weight that is not within 0..1, or a fade [s] that is negative or not finite.

    Raises:
        ArgumentError: If one is.
    """
    if not (math.isfinite(fade) and fade >= 0.0):
        raise ArgumentError(f"a goal that fades in {fade} s; it must be finite and >= 0")
    if not 0.0 <= weight <= 1.0:
        raise ArgumentError(f"a goal with a weight of {weight}; it must be within 0..1")


def places_of(label: str, place: npt.ArrayLike, rows: int) -> Floats:
    """Return one place a row [m], shape (rows, 3).

    Args:
        label: What messages call it.
        place: Shape (3,) or (rows, 3).
        rows: How many rows.

    Raises:
        ArgumentError: If it has another shape, or is not finite.
    """
    found = np.asarray(place, dtype=np.float64)
    if found.shape not in ((3,), (rows, 3)) or not np.isfinite(found).all():
        raise ArgumentError(
            f"{label} is {place}; it must be three finite numbers, for all or for each of {rows}"
        )
    return np.broadcast_to(found, (rows, 3))


def heights_of(label: str, height: npt.ArrayLike, rows: int) -> Floats:
    """Return places at a height [m], shape (rows, 3); as `places_of`, of shape () or (rows,)."""
    found = np.asarray(height, dtype=np.float64)
    if found.shape not in ((), (rows,)) or not np.isfinite(found).all():
        raise ArgumentError(
            f"{label} is {height}; it must be a finite number, for all or for each of {rows}"
        )
    return np.multiply.outer(np.broadcast_to(found, (rows,)), (0.0, 1.0, 0.0))
