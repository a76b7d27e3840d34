"""From clock time to clip times: the schedule, the length of its slots, the time warp.

Stages 1 to 3 of the pipeline, for one character. Everything happens at its exact moment: an
advance is cut wherever a slot ends, so that a long frame and two short ones agree.
"""

from __future__ import annotations

import math

from footfall.compilation import inlined_kernel, inner_kernel, small_kernel
from footfall.engine.durations import bend_warps, update_weights
from footfall.engine.planning import replan
from footfall.engine.priority_changes import advance_changes
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf, support_at
from footfall.engine.slots import begin_leaving, enter_slot
from footfall.engine.starting import enter_muted, retry_waiting
from footfall.engine.state import EMPTY, LEAVING, RUNNING, STARTS_MUTED, WAITING
from footfall.skeleton import BodyPart
from footfall.support import Support
from footfall.sync.search_memory import PlannerMemory
from footfall.sync.tables import Rules
from footfall.timing import advance_progress, warp

__all__ = ["pass_time"]

LEGS = int(BodyPart.LEGS)
DOUBLE, FLIGHT = int(Support.DOUBLE), int(Support.FLIGHT)

FADE_EASE = 0.1
"""Time that leg weights take to come to speed, and to rest, while one foot carries [s]."""

MUTING = 0.2
"""Time in which a muted action loses its leg weight, or gets it back [s]."""

COMING_FREE = 0.1
"""Time constant with which an action that is not warped any more comes to its own speed [s]."""

SAME_MOMENT = 1e-9
"""Clock times closer than this are one moment [s]."""


@small_kernel
def pass_time(shelf: Shelf, me: Character, search: PlannerMemory, rules: Rules, dt: float) -> None:
    """Let `dt` seconds pass on one character's clocks."""
    if me.unsettled:
        replan(shelf, me, search, rules)
    end = me.clock + dt
    while True:
        # Between commands weights and warps change only while something fades.
        moving = _weights_move(me)
        if moving:
            bend_warps(shelf, me)
        step = min(end, _next_deadline(me)) - me.clock
        slot_ends = False
        duration = me.slot_duration
        if me.synchronized and duration > 0.0:
            left = (1.0 - me.slot_progress) * duration
            if left <= step + SAME_MOMENT:
                step, slot_ends = min(left, step), True
        moving = _run_clips(shelf, me, step, slot_ends) or moving
        _run_fades(me, step, moving)
        me.clock += step
        if duration > 0.0:
            me.slot_progress += step / duration
        if slot_ends:
            enter_slot(shelf, me, search, rules)
        _lose_patience(shelf, me, rules)
        if moving:
            update_weights(me)
        if end - me.clock <= SAME_MOMENT and not slot_ends:
            break
    me.clock = end
    _settle(shelf, me, search, rules)


@small_kernel
def _weights_move(me: Character) -> bool:
    if me.changing:
        return True
    for seat in range(me.occupied):
        fading = me.fade_progress[seat, 0] < 1.0 or me.fade_progress[seat, 1] < 1.0
        if me.status[seat] >= RUNNING and (fading or me.presence[seat] != 1 - me.muted[seat]):
            return True
    return False


@small_kernel
def _next_deadline(me: Character) -> float:
    """Return the clock time at which the first waiting start has waited long enough."""
    soonest = math.inf
    for seat in range(me.occupied):
        if me.status[seat] == WAITING:
            soonest = min(soonest, max(me.patience[seat], me.clock))
    return soonest


@inner_kernel
def _lose_patience(shelf: Shelf, me: Character, rules: Rules) -> None:
    """Give up the starts that have waited long enough, or start them muted."""
    for seat in range(me.occupied):
        if me.status[seat] == WAITING and me.patience[seat] <= me.clock + SAME_MOMENT:
            if me.late[seat] == STARTS_MUTED:
                enter_muted(shelf, me, rules, seat)
            else:
                me.status[seat] = EMPTY


