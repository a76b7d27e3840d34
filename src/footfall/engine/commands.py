"""Start and stop, for one character (figure 2: t1 and t3)."""

from __future__ import annotations

from typing import Any

import numpy.typing as npt

from footfall.compilation import inner_kernel, lean_kernel
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf
from footfall.engine.slots import begin_leaving
from footfall.engine.starting import NONE, enter_action
from footfall.engine.state import EMPTY, RUNNING, WAITING
from footfall.skeleton import BodyPart
from footfall.sync.search_memory import SearchMemories
from footfall.sync.tables import Rules
from footfall.timing import reverse_fade

__all__ = ["NO_SEAT", "STARTED", "WAITS", "start_row", "stop_row"]

LEGS = int(BodyPart.LEGS)
PARTS = len(BodyPart)

NO_SEAT, WAITS, STARTED = -1, 0, 1
"""What `start_row` returns."""


@lean_kernel
def start_row(
    shelf: Shelf,
    characters: npt.NDArray[Any],
    search: SearchMemories,
    rules: Rules,
    row: int,
    action: int,
    patience: float,
    late: int,
) -> int:
    """Start an action of one character, or seat it to wait for its moment.

    A running one goes on; one that fades out rises again, unless its clip is over (S-14).

    Args:
        shelf: The library.
        characters: Records of `character_type`, shape (rows,).
        search: Working memory of the planner.
        rules: The rules of the planner.
        row: Which character.
        action: Which action of the library.
        patience: How long the start waits at most [s], >= 0.
        late: What becomes of it then: `GIVES_UP` or `STARTS_MUTED`.

    Returns:
        `STARTED`, `WAITS`, or `NO_SEAT` where every seat is taken.
    """
    me: Character = characters[row]
    free = NONE
    for seat in range(SEATS):
        status = me.status[seat]
        if status == EMPTY:
            free = seat if free < 0 else free
        elif me.action[seat] == action:
            if status == WAITING:
                me.patience[seat] = me.clock + patience
                me.late[seat] = late
                return WAITS
            if status == RUNNING:
                return STARTED
            over = me.clip_time[seat] >= shelf.entries[action].duration
            if shelf.entries[action].cyclic or not over:
                _rise_again(shelf, me, seat)
                me.unsettled = True
                return STARTED
    if free < 0:
        return NO_SEAT
    _take_seat(shelf, me, free, action)
    me.patience[free] = me.clock + patience
    me.late[free] = late
    if enter_action(shelf, me, search, rules, free):
        return STARTED
    return WAITS


@inner_kernel
def _take_seat(shelf: Shelf, me: Character, seat: int, action: int) -> None:
    """Seat an action that waits for its moment."""
    me.action[seat] = action
    me.sequence[seat] = action
    for part in range(PARTS):
        me.priorities[seat, part] = shelf.entries[action].priorities[part]
    me.priority[seat] = me.priorities[seat, LEGS]
    me.starts += 1
    me.age[seat] = me.starts
    me.fade_elapsed[seat, 0] = me.fade_elapsed[seat, 1] = 0.0
    me.playing[seat] = False
    me.status[seat] = WAITING
    me.occupied = max(me.occupied, seat + 1)


@inner_kernel
def _rise_again(shelf: Shelf, me: Character, seat: int) -> None:
    asked = shelf.entries[me.action[seat]].fade_in
    me.status[seat] = RUNNING
    me.fade_asked[seat] = asked
    for group in range(2):
        progress, elapsed = reverse_fade(me.fade_progress[seat, group], asked)
        me.fade_progress[seat, group] = progress
        me.fade_elapsed[seat, group] = elapsed


@lean_kernel
def stop_row(shelf: Shelf, characters: npt.NDArray[Any], row: int, action: int) -> None:
    """Stop an action of one character: fade it out, or give up its wait."""
    me: Character = characters[row]
    for seat in range(SEATS):
        if me.status[seat] != EMPTY and me.action[seat] == action:
            begin_leaving(shelf, me, seat)
            me.unsettled = True
