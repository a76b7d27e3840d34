"""Slots: who plays which phase, how long a slot lasts, and how time is warped within it.

Stages 1 to 3 of the pipeline at the moments where something changes.
"""

from __future__ import annotations

from typing import cast

import numpy as np

from footfall.compilation import inner_kernel
from footfall.engine.shelf import Shelf, key_at, phase_end, phase_start, read_points
from footfall.engine.state import EMPTY, LEAVING, RUNNING, SEATS, WAITING, Character
from footfall.skeleton import BodyPart
from footfall.sync.columns import has_ended
from footfall.sync.paper import enter_next_slot
from footfall.sync.planner import REFUSED, release_action, start_action
from footfall.sync.tables import Rules, Window
from footfall.timing import (
    end_slope,
    end_slope_paper,
    level,
    normalize_weights,
    reverse_fade,
    slot_duration,
)

__all__ = [
    "begin_leaving",
    "enter_action",
    "enter_slot",
    "rebuild_warps",
    "retry_waiting",
    "set_target",
    "update_weights",
    "window_of",
]

LEGS = int(BodyPart.LEGS)

# Typed numbers: a literal would have everything that it is passed to compiled twice.
NONE = cast(int, np.int64(-1))
THIS_SLOT, NEXT_SLOT = cast(int, np.int64(0)), cast(int, np.int64(1))

GREATEST_SQUEEZE = 3.0
"""Rate beyond which a first phase is not squeezed into the rest of a slot (S-13)."""

LAST_SLOT = 0.1
"""How long a slot lasts in which every action has ended [s]."""


@inner_kernel
def window_of(me: Character) -> Window:
    """Return the synchronizer's window on one character, without a copy."""
    return Window(
        me.playing,
        me.sequence,
        me.priority,
        me.age,
        me.weight,
        me.remaining,
        me.phases,
        me.results,
        me.spare_phases,
        me.spare_results,
    )


@inner_kernel
def update_weights(me: Character) -> None:
    """Work out every weight from priorities and levels (section 3, figure 2)."""
    for group in range(2):
        levels = me.levels
        for seat in range(SEATS):
            levels[seat] = 0.0
            progress = me.fade_progress[seat, group]
            if me.status[seat] == RUNNING:
                levels[seat] = level(progress)
            elif me.status[seat] == LEAVING:
                levels[seat] = 1.0 - level(progress)
        if group == 0:
            normalize_weights(me.priorities[:, :1], levels, me.weights[:, :1])
        else:
            normalize_weights(me.priorities[:, 1:], levels, me.weights[:, 1:])
    for seat in range(SEATS):
        me.weight[seat] = me.weights[seat, LEGS]


@inner_kernel
def begin_leaving(shelf: Shelf, me: Character, seat: int) -> None:
    """Begin to fade an action out (t3), from whatever level it has."""
    if me.status[seat] == WAITING:
        me.status[seat] = EMPTY
    if me.status[seat] != RUNNING:
        return
    me.status[seat] = LEAVING
    asked = shelf.entries[me.action[seat]].fade_out
    me.fade_asked[seat] = asked
    for group in range(2):
        progress, elapsed = reverse_fade(me.fade_progress[seat, group], asked)
        me.fade_progress[seat, group] = progress
        me.fade_elapsed[seat, group] = elapsed


@inner_kernel
def enter_slot(shelf: Shelf, me: Character, rules: Rules) -> None:
    """Enter the next slot: let go who has faded out, synchronize one more column."""
    window = window_of(me)
    for seat in range(SEATS):
        gone = me.status[seat] == LEAVING and me.fade_progress[seat, 0] >= 1.0
        if gone and me.playing[seat]:
            release_action(shelf.table, window, rules, seat)
            if me.fade_progress[seat, 1] >= 1.0:
                me.status[seat] = EMPTY
    enter_next_slot(shelf.table, window, rules)
    me.slot_index += 1
    me.slot_progress = 0.0
    for seat in range(SEATS):
        if not me.playing[seat]:
            continue
        phase = me.phases[seat, 0]
        if has_ended(shelf.table, me.sequence[seat], phase):
            begin_leaving(shelf, me, seat)
        set_target(shelf, me, seat)
    retry_waiting(shelf, me, rules)
    update_weights(me)
    rebuild_warps(shelf, me)


