"""What is laid over what plays: the layers of a library, and what a character remembers of its own.

The record of a layer is the last part of that of a character, and small: most lay none.
"""

from __future__ import annotations

from typing import NamedTuple, Protocol

import numpy as np

from footfall.arrays import SmallFloats
from footfall.engine.entry import Entries

__all__ = [
    "LAYERS",
    "LEAVES",
    "LIES",
    "NOTHING",
    "LayerSeat",
    "LayerSeats",
    "LayerShelf",
    "layer_seat_type",
]

LAYERS = 4
"""How many layers a character can have on at the same time, those that fade out included."""

NOTHING, LIES, LEAVES = 0, 1, 2
"""Values of `LayerSeat.status`: none, one that fades in or is there, one that fades out."""


class LayerSeat:
    """One layer of one character: a record of `layer_seat_type`."""

    time: float
    """Where its clip is; that of a cycle starts over [s]."""

    before: float
    """Its weight as its present fade began."""

    goal: float
    """Its weight when that is over."""

    progress: float
    """How far that is, 0 to 1."""

    layer: int
    """Which layer of the library."""

    status: int
    """`NOTHING`, `LIES` or `LEAVES`."""


class LayerSeats(Protocol):
    """The layers of one character, shape (layers,)."""

    def __getitem__(self, seat: int) -> LayerSeat:
        """Return one of them."""
        ...


layer_seat_type = np.dtype(
    [
        ("time", np.float32),
        ("before", np.float32),
        ("goal", np.float32),
        ("progress", np.float32),
        ("layer", np.int16),
        ("status", np.int16),
    ]
)
"""The memory layout of `LayerSeat`: 20 bytes."""


class LayerShelf(NamedTuple):
    """The layers of a library, packed for the kernels."""

    keys: SmallFloats
    """By how much each joint is turned from the reference, in its parent's frame, by component as
    in `Shelf.keys`, one layer after the other; joints of other body parts, and the feet, are not
    turned. Shape (frames, 4 rows + 8)."""

    entries: Entries
    """One record of `entry_type` for each, without phases or priorities; one that is not cyclic
    leaves by itself. Shape (layers,)."""
