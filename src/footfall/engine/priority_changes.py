"""Priorities that change while their action plays: the weights come to them as in a fade.

On each body part the action's own share, P / (P + Q) beside the others' priorities Q, goes along
a cubic that begins with the speed it has and ends at rest. So a priority may be asked for in every
frame too: weights then follow it like a damped spring. Where one of the two priorities is 0 the
action comes to the body part, or leaves it, by its level instead, since the neutral motion may
have been alone there.
"""

from __future__ import annotations

from footfall.compilation import inner_kernel, small_kernel
from footfall.engine.record import Character
from footfall.engine.state import LEAVING, RUNNING
from footfall.skeleton import BodyPart
from footfall.timing import advance_progress, level, reverse_fade, smoothstep

__all__ = [
    "advance_changes",
    "ask_priority",
    "present_priorities",
    "read_levels",
    "settle_priority",
]

LEGS = int(BodyPart.LEGS)
PARTS = len(BodyPart)

LONE = 0.1
"""Share of its own priority that an action counts as the least of what is there besides it."""


@small_kernel
def settle_priority(me: Character, seat: int, part: int, priority: float) -> None:
    """Give an action a priority at once."""
    me.priorities_asked[seat, part] = priority
    me.priority_progress[seat, part] = 1.0


@inner_kernel
def ask_priority(me: Character, seat: int, part: int, priority: float, seconds: float) -> None:
    """Let the priority of an action on a body part become another one in some seconds, > 0."""
    before, asked = me.priorities_before[seat, part], me.priorities_asked[seat, part]
    progress = me.priority_progress[seat, part]
    changing = progress < 1.0
    comes, goes = changing and before == 0.0, changing and asked == 0.0
    if (comes and priority > 0.0) or (goes and priority == 0.0) or priority == asked:
        me.priorities_asked[seat, part] = priority
        return
    if comes or goes:
        me.priorities_asked[seat, part] = priority
        me.priorities_before[seat, part] = asked
        progress, elapsed = reverse_fade(progress, seconds)
        me.priority_progress[seat, part] = progress
        if part == LEGS:
            me.priority_elapsed[seat] = elapsed
        return
    read_levels(me, 0 if part == LEGS else 1)
    present_priorities(me, part)
    speed = me.share_speed[seat] * seconds / me.priority_seconds[seat] if changing else 0.0
    me.share_speed_before[seat, part] = speed
    me.priorities_before[seat, part] = me.priorities_now[seat, 0]
    me.priorities_asked[seat, part] = priority
    me.priority_progress[seat, part] = 0.0
    if part == LEGS:
        me.priority_elapsed[seat] = 0.0


@inner_kernel
def advance_changes(me: Character, step: float, pace: float) -> None:
    """Let every change go on for `step` seconds, on the legs as slowly as their weights may."""
    changing = False
    for seat in range(me.occupied):
        for part in range(PARTS):
            if me.priority_progress[seat, part] >= 1.0:
                continue
            progress = advance_progress(
                me.priority_progress[seat, part],
                me.priority_elapsed[seat] if part == LEGS else 0.0,
                me.priority_seconds[seat],
                step,
                pace if part == LEGS else 1.0,
            )
            me.priority_progress[seat, part] = progress
            changing = changing or progress < 1.0
        me.priority_elapsed[seat] += step
    me.changing = changing


@small_kernel
def read_levels(me: Character, group: int) -> None:
    """Write the activation level of each action on the legs (0) or on the rest of the body (1)."""
    for seat in range(me.occupied):
        me.levels[seat] = 0.0
        progress = me.fade_progress[seat, group]
        if me.status[seat] == RUNNING:
            me.levels[seat] = level(progress)
        elif me.status[seat] == LEAVING:
            me.levels[seat] = 1.0 - level(progress)
        if group == 0:
            me.levels[seat] *= level(me.presence[seat])


@inner_kernel
def present_priorities(me: Character, part: int) -> None:
    """Write the priorities that actions have by now on a body part, and their levels there.

    Args:
        me: The character, its levels as they are read. Written: `priorities_now`, `taken`, and
            `share_speed` of those that are on their way.
        part: Which body part.
    """
    for seat in range(me.occupied):
        me.taken[seat] = me.levels[seat]
        me.priorities_now[seat, 0] = me.priorities_asked[seat, part]
        if me.priority_progress[seat, part] >= 1.0:
            continue
        before, asked = me.priorities_before[seat, part], me.priorities_asked[seat, part]
        if before == 0.0 or asked == 0.0:
            share = smoothstep(me.priority_progress[seat, part])
            me.priorities_now[seat, 0] = max(before, asked)
            me.taken[seat] *= share if before == 0.0 else 1.0 - share
            continue
        others = 0.0
        for other in range(me.occupied):
            if other != seat:
                others += me.levels[other] * _between(me, other, part)
        others = max(others, LONE * max(before, asked))
        share = _share(me, seat, part, before / (before + others), asked / (asked + others))
        me.priorities_now[seat, 0] = others * share / (1.0 - share)


@small_kernel
def _between(me: Character, seat: int, part: int) -> float:
    """Return about what priority an action has by now."""
    progress = me.priority_progress[seat, part]
    if progress >= 1.0:
        return me.priorities_asked[seat, part]
    before, asked = me.priorities_before[seat, part], me.priorities_asked[seat, part]
    return before + (asked - before) * smoothstep(progress)


@small_kernel
def _share(me: Character, seat: int, part: int, first: float, last: float) -> float:
    """Return the share that an action has by now on its way from one to another, 0 to 1."""
    way, speed = me.priority_progress[seat, part], me.share_speed_before[seat, part]
    left = 1.0 - way
    me.share_speed[seat] = left * (6.0 * way * (last - first) + speed * (1.0 - 3.0 * way))
    share = first + (last - first) * smoothstep(way) + speed * way * left * left
    # Turned back at full speed it may go on for a little, but never leaves the body part.
    return min(max(share, LONE * min(first, last)), 1.0 - LONE * (1.0 - max(first, last)))