@inner_kernel
def set_target(shelf: Shelf, me: Character, seat: int) -> None:
    """Set how far an action's clip goes in this slot: its phase, split over its columns (S-20)."""
    phase = me.phases[seat, 0]
    clip_time = me.clip_time[seat]
    if has_ended(shelf.table, me.sequence[seat], phase):
        me.target[seat] = clip_time
        me.natural[seat] = 0.0
        return
    end = phase_end(shelf.entries[me.action[seat]], shelf.phase_starts, phase)
    columns = _columns_of(me, seat, THIS_SLOT)
    part = max(end - clip_time, 0.0) / columns
    me.target[seat] = clip_time + part
    me.natural[seat] = part / (1.0 - me.slot_progress)
    if shelf.use_paper_cubic:
        # S-20, E1: as printed, a held phase votes its whole duration in every column.
        me.natural[seat] = end - phase_start(
            shelf.entries[me.action[seat]], shelf.phase_starts, phase
        )
    me.remaining[seat] = max(end - clip_time, 0.0)


@inner_kernel
def _columns_of(me: Character, seat: int, column: int) -> int:
    """Return over how many decided columns the phase of one column goes on, itself included."""
    phase = me.phases[seat, column]
    last = me.phases.shape[1] - 2
    count = 1
    while column + count <= last and me.phases[seat, column + count] == phase:
        count += 1
    return count


@inner_kernel
def rebuild_warps(shelf: Shelf, me: Character) -> None:
    """Set the slot's duration (eq. 6) and build every time warp anew from now (section 5.3)."""
    duration = _duration(shelf, me, THIS_SLOT)
    me.slot_duration = duration
    if duration <= 0.0:
        return
    following = _duration(shelf, me, NEXT_SLOT)
    now = me.clock
    left = (1.0 - me.slot_progress) * duration
    for seat in range(SEATS):
        if not me.playing[seat]:
            continue
        segment = me.segment[seat]
        segment[0] = now
        segment[1] = me.clip_time[seat]
        segment[2] = me.rate[seat]
        segment[3] = now + left
        segment[4] = me.target[seat]
        mean = (segment[4] - segment[1]) / left if left > 0.0 else 0.0
        if shelf.use_paper_cubic:
            segment[5] = end_slope_paper(mean, segment[2])
        else:
            segment[5] = end_slope(mean, _vote(shelf, me, seat, NEXT_SLOT) / following)


@inner_kernel
def _duration(shelf: Shelf, me: Character, column: int) -> float:
    """Return how long this slot (column 0) or the next one lasts at the present weights [s]."""
    voters = 0
    anybody = False
    for seat in range(SEATS):
        if me.playing[seat]:
            anybody = True
            vote = _vote(shelf, me, seat, column)
            if vote > 0.0:
                me.votes[voters] = vote
                me.shares[voters] = me.weights[seat, LEGS]
                voters += 1
    if voters == 0:
        return LAST_SLOT if anybody else 0.0
    return slot_duration(me.shares, me.votes, voters)


@inner_kernel
def _vote(shelf: Shelf, me: Character, seat: int, column: int) -> float:
    """Return what one action says a slot should last [s]; 0 from an ended one."""
    if column == 0:
        return me.natural[seat]
    phase = me.phases[seat, column]
    if has_ended(shelf.table, me.sequence[seat], phase):
        return 0.0
    entry = shelf.entries[me.action[seat]]
    columns = _columns_of(me, seat, column)
    end = phase_end(entry, shelf.phase_starts, phase)
    if phase == me.phases[seat, 0] and not shelf.use_paper_cubic:
        return max(end - me.target[seat], 0.0) / columns
    own = end - phase_start(entry, shelf.phase_starts, phase)
    return own if shelf.use_paper_cubic else own / columns


