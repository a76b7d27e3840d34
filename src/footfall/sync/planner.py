"""The default planner: who goes on and who waits, chosen over a horizon of seconds.

Motions keep their own speed and feet agree as far as both are possible (`footfall.sync.prices`).
The search (`footfall.sync.look_ahead`) sees only columns that can be played, with nobody held
too long or made to run too fast or too slow. Where no such column is left, the first
action in order of priority that finds no room is *muted* (S-19): it plays on beside the others
at its own speed, without a vote and without leg weight, until there is room for it again. The
first of all always finds room, so a schedule never fails and nobody waits for ever.

All but the slot being played is decided anew at each event (`footfall.sync.events`).
"""

from __future__ import annotations

import math
from typing import cast

import numpy as np

from footfall.compilation import inlined_kernel, inner_kernel
from footfall.sync import paper
from footfall.sync.columns import combine_column
from footfall.sync.look_ahead import choose_path, first_blocked, gather_lanes, plant_root
from footfall.sync.path import write_path
from footfall.sync.prices import TIME_VALUE
from footfall.sync.search_memory import LANES
from footfall.sync.shares import natural_duration
from footfall.sync.tables import ABSENT, Rules, SequenceTable
from footfall.sync.window import Window

__all__ = [
    "ENTERS",
    "NEVER_LANDS",
    "NO_ROOM",
    "ON_THE_OTHER_FOOT",
    "REFUSED",
    "plan",
    "plan_next_slot",
    "plan_start",
    "weigh_entry",
]

REFUSED = -1  # What `plan_start` returns where no entry can be synchronized.

ENTERS, ON_THE_OTHER_FOOT, NO_ROOM, NEVER_LANDS = 0, 1, 2, 3
"""What `weigh_entry` returns: it can enter; it conflicts at once; later somebody would have to be
muted; no foot would touch the ground."""

# Typed numbers: a literal would have everything that it is passed to compiled twice.
FIRST, NOBODY = cast(int, np.int64(0)), cast(int, np.int64(-1))

SAME_COST = 1e-9
"""Costs closer than this are equal, and the first entry is taken."""


@inlined_kernel
def plan_next_slot(table: SequenceTable, window: Window, rules: Rules) -> bool:
    """Move the window on by one slot, and decide the columns to come.

    For the default planner `footfall.sync.shares.finish_slot` has been called, and then
    `remaining` set for column 1. Returns whether the new last column can be played.
    """
    if not rules.replans:
        return paper.enter_next_slot(table, window, rules)
    for seat in range(window.playing.shape[0]):
        if window.playing[seat]:
            window.phases[seat, 0] = window.phases[seat, 1]
    combine_column(table, window, rules, FIRST)
    _let_one_rejoin(table, window, rules)
    plan(table, window, rules)
    return True


@inner_kernel
def plan_start(
    table: SequenceTable, window: Window, rules: Rules, seat: int, elapsed: float
) -> int:
    """Start an action now, if it can be synchronized.

    Args:
        table: All sequences.
        window: The schedule; `sequence`, `priority`, `age` and `weight` of the seat are already
            set, and `playing` is false there. Changed only if the action starts; then
            `remaining` of the seat is set too. For the default planner `remaining` of the
            others is what is left now.
        rules: The rules of the planner.
        seat: The seat of the action.
        elapsed: The share of column 0 that is over, in [0, 1); a cyclic action that may enter
            anywhere is taken to enter its phase at the same share.

    Returns:
        The phase with which it entered, or `REFUSED`.
    """
    if not rules.replans:
        return 0 if paper.try_start(table, window, rules, seat, FIRST) else REFUSED
    sequence = window.sequence[seat]
    best = REFUSED
    least = math.inf
    entries = table.phase_count[sequence] if table.cyclic[sequence] else 1
    if _lanes_of(table, window, rules) == 0:
        entries = 1
    for entry in range(entries):
        verdict, cost = weigh_entry(table, window, rules, seat, entry, elapsed)
        if verdict == ENTERS and cost < least - SAME_COST:
            best, least = entry, cost
    if best == REFUSED:
        return REFUSED
    _put_in(table, window, seat, best, elapsed)
    plan(table, window, rules)
    return best


