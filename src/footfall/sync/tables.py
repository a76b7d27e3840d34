"""The plain arrays on which the synchronizer works, and the rules it follows.

A character has a fixed number of *seats*; each may hold one running action. Its *window* is the
part of the schedule that is decided: column 0 is the slot being played, columns 1 to
`lookahead` are the slots to come, and one more column is only looked at when an action starts
(section 5.1: from k to k + nk + 1).

The kernels take these arrays as named tuples, which cost nothing in compiled code: an engine
builds a `Window` from the rows of its own arrays, without a copy.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from footfall.arrays import Flags, Floats, Indices, Seconds, Supports, Weights
from footfall.errors import ArgumentError, SupportSequenceError
from footfall.support import Support, SupportSequence
from footfall.sync.search_memory import new_search_memory

__all__ = [
    "ABSENT",
    "ENDED_NEUTRAL",
    "ENDED_REPEATS",
    "ENDED_STOPS",
    "Ended",
    "Planner",
    "Rules",
    "SequenceTable",
    "StartPolicy",
    "Window",
    "check_registration",
    "rules_of",
]

Planner = Literal["footfall", "paper"]
"""The default planner, or the rule of the paper as printed."""

StartPolicy = Literal["extend", "native"]
"""Whether phases may be held to make room for a start (S1), or not (S0)."""

Ended = Literal["repeat", "stop"]
"""What a clamped action does after its last phase: repeat it, or make way. The default planner
always makes it stand on both feet, and then stops it."""

ABSENT = -1
"""In `Window.phases`: an action that has left the schedule from this column on."""

ENDED_NEUTRAL = 0
"""After its last phase a clamped action stands on both feet, and should be deactivated."""

ENDED_REPEATS = 1
"""After its last phase a clamped action repeats it for ever (section 4.3)."""

ENDED_STOPS = 2
"""As `ENDED_REPEATS`, but it leaves the schedule where it makes the rule fail."""


class SequenceTable(NamedTuple):
    """Support sequences packed one after the other; sequence `s` is one row of the first three."""

    first: Indices
    """Where each sequence begins in `supports`, shape (sequences,)."""

    phase_count: Indices
    """How many phases each has, shape (sequences,)."""

    cyclic: Flags
    """Whether each starts over after its last phase, shape (sequences,)."""

    supports: Supports
    """The supports of all phases, shape (phases,)."""

    durations: Seconds
    """How long they last at their clip's own speed, plain numbers > 0, shape (phases,)."""

    whole: int
    """The support that gives way to every other one: all limbs that any of them knows."""

    @classmethod
    def of(cls, sequences: Sequence[SupportSequence]) -> SequenceTable:
        """Pack some sequences, in their order."""
        counts = np.array([len(one.phases) for one in sequences], dtype=np.int64)
        phases = [phase for one in sequences for phase in one.phases]
        whole = int(Support.DOUBLE)
        for phase in phases:
            whole |= int(phase.support)
        return cls(
            first=np.cumsum(counts) - counts,
            phase_count=counts,
            cyclic=np.array([one.cyclic for one in sequences], dtype=np.bool_),
            supports=np.array([int(phase.support) for phase in phases], dtype=np.int64),
            durations=np.array([phase.duration for phase in phases], dtype=np.float64),
            whole=whole,
        )


