"""Names for the arrays that pass between the stages, with their units.

An alias names the meaning of the last axes; a docstring that uses it says which axes lead.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = [
    "Counts",
    "Flags",
    "Floats",
    "Indices",
    "Positions",
    "Rotations",
    "Seconds",
    "SmallFloats",
    "SmallIndices",
    "Supports",
    "Weights",
    "frozen",
]

Floats = npt.NDArray[np.float64]
"""Any real numbers; the docstring says which."""

SmallFloats = npt.NDArray[np.float32]
"""The same in single precision: packed keys, and what a character has no need to know better."""

Positions = npt.NDArray[np.float64]
"""Points or displacements [m], shape (..., 3), y up."""

Rotations = npt.NDArray[np.float64]
"""Unit quaternions wxyz, shape (..., 4)."""

Weights = npt.NDArray[np.float64]
"""Shares >= 0; the docstring says over which axis they sum to one."""

Seconds = npt.NDArray[np.float64]
"""Times or durations [s]."""

Supports = npt.NDArray[np.int64]
"""Values of `footfall.support.Support`."""

Indices = npt.NDArray[np.int64]
"""Indices of joints, frames, phases or slots."""

SmallIndices = npt.NDArray[np.int16]
"""The same where there are few, in the records of characters."""

Counts = npt.NDArray[np.int32]
"""Indices of phases or commands that go on for hours."""

Flags = npt.NDArray[np.bool_]
"""Booleans; the docstring says what is claimed."""


def frozen(array: npt.ArrayLike, dtype: npt.DTypeLike = np.float64) -> npt.NDArray[Any]:
    """Return a read-only contiguous copy of `array`, for a field of a frozen value."""
    copy = np.array(array, dtype=dtype, order="C")
    copy.setflags(write=False)
    return copy