@inlined_kernel
def weigh_entry(
    table: SequenceTable,
    window: Window,
    rules: Rules,
    seat: int,
    entry: int,
    elapsed: float,
) -> tuple[int, float]:
    """Return whether an action can enter at a phase, and what the best schedule then costs.

    Args:
        table: All sequences.
        window: The schedule, as for `plan_start`; left as it was, but for the seat's own
            numbers, which mean nothing while it does not play.
        rules: The rules of the default planner.
        seat: The seat of the action.
        entry: The phase with which it would enter.
        elapsed: The share of column 0 that is over.

    Returns:
        `ENTERS`, `ON_THE_OTHER_FOOT`, `NO_ROOM` or `NEVER_LANDS`; and the cost per second.
    """
    _put_in(table, window, seat, entry, elapsed)
    playable = combine_column(table, window, rules, FIRST)
    window.playing[seat] = False
    memory = window.search[0]
    verdict, cost = ON_THE_OTHER_FOOT, math.inf
    if playable:
        verdict = NO_ROOM
        gather_lanes(table, window, memory, rules, seat)
        plant_root(table, window, memory)
        node, complete = choose_path(table, memory)
        if complete:
            verdict = ENTERS if memory.grounded[node] else NEVER_LANDS
            cost = memory.rank[node] / memory.time[node] + TIME_VALUE
    window.phases[seat, 0] = ABSENT
    combine_column(table, window, rules, FIRST)
    return verdict, cost


@inner_kernel
def _put_in(table: SequenceTable, window: Window, seat: int, entry: int, elapsed: float) -> None:
    sequence = window.sequence[seat]
    own = natural_duration(table, sequence, entry)
    window.phases[seat, 0] = entry
    window.remaining[seat] = (1.0 - elapsed) * own if table.cyclic[sequence] else own
    window.held[seat] = 0
    window.muted[seat] = False
    window.playing[seat] = True


@inner_kernel
def plan(table: SequenceTable, window: Window, rules: Rules) -> None:
    """Decide every column but the present one and how long they last; mute who finds no room."""
    combine_column(table, window, rules, FIRST)
    memory = window.search[0]
    if _lanes_of(table, window, rules) == 0:
        seat = _first_muted(window, FIRST)
        if seat >= 0:
            window.muted[seat] = False
            window.held[seat] = 0
    gather_lanes(table, window, memory, rules, NOBODY)
    _mute_beyond_the_lanes(table, window)
    node = NOBODY
    while memory.lanes > 0:
        plant_root(table, window, memory)
        node, _ = choose_path(table, memory)
        if node >= 0:
            break
        _mute(window, memory.seat[first_blocked(table, memory)])
        gather_lanes(table, window, memory, rules, NOBODY)
    combine_column(table, window, rules, FIRST)
    write_path(table, window, rules, node)


@inner_kernel
def _mute(window: Window, seat: int) -> None:
    window.muted[seat] = True
    window.held[seat] = 0


@inner_kernel
def _mute_beyond_the_lanes(table: SequenceTable, window: Window) -> None:
    """Mute the actions of the least priority where there are more than the search can hold."""
    memory = window.search[0]
    if memory.lanes < LANES:
        return
    for seat in range(window.playing.shape[0]):
        sequence = window.sequence[seat]
        ended = not table.cyclic[sequence] and (
            window.phases[seat, 0] >= table.phase_count[sequence]
        )
        listed = ended or window.muted[seat] or not window.playing[seat]
        for lane in range(memory.lanes):
            if memory.seat[lane] == seat:
                listed = True
        if not listed:
            _mute(window, seat)


@inner_kernel
def _lanes_of(table: SequenceTable, window: Window, rules: Rules) -> int:
    gather_lanes(table, window, window.search[0], rules, NOBODY)
    return int(window.search[0].lanes)


@inner_kernel
def _first_muted(window: Window, waited: int) -> int:
    """Return the first in order of priority of those who have been muted for some columns."""
    found = NOBODY
    for seat in range(window.playing.shape[0]):
        rests = window.playing[seat] and window.muted[seat] and window.held[seat] >= waited
        if rests and (found < 0 or paper.precedes(window, seat, found)):
            found = seat
    return found


@inlined_kernel
def _let_one_rejoin(table: SequenceTable, window: Window, rules: Rules) -> None:
    """Take back the first of the muted, if it has rested and nobody would be muted for it."""
    seat = _first_muted(window, rules.most_held)
    if seat < 0 or _lanes_of(table, window, rules) >= LANES:
        return
    rested = window.held[seat]
    window.muted[seat] = False
    window.held[seat] = 0
    complete = False
    if combine_column(table, window, rules, FIRST):
        memory = window.search[0]
        gather_lanes(table, window, memory, rules, NOBODY)
        plant_root(table, window, memory)
        node, complete = choose_path(table, memory)
        complete = complete and bool(memory.grounded[node])
    if not complete:
        window.muted[seat] = True
        window.held[seat] = rested
        combine_column(table, window, rules, FIRST)
