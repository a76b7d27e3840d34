"""The start of an action: its place in the schedule, and its clip's time (section 5.1)."""

from __future__ import annotations

from typing import cast

import numpy as np

from footfall.compilation import inner_kernel
from footfall.engine.durations import GREATEST_RATE, rebuild_warps, set_target, update_weights
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf, key_at, phase_end, phase_start, read_points
from footfall.engine.state import RUNNING, WAITING
from footfall.skeleton import BodyPart
from footfall.sync.planner import REFUSED, start_action
from footfall.sync.tables import Rules, Window

__all__ = ["NONE", "enter_action", "retry_waiting", "window_of"]

LEGS = int(BodyPart.LEGS)

# A typed number: a literal would have everything that it is passed to compiled twice.
NONE = cast(int, np.int64(-1))

GREATEST_SQUEEZE = 3.0
"""Rate beyond which a first phase is not squeezed into the rest of a slot (S-13)."""


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
    duration = me.natural[seat] if alone else me.slot_duration
    if not shelf.use_paper_cubic:
        duration = max(duration, me.natural[seat] / GREATEST_RATE)
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
