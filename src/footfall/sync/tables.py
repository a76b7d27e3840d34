"""The sequences as the synchronizer takes them, and the rules it follows.

The kernels take named tuples of plain arrays, which cost nothing in compiled code.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np

from footfall.arrays import Flags, Indices, Seconds, Supports
from footfall.errors import ArgumentError, SupportSequenceError
from footfall.support import Support, SupportSequence

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
    "check_limbs",
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


def check_limbs(sequences: Sequence[SupportSequence], planner: Planner) -> None:
    """Refuse limbs beside the feet to the rule of the paper.

    Raises:
        ArgumentError: If it is asked to synchronize one.
    """
    if planner != "paper":
        return
    for number, sequence in enumerate(sequences):
        for phase in sequence.phases:
            if phase.support > Support.DOUBLE:
                raise ArgumentError(
                    f"sequence {number} stands on {phase.support.symbol}; the rule of the paper "
                    'knows two feet, R L D and -, and the planner "footfall" any limbs'
                )