class Window(NamedTuple):
    """The decided part of one character's schedule. Every array is written in place."""

    playing: Flags
    """Whether a seat holds a running action that carries leg weight, shape (seats,)."""

    sequence: Indices
    """Its row of the `SequenceTable`, shape (seats,)."""

    priority: Floats
    """Its priority on the legs, shape (seats,)."""

    age: Indices
    """The order of activation, smaller = older, which settles equal priorities, shape (seats,)."""

    weight: Weights
    """Its weight on the legs that is to come, >= 0, of any common scale, shape (seats,). Only the
    default planner reads it."""

    remaining: Seconds
    """What is left of its phase of column 0 at the clip's own speed, shape (seats,). Only the
    default planner reads it."""

    held: Indices
    """For how many columns it has been held, or muted, shape (seats,)."""

    muted: Flags
    """Whether it plays beside the schedule, at its own speed and without leg weight, because
    no room can be made for it (S-19), shape (seats,)."""

    phases: Indices
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

    search: npt.NDArray[Any]
    """Working memory of the default planner: one `SearchMemory`; may be shared likewise."""

    spare_phases: Indices
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
            sequence=np.zeros(seats, dtype=np.int64),
            priority=np.zeros(seats, dtype=np.float64),
            age=np.zeros(seats, dtype=np.int64),
            weight=np.zeros(seats, dtype=np.float64),
            remaining=np.zeros(seats, dtype=np.float64),
            held=np.zeros(seats, dtype=np.int64),
            muted=np.zeros(seats, dtype=np.bool_),
            phases=np.full((seats, columns), ABSENT, dtype=np.int64),
            results=np.full(columns, int(Support.DOUBLE), dtype=np.int64),
            durations=np.zeros(columns, dtype=np.float64),
            pace=np.ones((seats, 2), dtype=np.float64),
            offset=np.zeros(1, dtype=np.float64),
            steady=np.zeros(1, dtype=np.float64),
            search=new_search_memory(),
            spare_phases=np.full((seats, columns), ABSENT, dtype=np.int64),
            spare_results=np.full(columns, int(Support.DOUBLE), dtype=np.int64),
        )

    def copy(self) -> Window:
        """Return a window with arrays of its own."""
        return Window._make(array.copy() for array in self)

    @property
    def lookahead(self) -> int:
        """How many slots after the current one are decided."""
        return self.results.shape[0] - 2


class Rules(NamedTuple):
    """What a planner does where the paper is open, or is mended."""

    ended: int
    """`ENDED_NEUTRAL`, `ENDED_REPEATS` or `ENDED_STOPS`."""

    conflicts_in_flight: bool
    """Whether a conflict among the actions on the ground counts although another one flies."""

    extends_at_start: bool
    """Whether phases may be held to make room for a start."""

    enters_anywhere: bool
    """Whether a cyclic action may enter at any of its phases."""

    stays_grounded: bool
    """Whether a start is refused that would leave no support in the whole window."""

    replans: bool
    """Whether columns 1 and later are decided anew at every event."""

    falls_back: bool
    """Whether Appendix A is used where the priority rule failed."""

    most_held: int
    """For how many columns the default planner may hold an action before it is muted (S-19)."""


MOST_HELD = 3
"""For how many columns in a row an action is made to wait at most."""


def rules_of(
    planner: Planner,
    *,
    start_policy: StartPolicy = "extend",
    ended: Ended | None = None,
    falls_back: bool = False,
) -> Rules:
    """Return the rules of a planner.

    Args:
        planner: The default planner, or the paper's rule.
        start_policy: Whether phases may be held to make room for a start. The default planner
            always may.
        ended: What a clamped action does after its last phase; in paper mode "repeat" unless
            given. The default planner always stops it.
        falls_back: Paper mode only: use Appendix A where the priority rule failed.

    Returns:
        The rules, as the kernels take them.

    Raises:
        ArgumentError: If an option is unknown or does not go with the planner.
    """
    if planner == "footfall":
        if start_policy != "extend" or ended not in (None, "stop") or falls_back:
            raise ArgumentError(
                'the start policy "native", the end "repeat" and the fallback belong to the '
                'planner "paper"; the planner is "footfall"'
            )
        return Rules(ENDED_NEUTRAL, True, True, True, True, True, False, MOST_HELD)
    if planner != "paper":
        raise ArgumentError(f'no planner {planner!r}; there are "footfall" and "paper"')
    if start_policy not in ("extend", "native"):
        raise ArgumentError(f'no start policy {start_policy!r}; there are "extend" and "native"')
    if ended not in (None, "repeat", "stop"):
        raise ArgumentError(f'{ended!r} is no end of the planner "paper"; "repeat" or "stop" is')
    end = ENDED_STOPS if ended == "stop" else ENDED_REPEATS
    return Rules(end, False, start_policy == "extend", False, False, False, falls_back, 0)


def check_registration(sequence: SupportSequence) -> None:
    """Refuse a sequence that can starve or block every other one.

    The priority rule holds an action whose next foot is the wrong one; that helps only if its
    present foot is not the same wrong one (`SupportSequence` sees to the other neighbors).

    Raises:
        SupportSequenceError: If the sequence is a cycle of a single R or L.
    """
    only = sequence.phases[0].support
    if sequence.cyclic and len(sequence.phases) == 1 and only in (Support.LEFT, Support.RIGHT):
        symbol = only.symbol
        raise SupportSequenceError(
            f"phases 0 and 0, neighbors in the cycle, are both {only.name}: a cycle of a single "
            f"{symbol} never changes feet; leave out the * or add a phase, such as {symbol} D*"
        )
