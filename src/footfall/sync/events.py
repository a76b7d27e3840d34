"""The events of a schedule, as Python calls them: a slot ends, an action starts, stops, changes.

The engine's kernels call what is behind these directly.
"""

from __future__ import annotations

from footfall.arrays import Indices
from footfall.compilation import inner_kernel, kernel
from footfall.support import Support
from footfall.sync.columns import own_phase, recombine
from footfall.sync.planner import REFUSED, plan, plan_next_slot, plan_start, weigh_entry
from footfall.sync.shares import natural_duration, spend_slot
from footfall.sync.tables import ABSENT, Rules, SequenceTable
from footfall.sync.window import Window

__all__ = [
    "enter_next_slot",
    "foresee_start",
    "reconsider",
    "release_action",
    "start_action",
    "try_entry",
]

CONFLICT = int(Support.CONFLICT)

LEAST_WAIT = 1e-3
"""A slot counts at least this long where waits are foreseen [s]."""


@kernel
def enter_next_slot(table: SequenceTable, window: Window, rules: Rules) -> bool:
    """Move the window on by one slot; as `footfall.sync.planner.plan_next_slot`."""
    return plan_next_slot(table, window, rules)


@kernel
def start_action(
    table: SequenceTable, window: Window, rules: Rules, seat: int, elapsed: float
) -> int:
    """Start an action now, if it can be; as `footfall.sync.planner.plan_start`."""
    return plan_start(table, window, rules, seat, elapsed)


@kernel
def try_entry(
    table: SequenceTable,
    window: Window,
    rules: Rules,
    seat: int,
    entry: int,
    elapsed: float,
) -> tuple[int, float]:
    """Say what would come of an entry; as `footfall.sync.planner.weigh_entry`."""
    return weigh_entry(table, window, rules, seat, entry, elapsed)


@kernel
def release_action(table: SequenceTable, window: Window, rules: Rules, seat: int) -> bool:
    """Take an action out, when its leg weight has reached zero; return as `reconsider`."""
    window.playing[seat] = False
    window.muted[seat] = False
    return _take_note(table, window, rules)


@kernel
def reconsider(table: SequenceTable, window: Window, rules: Rules) -> bool:
    """Take note of an event: a priority, an age or a set of running actions has changed.

    The default planner decides columns 1 and later anew; in paper mode the decisions stay and
    only the results follow.

    Returns:
        Whether all decided columns can be played.
    """
    return _take_note(table, window, rules)


@inner_kernel
def _take_note(table: SequenceTable, window: Window, rules: Rules) -> bool:
    if not rules.replans:
        return recombine(table, window, rules)
    plan(table, window, rules)
    return True


@kernel
def foresee_start(
    table: SequenceTable, window: Window, rules: Rules, seat: int, most: float, before: Indices
) -> tuple[int, float]:
    """Let slots pass until an action that waits can start.

    Args:
        table: All sequences.
        window: A copy of the schedule, which is spent.
        rules: The rules of the planner.
        seat: The seat of the action.
        most: How far to look [s].
        before: Written: the phase of each seat in the last slot but one, shape (seats,).

    Returns:
        How many slots it waits, and how long [s] from the moment of the last plan on; -1 slots
        if it still waits then.
    """
    seconds = 0.0
    slots = 0
    while seconds < most and window.results[0] != CONFLICT:
        seconds += _lasting(table, window, rules)
        slots += 1
        before[:] = window.phases[:, 0]
        spend_slot(table, window)
        plan_next_slot(table, window, rules)
        for other in range(window.playing.shape[0]):
            phase = window.phases[other, 0]
            if window.playing[other] and (
                own_phase(table, window.sequence[other], phase, rules.ended) == ABSENT
            ):
                window.playing[other] = False
                _take_note(table, window, rules)
        if plan_start(table, window, rules, seat, 0.0) != REFUSED:
            return slots, seconds
    return -1, seconds


@inner_kernel
def _lasting(table: SequenceTable, window: Window, rules: Rules) -> float:
    """Return how long the slot being played lasts, and something above zero in any case."""
    if rules.replans:
        return max(window.durations[0], LEAST_WAIT)
    weighted = total = 0.0
    for seat in range(window.playing.shape[0]):
        if window.playing[seat]:
            own = natural_duration(table, window.sequence[seat], window.phases[seat, 0])
            weighted += window.weight[seat] * own
            total += window.weight[seat]
    return max(weighted / total, LEAST_WAIT) if total > 0.0 else LEAST_WAIT
