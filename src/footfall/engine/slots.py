"""Slots: what happens where one ends and the next begins."""

from __future__ import annotations

from typing import cast

import numpy as np

from footfall.compilation import inlined_kernel, inner_kernel
from footfall.engine.planning import follow_plan, measure_remaining, window_of
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf
from footfall.engine.starting import retry_waiting
from footfall.engine.state import EMPTY, LEAVING, RUNNING, WAITING
from footfall.skeleton import BodyPart
from footfall.sync.columns import has_ended, recombine
from footfall.sync.planner import plan_next_slot
from footfall.sync.search_memory import PlannerMemory
from footfall.sync.shares import finish_slot
from footfall.sync.tables import Rules
from footfall.timing import reverse_fade

__all__ = ["begin_leaving", "enter_slot"]

LEGS = int(BodyPart.LEGS)

# A typed number: a literal would have everything that it is passed to compiled twice.
NEXT = cast(int, np.int64(1))

LEAST_SHARE = 0.05
"""Leg weight below which an action that leaves constrains the others no more (S-30)."""


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
        if group == 0:
            me.fade_elapsed[seat] = elapsed


@inlined_kernel
def enter_slot(shelf: Shelf, me: Character, search: PlannerMemory, rules: Rules) -> None:
    """Enter the next slot: let go who has faded out, synchronize one more column."""
    window = window_of(me, search)
    finish_slot(shelf.table, window)
    for seat in range(SEATS):
        if me.playing[seat] and _is_gone(me, rules, seat):
            me.playing[seat] = False
            if not rules.replans:
                recombine(shelf.table, window, rules)
            if me.fade_progress[seat, 0] >= 1.0 and me.fade_progress[seat, 1] >= 1.0:
                me.status[seat] = EMPTY
    measure_remaining(shelf, me, NEXT)
    plan_next_slot(shelf.table, window, rules)
    me.slot_index += 1
    me.slot_progress = 0.0
    for seat in range(SEATS):
        if me.playing[seat] and has_ended(shelf.table, me.action[seat], me.phases[seat, 0]):
            begin_leaving(shelf, me, seat)
    follow_plan(shelf, me)
    retry_waiting(shelf, me, search, rules)


@inner_kernel
def _is_gone(me: Character, rules: Rules, seat: int) -> bool:
    """Return whether an action that leaves carries so little that it leaves the schedule."""
    if me.status[seat] != LEAVING:
        return False
    if me.fade_progress[seat, 0] >= 1.0:
        return True
    light = rules.replans and me.weights[seat, LEGS] < LEAST_SHARE
    if light:
        for other in range(SEATS):
            if other != seat and me.playing[other] and me.status[other] == RUNNING:
                return True
    return False
