"""The events of a schedule, as Python calls them: a slot ends, an action starts, stops, changes.

The engine's kernels call what is behind these directly.
"""

from __future__ import annotations

from footfall.compilation import inner_kernel, kernel
from footfall.sync.columns import recombine
from footfall.sync.planner import plan, plan_next_slot, plan_start, weigh_entry
from footfall.sync.tables import Rules, SequenceTable, Window

__all__ = ["enter_next_slot", "reconsider", "release_action", "start_action", "try_entry"]


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
