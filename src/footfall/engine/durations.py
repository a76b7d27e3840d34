"""How long a slot lasts, and how time is warped within it (sections 5.2 and 5.3)."""

from __future__ import annotations

import math
from typing import cast

import numpy as np

from footfall.compilation import inner_kernel, small_kernel
from footfall.engine.priority_changes import present_priorities, read_levels
from footfall.engine.record import Character
from footfall.engine.shelf import Shelf, phase_end, phase_start
from footfall.engine.state import LEAVING
from footfall.skeleton import BodyPart
from footfall.support import Support
from footfall.sync.columns import has_ended, support_of
from footfall.sync.prices import FLIGHT_VOTE, GREATEST_RATE, LEAST_RATE
from footfall.sync.tables import ENDED_NEUTRAL
from footfall.timing import (
    end_slope,
    end_slope_paper,
    level,
    mean_vote,
    normalize_weights,
)

__all__ = ["bend_warps", "rebuild_warps", "set_target", "update_weights"]

LEGS = int(BodyPart.LEGS)
PARTS = len(BodyPart)

FLIGHT = int(Support.FLIGHT)

# A typed number: a literal would have everything that it is passed to compiled twice.
THIS_SLOT = cast(int, np.int64(0))

LAST_SLOT = 0.1
"""How long a slot lasts in which every action has ended [s]."""


@inner_kernel
def update_weights(me: Character) -> None:
    """Work out every weight from priorities and levels (section 3, figure 2)."""
    for group in range(2):
        read_levels(me, group)
        levels = me.levels[: me.occupied]
        if me.changing:
            for part in range(group, 1 if group == 0 else PARTS):
                present_priorities(me, part)
                taken = me.taken[: me.occupied]
                normalize_weights(me.priorities_now[:, :1], taken, me.weights[:, part : part + 1])
        elif group == 0:
            normalize_weights(me.priorities_asked[:, :1], levels, me.weights[:, :1])
        else:
            normalize_weights(me.priorities_asked[:, 1:], levels, me.weights[:, 1:])
    for seat in range(me.occupied):
        # What is to come, for the planner: a start is at its full weight soon, a stop has less.
        fading = me.status[seat] == LEAVING
        share = 1.0 - level(me.fade_progress[seat, 0]) if fading else 1.0
        me.weight[seat] = me.priority[seat] * share


@inner_kernel
def set_target(shelf: Shelf, me: Character, seat: int) -> None:
    """Set how far an action's clip goes in this slot.

    To the end of its phase, or, where that is held, as far as the planner lets it; in paper mode
    as far as its even share over the decided columns (S-20).
    """
    phase = me.phases[seat, 0]
    clip_time = me.clip_time[seat]
    if has_ended(shelf.table, me.action[seat], phase):
        me.target[seat] = clip_time
        me.natural[seat] = 0.0
        me.rate[seat] = 0.0
        return
    end = phase_end(shelf.entries[me.action[seat]], shelf.phase_starts, phase)
    part = max(end - clip_time, 0.0)
    if shelf.use_paper_cubic:
        part /= _columns_of(me, seat, THIS_SLOT)
    elif me.phases[seat, 1] == phase:
        part = min(part, me.pace[seat, 0] * me.durations[0])
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
    """Do what `bend_warps` does, for callers with no haste: as a function of its own."""
    bend_warps(shelf, me)


@small_kernel
def bend_warps(shelf: Shelf, me: Character) -> None:
    """Set the slot's duration (eq. 6) and build every time warp anew from now (section 5.3)."""
    duration = _duration(shelf, me)
    me.slot_duration = duration
    if duration <= 0.0:
        return
    now = me.clock
    left = (1.0 - me.slot_progress) * duration
    me.span[0], me.span[1] = now, now + left
    for seat in range(me.occupied):
        if not me.playing[seat] or me.muted[seat]:
            continue
        segment = me.segment[seat]
        segment[0] = me.clip_time[seat]
        segment[1] = me.rate[seat]
        mean = (me.target[seat] - segment[0]) / left if left > 0.0 else 0.0
        if shelf.use_paper_cubic:
            segment[2] = end_slope_paper(mean, segment[1])
            continue
        ahead = me.pace[seat, 1]
        # An action that ends there goes on at its speed: a clip alone plays as it was.
        segment[2] = end_slope(mean, ahead) if ahead > 0.0 else mean


@small_kernel
def _duration(shelf: Shelf, me: Character) -> float:
    """Return how long this slot lasts at the present weights [s] (eq. 6).

    In paper mode everybody votes. The planner has those vote who go on at the end of the slot,
    flights more than others, and has its own opinion in `slot_offset`.
    """
    planned = not shelf.use_paper_cubic
    voters = 0
    total, weighted, plain = 0.0, 0.0, 0.0
    anybody = False
    soonest, latest = 0.0, math.inf
    for seat in range(me.occupied):
        if not me.playing[seat]:
            continue
        anybody = True
        vote = me.natural[seat]
        if me.muted[seat] or vote <= 0.0:
            continue
        soonest = max(soonest, vote / GREATEST_RATE)
        latest = min(latest, vote / LEAST_RATE)
        phase = me.phases[seat, 0]
        if planned and me.phases[seat, 1] == phase:
            continue
        support = support_of(shelf.table, me.action[seat], phase, ENDED_NEUTRAL)
        flies = planned and support == FLIGHT
        share = me.weights[seat, LEGS] * (FLIGHT_VOTE if flies else 1.0)
        total, weighted, plain = total + share, weighted + share * vote, plain + vote
        voters += 1
    if voters == 0:
        return LAST_SLOT if anybody else 0.0
    duration = mean_vote(total, weighted, plain, voters)
    if not planned:
        return duration
    return max(min(duration + me.slot_offset[0], latest), soonest)
