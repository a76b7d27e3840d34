"""The decided part of one character's schedule, and what its planner remembers: plain arrays.

A character has a fixed number of *seats*; each may hold one running action. Its *window* is the
part of the schedule that is decided: column 0 is the slot being played, columns 1 to
`lookahead` are the slots to come, and one more column is only looked at when an action starts
(section 5.1: from k to k + nk + 1). An engine builds a `Window` from the rows of its own arrays,
without a copy.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from footfall.arrays import Counts, Flags, Floats, Seconds, SmallFloats, SmallIndices, Supports
from footfall.errors import ArgumentError
from footfall.support import Support
from footfall.sync.search_memory import SearchMemories, new_search_memory
from footfall.sync.tables import ABSENT

__all__ = ["Window"]


class Window(NamedTuple):
    """The decided part of one character's schedule. Every array is written in place."""

    playing: Flags
    """Whether a seat holds a running action that carries leg weight, shape (seats,)."""

    sequence: SmallIndices
    """Its row of the `SequenceTable`, shape (seats,)."""

    priority: SmallFloats
    """Its priority on the legs, shape (seats,)."""

    age: Counts
    """The order of activation, smaller = older, which settles equal priorities, shape (seats,)."""

    weight: SmallFloats
    """Its weight on the legs that is to come, >= 0, of any common scale, shape (seats,). Only the
    default planner reads it."""

    remaining: Seconds
    """What is left of its phase of column 0 at the clip's own speed, shape (seats,). Only the
    default planner reads it."""

    held: Counts
    """For how many columns it has been held, or muted, shape (seats,)."""

    muted: Flags
    """Whether it plays beside the schedule, at its own speed and without leg weight, because
    no room can be made for it (S-19), shape (seats,)."""

    phases: Counts
    """Absolute phase index per column, shape (seats, lookahead + 2). A cyclic action keeps
    counting; a clamped one whose index is its count or more has ended; `ABSENT` has left.
    An index repeated in the next column is a hold."""

    results: Supports
    """The combined support of each column, shape (lookahead + 2,); CONFLICT where the rule
    failed."""

    durations: Seconds
    """How long the default planner lets each column last, shape (lookahead + 2,); the first from
    the moment of planning on, 0 where nobody is left who could go on."""

    pace: Floats
    """Clip time per clock time that it gives each action in columns 0 and 1, shape (seats, 2)."""

    offset: Seconds
    """By how much it lets column 0 last longer than the weighted mean of those who go on at its
    end, shape (1,)."""

    steady: Seconds
    """For how long the result of column 0 had lasted when that began, shape (1,)."""

    search: SearchMemories
    """Working memory of the default planner: one `SearchMemory`; may be shared likewise."""

    spare_phases: Counts
    """Working memory of the shape of `phases`; may be shared by characters of one thread."""

    spare_results: Supports
    """Working memory of the shape of `results`."""

    @classmethod
    def empty(cls, seats: int, lookahead: int) -> Window:
        """Return the window of a character that plays nothing.

        Raises:
            ArgumentError: If there is no seat or the look-ahead is less than 1 slot.
        """
        if seats < 1:
            raise ArgumentError(f"{seats} seats; a character needs at least 1")
        if lookahead < 1:
            raise ArgumentError(f"a look-ahead of {lookahead} slots; it must be at least 1")
        columns = lookahead + 2
        return cls(
            playing=np.zeros(seats, dtype=np.bool_),
            sequence=np.zeros(seats, dtype=np.int16),
            priority=np.zeros(seats, dtype=np.float32),
            age=np.zeros(seats, dtype=np.int32),
            weight=np.zeros(seats, dtype=np.float32),
            remaining=np.zeros(seats, dtype=np.float64),
            held=np.zeros(seats, dtype=np.int32),
            muted=np.zeros(seats, dtype=np.bool_),
            phases=np.full((seats, columns), ABSENT, dtype=np.int32),
            results=np.full(columns, int(Support.DOUBLE), dtype=np.int64),
            durations=np.zeros(columns, dtype=np.float64),
            pace=np.ones((seats, 2), dtype=np.float64),
            offset=np.zeros(1, dtype=np.float64),
            steady=np.zeros(1, dtype=np.float64),
            search=new_search_memory(),
            spare_phases=np.full((seats, columns), ABSENT, dtype=np.int32),
            spare_results=np.full(columns, int(Support.DOUBLE), dtype=np.int64),
        )

    def copy(self) -> Window:
        """Return a window with arrays of its own."""
        return Window._make(array.copy() for array in self)

    @property
    def lookahead(self) -> int:
        """How many slots after the current one are decided."""
        return self.results.shape[0] - 2
