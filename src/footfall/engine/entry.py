"""What the library knows of one motion, as the kernels take it: a record."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from footfall.arrays import Floats
from footfall.skeleton import BodyPart

__all__ = ["Entries", "Entry", "entry_type"]


class Entry:
    """What the library knows of one action: a record of `entry_type`."""

    first_frame: int
    """Where its clip begins in `Shelf.keys`."""

    frame_count: int
    """How many frames it has."""

    fps: float
    """Its frames per second."""

    duration: float
    """Its time from first to last frame [s]."""

    cyclic: bool
    """Whether it starts over."""

    phase_first: int
    """Where its phases begin in `Shelf.phase_starts`."""

    phase_count: int
    """How many phases it has."""

    priorities: Floats
    """Priority on each body part, >= 0, shape (parts,)."""

    fade_in: float
    """How long a start should take to become complete [s]."""

    fade_out: float
    """The same for a stop."""


entry_type = np.dtype(
    [
        ("first_frame", np.int64),
        ("frame_count", np.int64),
        ("fps", np.float64),
        ("duration", np.float64),
        ("cyclic", np.int8),
        ("phase_first", np.int64),
        ("phase_count", np.int64),
        ("priorities", np.float64, (len(BodyPart),)),
        ("fade_in", np.float64),
        ("fade_out", np.float64),
    ],
    align=True,
)
"""The memory layout of `Entry`."""


class Entries(Protocol):
    """An array of `Entry` records, shape (actions,)."""

    @property
    def shape(self) -> tuple[int, ...]:
        """How many actions there are, as a tuple of one."""
        ...

    def __getitem__(self, action: int) -> Entry:
        """Return what is known of one action."""
        ...