@small_kernel
def _run_clips(shelf: Shelf, me: Character, step: float, slot_ends: bool) -> bool:
    """Advance every clip: warped where it is synchronized, else at its own speed.

    Returns:
        Whether one is over, and begins to fade out.
    """
    over = False
    first, last = me.span[0], me.span[1]
    for seat in range(me.occupied):
        if me.status[seat] < RUNNING:
            continue
        if me.synchronized and me.playing[seat] and not me.muted[seat]:
            part = me.segment[seat]
            if slot_ends:
                me.clip_time[seat] = me.target[seat]
                me.rate[seat] = part[2]
            else:
                clip_time, rate = warp(
                    me.clock + step,
                    first,
                    part[0],
                    part[1],
                    last,
                    me.target[seat],
                    part[2],
                    shelf.use_paper_cubic,
                )
                me.clip_time[seat], me.rate[seat] = clip_time, rate
            continue
        action = me.action[seat]
        # Who has left the schedule comes to its own speed without a jump, however time is cut.
        excess, kept = me.rate[seat] - 1.0, math.exp(-step / COMING_FREE)
        clip_time = me.clip_time[seat] + step + excess * COMING_FREE * (1.0 - kept)
        me.rate[seat] = 1.0 + excess * kept
        if not shelf.entries[action].cyclic and clip_time >= shelf.entries[action].duration:
            clip_time = shelf.entries[action].duration
            me.rate[seat] = 0.0
            begin_leaving(shelf, me, seat)
            over = True
        me.clip_time[seat] = clip_time
    return over


@small_kernel
def _run_fades(me: Character, step: float, moving: bool) -> None:
    """Advance every fade; leg weights wait while both feet carry, or none (S-27)."""
    pace = _fade_pace(me, step)
    if not moving:
        return
    if me.changing:
        advance_changes(me, step, pace)
    for seat in range(me.occupied):
        if me.status[seat] < RUNNING:
            continue
        asked = me.fade_asked[seat]
        change = 0.0 if me.flight != 0 and me.results[0] == FLIGHT else step / MUTING
        me.presence[seat] = (
            max(me.presence[seat] - change, 0.0)
            if me.muted[seat]
            else min(me.presence[seat] + change, 1.0)
        )
        for group in range(2):
            me.fade_progress[seat, group] = advance_progress(
                me.fade_progress[seat, group],
                me.fade_elapsed[seat] if group == 0 else 0.0,
                asked,
                step,
                pace if group == 0 else 1.0,
            )
        me.fade_elapsed[seat] += step


@small_kernel
def _fade_pace(me: Character, step: float) -> float:
    """Return how fast leg weights may move, 0 to 1, in the middle of the next step.

    Full while one foot carries; nothing while both do, or none, unless the body then lands on
    both, which would leave no better moment. It goes from one to the other gradually, so that
    the root is neither kicked nor caught.
    """
    if not me.synchronized:
        return 1.0
    support = me.results[0]
    # Hands may carry too: what counts is that no two feet stand apart.
    moves = support > 1 and (support & DOUBLE) != DOUBLE
    if support == FLIGHT and me.results[1] == DOUBLE:
        moves = me.flight == 0
    if support != me.support or not moves:
        me.alone_time = 0.0
    if not moves:
        return 0.0
    pace = (me.alone_time + 0.5 * step) / FADE_EASE
    me.alone_time += step
    if me.results[1] != support:
        left = (1.0 - me.slot_progress) * me.slot_duration - 0.5 * step
        pace = min(pace, left / FADE_EASE)
    pace = min(max(pace, 0.0), 1.0)
    return pace * pace * (3.0 - 2.0 * pace)


@inlined_kernel
def _settle(shelf: Shelf, me: Character, search: PlannerMemory, rules: Rules) -> None:
    """Let go what has faded out beside the schedule, and say what carries the body."""
    standing = True
    for seat in range(me.occupied):
        if me.status[seat] == LEAVING and not me.playing[seat]:
            progress = me.fade_progress[seat]
            if progress[0] >= 1.0 and progress[1] >= 1.0:
                me.status[seat] = EMPTY
        if me.playing[seat]:
            standing = False
    if standing and me.synchronized:
        me.slot_duration = 0.0
        retry_waiting(shelf, me, search, rules)
    while me.occupied > 0 and me.status[me.occupied - 1] == EMPTY:
        me.occupied -= 1
    me.support = _present_support(shelf, me)


@small_kernel
def _present_support(shelf: Shelf, me: Character) -> int:
    """Return the combined support, or without synchronization that of the heaviest action."""
    if me.synchronized:
        for seat in range(me.occupied):
            if me.playing[seat]:
                return me.results[0]
        return DOUBLE
    heaviest = me.weights[SEATS, LEGS]
    support = DOUBLE
    for seat in range(me.occupied):
        if me.status[seat] >= RUNNING and me.weights[seat, LEGS] > heaviest:
            heaviest = me.weights[seat, LEGS]
            support = support_at(shelf, me.action[seat], me.clip_time[seat])
    return support
