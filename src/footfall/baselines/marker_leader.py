"""A leader and its followers, kept in step by markers: the best that engines offer.

It imitates the synchronization groups of Unreal Engine: in each clip the landings of the feet are
marked; of the cycles that play, the heaviest leads at its own rate, and every other one is put
between the same two markers at the same share of the way. Only feet that land in both count as
markers; where two clips have none in common, or not in that order, the follower is put at the
leader's share of the whole cycle, as there. What is played once stays outside the group and plays
at its own speed, which is how one-shot motions are used there.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from footfall.baselines.landings import Landing, landings
from footfall.baselines.pacing import Playing
from footfall.support import SupportSequence

__all__ = ["MarkerLeader"]


class MarkerLeader:
    """Followers between the markers of their leader; see `Pacing`."""

    def clip_times(self, playing: Sequence[Playing], dt: float) -> list[float]:
        """Return where each clip is `dt` seconds later [s]; see `Pacing.clip_times`."""
        group = [one for one in playing if one.supports.cyclic]
        settled = [one for one in group if not one.entering] or group
        leader = max(settled, key=lambda one: one.weight, default=None)
        times: list[float] = []
        for one in playing:
            if leader is None or one is leader or not one.supports.cyclic:
                times.append(one.clip_time + dt)
            else:
                times.append(_follow(one, leader.supports, leader.clip_time + dt))
        return times


def _follow(one: Playing, leading: SupportSequence, time: float) -> float:
    """Return where a follower belongs while its leader is at a time [s]."""
    turn = one.supports.duration
    places = _places(one.supports, leading, time)
    if not places:
        places = [(time / leading.duration) % 1.0 * turn]
    if one.entering:
        return min(place % turn for place in places)
    turns = one.clip_time // turn
    every = [place + (turns + k) * turn for place in places for k in (-1, 0, 1)]
    return max(one.clip_time, min(every, key=lambda place: abs(place - one.clip_time)))


def _places(own: SupportSequence, leading: SupportSequence, time: float) -> list[float]:
    """Return every place in a cycle between the same markers as the leader's time, as far on."""
    feet = {mark.foot for mark in landings(own)} & {mark.foot for mark in landings(leading)}
    time %= leading.duration
    for before, after in _intervals(leading, feet):
        for turn in (0.0, leading.duration):
            if before.time <= time + turn < after.time:
                share = (time + turn - before.time) / (after.time - before.time)
                return [
                    one.time + share * (other.time - one.time)
                    for one, other in _intervals(own, feet)
                    if (one.foot, other.foot) == (before.foot, after.foot)
                ]
    return []


def _intervals(supports: SupportSequence, feet: set[int]) -> list[tuple[Landing, Landing]]:
    """Return neighboring markers of a cycle, the last with the first of the next turn."""
    marks = [mark for mark in landings(supports) if mark.foot in feet]
    again = [Landing(mark.time + supports.duration, mark.foot) for mark in marks[:1]]
    return list(pairwise([*marks, *again]))
