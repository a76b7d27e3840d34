"""Slots: what happens where one ends and the next begins."""

from __future__ import annotations

from footfall.compilation import inner_kernel
from footfall.engine.durations import rebuild_warps, set_target, update_weights
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf
from footfall.engine.starting import retry_waiting, window_of
from footfall.engine.state import EMPTY, LEAVING, RUNNING, WAITING
from footfall.sync.columns import has_ended
from footfall.sync.paper import enter_next_slot
from footfall.sync.planner import release_action
from footfall.sync.tables import Rules
from footfall.timing import reverse_fade

__all__ = ["begin_leaving", "enter_slot"]


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
    update_weights(me)
    rebuild_warps(shelf, me)
    retry_waiting(shelf, me, rules)
