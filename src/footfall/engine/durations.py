"""How long a slot lasts, and how time is warped within it (sections 5.2 and 5.3)."""

from __future__ import annotations

from typing import cast

import numpy as np

from footfall.compilation import inner_kernel
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf, phase_end, phase_start
from footfall.engine.state import LEAVING, RUNNING
from footfall.skeleton import BodyPart
from footfall.sync.columns import has_ended
from footfall.timing import (
    end_slope,
    end_slope_paper,
    level,
    normalize_weights,
    slot_duration,
)

__all__ = ["GREATEST_RATE", "rebuild_warps", "set_target", "update_weights"]

LEGS = int(BodyPart.LEGS)

# Typed numbers: a literal would have everything that it is passed to compiled twice.
THIS_SLOT, NEXT_SLOT = cast(int, np.int64(0)), cast(int, np.int64(1))

GREATEST_RATE = 2.5
"""A slot lasts so long that no clip has to run faster than this on average, whatever its weight:
one that has just entered has none yet, and must not rush through its first phase."""

LAST_SLOT = 0.1
"""How long a slot lasts in which every action has ended [s]."""


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
def set_target(shelf: Shelf, me: Character, seat: int) -> None:
    """Set how far an action's clip goes in this slot: its phase, split over its columns (S-20)."""
    phase = me.phases[seat, 0]
    clip_time = me.clip_time[seat]
    if has_ended(shelf.table, me.sequence[seat], phase):
        me.target[seat] = clip_time
        me.natural[seat] = 0.0
        me.rate[seat] = 0.0
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
            continue
        ahead = _vote(shelf, me, seat, NEXT_SLOT)
        # An action that ends there goes on at its speed: a clip alone plays as it was.
        segment[5] = end_slope(mean, ahead / following) if ahead > 0.0 else mean


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
    duration = slot_duration(me.shares, me.votes, voters)
    if shelf.use_paper_cubic:
        return duration
    for voter in range(voters):
        duration = max(duration, me.votes[voter] / GREATEST_RATE)
    return duration


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
