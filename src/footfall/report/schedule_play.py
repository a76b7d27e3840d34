"""Two actions played side by side by either planner: what a score is taken from."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import permutations

import numpy as np

from footfall.arrays import Flags, Indices, Seconds
from footfall.support import Support, SupportSequence
from footfall.sync.columns import combine_column
from footfall.sync.events import enter_next_slot, reconsider
from footfall.sync.paper import synchronize_column
from footfall.sync.shares import natural_duration, spend_slot
from footfall.sync.tables import Planner, Rules, SequenceTable, rules_of
from footfall.sync.window import Window

__all__ = ["PlayedPair", "pairs_of", "play_pair"]

LONGEST = 6.0
"""How long two actions that never end are played [s]."""


@dataclass(frozen=True, eq=False)
class PlayedPair:
    """Two actions played side by side, from the moment at which the second one joins."""

    sequences: tuple[SupportSequence, SupportSequence]
    """Their supports."""

    weights: tuple[float, float]
    """Their leg weights; the first has priority, also among equals."""

    phases: Indices
    """Absolute phase index, past the end of an ended one, shape (2, slots)."""

    muted: Flags
    """Whether an action plays beside the schedule, shape (2, slots)."""

    durations: Seconds
    """How long each slot lasts, shape (slots,)."""

    results: tuple[Support, ...]
    """What the blend stands on in each slot."""

    def plays(self, action: int, slot: int) -> bool:
        """Whether an action has not ended in a slot."""
        sequence = self.sequences[action]
        return sequence.cyclic or bool(self.phases[action, slot] < len(sequence.phases))


def pairs_of(
    sequences: Mapping[str, SupportSequence],
) -> Iterator[tuple[SupportSequence, SupportSequence, int]]:
    """Return each ordered pair with each phase of the first in which the second may begin."""
    for one, other in permutations(sequences.values(), 2):
        for phase, begun in enumerate(one.phases):
            if begun.support & other.phases[0].support is not Support.CONFLICT:
                yield one, other, phase


def play_pair(
    one: SupportSequence,
    other: SupportSequence,
    phase: int,
    weights: tuple[float, float],
    planner: Planner,
) -> PlayedPair:
    """Play two actions until all that can end have ended, else for `LONGEST` seconds.

    Args:
        one: The running action, at the beginning of one of its phases.
        other: The action that joins it there with its first phase.
        phase: The phase of the running one.
        weights: Their leg weights and priorities.
        planner: Who decides.
    """
    rules = rules_of(planner)
    table, window = _begin(one, other, phase, weights, rules)
    phases: list[Indices] = []
    muted: list[Flags] = []
    results: list[Support] = []
    durations: list[float] = []
    clock = 0.0
    while window.results[0] != Support.CONFLICT:
        ended = [
            not sequence.cyclic and window.phases[i, 0] >= len(sequence.phases)
            for i, sequence in enumerate((one, other))
        ]
        if clock >= LONGEST if one.cyclic and other.cyclic else _all_over(one, other, ended):
            break
        durations.append(_duration(table, window, rules, ended))
        phases.append(window.phases[:, 0].astype(np.int64))
        muted.append(window.muted.copy())
        results.append(Support(int(window.results[0])))
        clock += durations[-1]
        spend_slot(table, window)
        enter_next_slot(table, window, rules)
    return PlayedPair(
        (one, other),
        weights,
        np.array(phases).T,
        np.array(muted).T,
        np.array(durations),
        tuple(results),
    )


def _begin(
    one: SupportSequence,
    other: SupportSequence,
    phase: int,
    weights: tuple[float, float],
    rules: Rules,
) -> tuple[SequenceTable, Window]:
    table = SequenceTable.of([one, other])
    window = Window.empty(2, 5)
    window.sequence[:] = window.age[:] = (0, 1)
    window.priority[:] = window.weight[:] = weights
    window.playing[:] = True
    window.phases[:, 0] = (phase, 0)
    window.remaining[:] = (one.phases[phase].duration, other.phases[0].duration)
    combine_column(table, window, rules, 0)
    if rules.replans:
        reconsider(table, window, rules)
    else:
        for column in range(1, window.lookahead + 1):
            synchronize_column(table, window, rules, column)
    return table, window


def _all_over(one: SupportSequence, other: SupportSequence, ended: Sequence[bool]) -> bool:
    return all(over or sequence.cyclic for over, sequence in zip(ended, (one, other), strict=True))


def _duration(table: SequenceTable, window: Window, rules: Rules, ended: Sequence[bool]) -> float:
    if rules.replans:
        return float(window.durations[0])
    votes = [
        (float(window.weight[i]), natural_duration(table, i, int(window.phases[i, 0])))
        for i in range(2)
        if not ended[i]
    ]
    return float(sum(w * d for w, d in votes) / sum(w for w, _ in votes))
