"""Start, stop and priorities, row by row inside one kernel (figure 2: t1 and t3)."""

from __future__ import annotations

from typing import Any

import numpy.typing as npt

from footfall.arrays import Flags, Floats, Indices, Seconds
from footfall.compilation import inner_kernel, lean_kernel
from footfall.engine.clock import pass_time
from footfall.engine.priority_changes import ask_priority, settle_priority
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf
from footfall.engine.slots import begin_leaving
from footfall.engine.starting import NONE, enter_action
from footfall.engine.state import EMPTY, RUNNING, WAITING
from footfall.skeleton import BodyPart
from footfall.sync.search_memory import PlannerMemory
from footfall.sync.tables import Rules
from footfall.timing import reverse_fade

__all__ = [
    "NOBODY",
    "catch_up_rows",
    "prioritize_rows",
    "row_without_seat",
    "start_rows",
    "stop_rows",
]

LEGS = int(BodyPart.LEGS)
PARTS = len(BodyPart)

AT_ONCE = 1e-9
"""Time in which nothing is gradual [s]."""

NOBODY = -1
"""What `row_without_seat` returns where everybody has a seat."""


@lean_kernel
def start_rows(
    shelf: Shelf,
    characters: npt.NDArray[Any],
    search: PlannerMemory,
    rules: Rules,
    rows: Indices,
    action: int,
    patience: float,
    late: int,
    out: Flags,
) -> None:
    """Start an action of many characters, each at once or as soon as its moment comes.

    Everybody has a seat for it: see `row_without_seat`.

    Args:
        shelf: The library.
        characters: Records of `character_type`, shape (all rows,).
        search: Working memory of the planner.
        rules: The rules of the planner.
        rows: Which characters, shape (rows,).
        action: Which action of the library.
        patience: How long a start waits at most [s], >= 0.
        late: What becomes of it then: `GIVES_UP` or `STARTS_MUTED`.
        out: Written: whether it runs now, shape (rows,).
    """
    for place in range(rows.shape[0]):
        me: Character = characters[int(rows[place])]
        out[place] = _start_row(shelf, me, search, rules, action, patience, late)


@lean_kernel
def row_without_seat(shelf: Shelf, characters: npt.NDArray[Any], rows: Indices, action: int) -> int:
    """Return the first of some rows that has no seat for an action, or `NOBODY`."""
    for place in range(rows.shape[0]):
        me: Character = characters[int(rows[place])]
        if not _has_room(shelf, me, action):
            return int(rows[place])
    return NOBODY


@inner_kernel
def _start_row(
    shelf: Shelf,
    me: Character,
    search: PlannerMemory,
    rules: Rules,
    action: int,
    patience: float,
    late: int,
) -> bool:
    """Start an action of one character, or seat it to wait; return whether it runs now.

    A running one goes on; one that fades out rises again, unless it is over (S-14).
    """
    free = NONE
    for seat in range(SEATS):
        status = me.status[seat]
        if status == EMPTY:
            free = seat if free < 0 else free
        elif me.action[seat] == action:
            if status == WAITING:
                me.patience[seat] = me.clock + patience
                me.late[seat] = late
                return False
            if status == RUNNING:
                return True
            if _rises(shelf, me, seat):
                _rise_again(shelf, me, seat)
                me.unsettled = True
                return True
    _take_seat(shelf, me, free, action)
    me.patience[free] = me.clock + patience
    me.late[free] = late
    return enter_action(shelf, me, search, rules, free)


@inner_kernel
def _has_room(shelf: Shelf, me: Character, action: int) -> bool:
    """Return whether a start would find a seat."""
    for seat in range(SEATS):
        if me.status[seat] == EMPTY:
            return True
        stays = me.status[seat] in (WAITING, RUNNING) or _rises(shelf, me, seat)
        if me.action[seat] == action and stays:
            return True
    return False


@inner_kernel
def _rises(shelf: Shelf, me: Character, seat: int) -> bool:
    """Return whether an action that fades out can rise again.

    Not where its clip is over, nor where it has left the schedule: its legs would go on alone.
    """
    entry = shelf.entries[me.action[seat]]
    over = me.clip_time[seat] >= entry.duration and not entry.cyclic
    scheduled = me.synchronized and me.priorities_asked[seat, LEGS] > 0.0
    return not over and (me.playing[seat] or not scheduled)


@lean_kernel
def catch_up_rows(
    shelf: Shelf,
    characters: npt.NDArray[Any],
    search: PlannerMemory,
    rules: Rules,
    rows: Indices,
    ahead: Seconds,
) -> None:
    """Let characters that have shown nothing be where they would be had they begun earlier.

    Args:
        shelf: The library.
        characters: Records of `character_type`, shape (all rows,); clocks are as before.
        search: Working memory of the planner.
        rules: The rules of the planner.
        rows: Which characters, shape (rows,).
        ahead: How much earlier [s], >= 0, shape (rows,).
    """
    for place in range(rows.shape[0]):
        me: Character = characters[int(rows[place])]
        now = me.clock
        pass_time(shelf, me, search, rules, ahead[place])
        for end in range(2):
            me.span[end] -= ahead[place]
        for seat in range(me.occupied):
            if me.status[seat] >= RUNNING:
                me.posed_time[seat] = me.clip_time[seat]
            me.patience[seat] -= ahead[place]
        me.clock = now


@inner_kernel
def _take_seat(shelf: Shelf, me: Character, seat: int, action: int) -> None:
    """Seat an action that waits for its moment."""
    me.action[seat] = action
    for part in range(PARTS):
        settle_priority(me, seat, part, shelf.entries[action].priorities[part])
    me.priority[seat] = me.priorities_asked[seat, LEGS]
    me.starts += 1
    me.age[seat] = me.starts
    me.fade_elapsed[seat] = 0.0
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
        if group == 0:
            me.fade_elapsed[seat] = elapsed


@lean_kernel
def stop_rows(shelf: Shelf, characters: npt.NDArray[Any], rows: Indices, action: int) -> None:
    """Stop an action of many characters: fade it out, or give up its wait."""
    for place in range(rows.shape[0]):
        me: Character = characters[int(rows[place])]
        for seat in range(SEATS):
            if me.status[seat] != EMPTY and me.action[seat] == action:
                begin_leaving(shelf, me, seat)
                me.unsettled = True


@lean_kernel
def prioritize_rows(
    shelf: Shelf,
    characters: npt.NDArray[Any],
    rows: Indices,
    action: int,
    priorities: Floats,
    seconds: float,
) -> None:
    """Give an action of many characters other priorities, at once where nobody sees it.

    Args:
        shelf: The library.
        characters: Records of `character_type`, shape (all rows,).
        rows: Which characters, shape (rows,).
        action: Which action of the library.
        priorities: Of each body part, >= 0, shape (parts,).
        seconds: In what time [s]; < 0: in that of the action's fade in.
    """
    within = shelf.entries[action].fade_in if seconds < 0.0 else seconds
    for place in range(rows.shape[0]):
        me: Character = characters[int(rows[place])]
        me.unsettled = True
        for seat in range(SEATS):
            if me.status[seat] == EMPTY or me.action[seat] != action:
                continue
            unseen = me.status[seat] == WAITING or me.fresh or within < AT_ONCE
            for part in range(PARTS):
                if unseen:
                    settle_priority(me, seat, part, priorities[part])
                else:
                    ask_priority(me, seat, part, priorities[part], within)
            me.priority_seconds[seat] = within
            me.priority[seat] = me.priorities_asked[seat, LEGS]
            me.changing = me.changing or not unseen