@inner_kernel
def retry_waiting(shelf: Shelf, me: Character, rules: Rules) -> None:
    """Try every waiting start again, the oldest command first (section 5.1)."""
    for _ in range(SEATS):
        oldest = NONE
        for seat in range(SEATS):
            untried = me.fade_elapsed[seat, 0] == 0.0
            older = oldest < 0 or me.age[seat] < me.age[oldest]
            if me.status[seat] == WAITING and untried and older:
                oldest = seat
        if oldest < 0:
            break
        if not enter_action(shelf, me, rules, oldest):
            me.fade_elapsed[oldest, 0] = -1.0
    for seat in range(SEATS):
        if me.status[seat] == WAITING:
            me.fade_elapsed[seat, 0] = 0.0


@inner_kernel
def enter_action(shelf: Shelf, me: Character, rules: Rules, seat: int) -> bool:
    """Start the action of a seat now, if it can be synchronized; return whether it was."""
    action = me.action[seat]
    if me.synchronized and me.priorities[seat, LEGS] > 0.0:
        if not _synchronize(shelf, me, rules, seat):
            return False
    else:
        me.clip_time[seat] = 0.0
        me.rate[seat] = 1.0
    me.status[seat] = RUNNING
    me.fade_asked[seat] = shelf.entries[action].fade_in
    for group in range(2):
        me.fade_progress[seat, group] = 1.0 if me.fresh else 0.0
        me.fade_elapsed[seat, group] = 0.0
    me.posed_time[seat] = me.clip_time[seat]
    frame, fraction, _ = key_at(shelf.entries[action], me.clip_time[seat])
    read_points(shelf, frame, fraction, me.seat_points[seat])
    update_weights(me)
    rebuild_warps(shelf, me)
    return True


@inner_kernel
def _synchronize(shelf: Shelf, me: Character, rules: Rules, seat: int) -> bool:
    """Find an action its place in the schedule, and its clip the time that belongs there."""
    action = me.action[seat]
    window = window_of(me)
    alone = True
    for other in range(SEATS):
        if me.playing[other]:
            alone = False
    anywhere = rules.enters_anywhere and shelf.entries[action].cyclic
    if alone:
        me.slot_progress = 0.0
    elif not anywhere:
        first = phase_end(shelf.entries[action], shelf.phase_starts, 0) - phase_start(
            shelf.entries[action], shelf.phase_starts, 0
        )
        left = (1.0 - me.slot_progress) * me.slot_duration
        if first > GREATEST_SQUEEZE * left:
            return False
    elapsed = me.slot_progress
    _prepare_costs(shelf, me, seat)
    phase = start_action(shelf.table, window, rules, seat, elapsed)
    if phase == REFUSED:
        update_weights(me)
        return False
    begin = phase_start(shelf.entries[action], shelf.phase_starts, phase)
    end = phase_end(shelf.entries[action], shelf.phase_starts, phase)
    me.clip_time[seat] = begin + elapsed * (end - begin) if anywhere else begin
    for other in range(SEATS):
        if me.playing[other]:
            set_target(shelf, me, other)
    duration = me.slot_duration if not alone else me.natural[seat]
    left = (1.0 - elapsed) * duration
    reach = me.target[seat] - me.clip_time[seat]
    me.rate[seat] = reach / left if left > 0.0 else 1.0
    return True


@inner_kernel
def _prepare_costs(shelf: Shelf, me: Character, seat: int) -> None:
    """Tell the planner the weights to come and what is left of every phase."""
    for other in range(SEATS):
        if me.playing[other]:
            me.weight[other] = me.priority[other]
            end = phase_end(
                shelf.entries[me.action[other]], shelf.phase_starts, me.phases[other, 0]
            )
            me.remaining[other] = max(end - me.clip_time[other], 1e-3)
    me.weight[seat] = me.priority[seat]
