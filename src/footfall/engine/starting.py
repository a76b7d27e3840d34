"""The start of an action: its place in the schedule, and its clip's time (section 5.1)."""

from __future__ import annotations

from typing import cast

import numpy as np

from footfall.compilation import inlined_kernel, inner_kernel
from footfall.engine.durations import rebuild_warps, set_target, update_weights
from footfall.engine.planning import follow_plan, measure_remaining, window_of
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf, phase_end, phase_start
from footfall.engine.state import RUNNING, WAITING
from footfall.skeleton import BodyPart
from footfall.sync.planner import REFUSED, plan_start
from footfall.sync.search_memory import PlannerMemory
from footfall.sync.tables import Rules

__all__ = ["NONE", "enter_action", "enter_muted", "retry_waiting"]

LEGS = int(BodyPart.LEGS)

# Typed numbers: a literal would have everything that it is passed to compiled twice.
NONE, PRESENT = cast(int, np.int64(-1)), cast(int, np.int64(0))

GREATEST_SQUEEZE = 3.0
"""Rate beyond which a first phase is not squeezed into the rest of a slot (S-13)."""


@inner_kernel
def retry_waiting(shelf: Shelf, me: Character, search: PlannerMemory, rules: Rules) -> None:
    """Try every waiting start again, the oldest command first (section 5.1)."""
    for _ in range(SEATS):
        oldest = NONE
        for seat in range(SEATS):
            untried = me.fade_elapsed[seat] == 0.0
            older = oldest < 0 or me.age[seat] < me.age[oldest]
            if me.status[seat] == WAITING and untried and older:
                oldest = seat
        if oldest < 0:
            break
        if not enter_action(shelf, me, search, rules, oldest):
            me.fade_elapsed[oldest] = -1.0
    for seat in range(SEATS):
        if me.status[seat] == WAITING:
            me.fade_elapsed[seat] = 0.0


@inner_kernel
def enter_action(
    shelf: Shelf, me: Character, search: PlannerMemory, rules: Rules, seat: int
) -> bool:
    """Start the action of a seat now, if it can be synchronized; return whether it was."""
    me.muted[seat] = False
    if me.synchronized and me.priorities_asked[seat, LEGS] > 0.0:
        if not _synchronize(shelf, me, search, rules, seat):
            return False
    else:
        me.clip_time[seat] = 0.0
        me.rate[seat] = 1.0
    me.presence[seat] = 1.0
    _begin(shelf, me, rules, seat)
    return True


@inner_kernel
def enter_muted(shelf: Shelf, me: Character, rules: Rules, seat: int) -> None:
    """Start an action without its legs: it rejoins the schedule as soon as there is room."""
    me.clip_time[seat] = 0.0
    me.rate[seat] = 1.0
    me.presence[seat] = 0.0
    me.muted[seat] = True
    me.playing[seat] = rules.replans
    me.held[seat] = 0
    me.phases[seat, 0] = 0
    _begin(shelf, me, rules, seat)


@inner_kernel
def _begin(shelf: Shelf, me: Character, rules: Rules, seat: int) -> None:
    """Let an action run that has its clip time, and fade in."""
    action = me.action[seat]
    me.status[seat] = RUNNING
    me.fade_asked[seat] = shelf.entries[action].fade_in
    for group in range(2):
        me.fade_progress[seat, group] = 1.0 if me.fresh else 0.0
    me.fade_elapsed[seat] = 0.0
    me.posed_time[seat] = me.clip_time[seat]
    update_weights(me)
    if rules.replans and me.playing[seat] and not me.muted[seat]:
        follow_plan(shelf, me)
    else:
        rebuild_warps(shelf, me)


@inlined_kernel
def _synchronize(
    shelf: Shelf, me: Character, search: PlannerMemory, rules: Rules, seat: int
) -> bool:
    """Find an action its place in the schedule, and its clip the time that belongs there."""
    entry = shelf.entries[me.action[seat]]
    alone = True
    for other in range(SEATS):
        if me.playing[other]:
            alone = False
    if alone:
        me.slot_progress = 0.0
        me.steady[0] = 0.0
    elif not rules.replans:
        first = phase_end(entry, shelf.phase_starts, 0) - phase_start(entry, shelf.phase_starts, 0)
        left = (1.0 - me.slot_progress) * me.slot_duration
        if first > GREATEST_SQUEEZE * left:
            return False
    elapsed = me.slot_progress
    update_weights(me)
    measure_remaining(shelf, me, PRESENT)
    phase = plan_start(shelf.table, window_of(me, search), rules, seat, elapsed)
    if phase == REFUSED:
        return False
    begin = phase_start(entry, shelf.phase_starts, phase)
    end = phase_end(entry, shelf.phase_starts, phase)
    anywhere = rules.enters_anywhere and entry.cyclic
    me.clip_time[seat] = begin + elapsed * (end - begin) if anywhere else begin
    if rules.replans:
        me.rate[seat] = me.pace[seat, 0]
        return True
    for other in range(SEATS):
        if me.playing[other]:
            set_target(shelf, me, other)
    left = (1.0 - elapsed) * (me.natural[seat] if alone else me.slot_duration)
    reach = me.target[seat] - me.clip_time[seat]
    me.rate[seat] = reach / left if left > 0.0 else 1.0
    return True
