"""From priorities and levels to weights per body part, and to the duration of a slot (eq. 6)."""

from __future__ import annotations

from footfall.arrays import Seconds, SmallFloats, Weights
from footfall.compilation import lean_kernel, small_kernel

__all__ = ["mean_vote", "normalize_weights", "slot_duration"]

Shares = Weights | SmallFloats
"""Weights in either precision."""

LONE = 0.1
"""Share of its own priority that an action counts as the least of what is there besides it."""


@lean_kernel
def normalize_weights(priorities: Shares, levels: Shares, out: Shares) -> None:
    """Share each body part among the actions, and give what they leave to the neutral motion.

    On one body part, with priority P and level L of each action and sums over the actions that
    have a priority there,

        weight  = P M / Σ P M · min(1, Σ L)        neutral = 1 - min(1, Σ L)

        M = L / (1 + P / Q (1 - L))      Q = Σ P L of the others, at least P / 10.

    M is the level bent so that the *weight* of an action that fades while the others stay goes in
    proportion to its level: with M = L an action of high priority would be nearly all there at
    half its level, and its fade would begin or end with a jerk. So a lone action at level 1 has
    weight exactly 1, actions at level 1 share by priority, an action of level or priority 0 has
    weight exactly 0, the neutral motion has weight only while the levels do not add up to one, a
    cross-fade with levels adding up to one never shows it, and each weight is continuous in each
    level.

    Args:
        priorities: Priority of each seat's action for each body part, >= 0, shape
            (seats, parts).
        levels: Activation level of each seat, 0..1, shape (seats,) or fewer: the seats after those
            are empty, and have weight 0 as they are.
        out: The weights, shape (seats + 1, parts), summing to one over the rows; the last row
            is the neutral motion.
    """
    seats, neutral = levels.shape[0], priorities.shape[0]
    for part in range(priorities.shape[1]):
        if part > 0 and _alike(priorities, levels, part):
            for seat in range(seats):
                out[seat, part] = out[seat, part - 1]
            out[neutral, part] = out[neutral, part - 1]
            continue
        total = 0.0
        presence = 0.0
        for seat in range(seats):
            out[seat, part] = 0.0
            if priorities[seat, part] > 0.0:
                total += priorities[seat, part] * levels[seat]
                presence += levels[seat]
        presence = min(presence, 1.0)
        if total <= 0.0:
            presence = 0.0
        bent_total = 0.0
        for seat in range(seats):
            own = priorities[seat, part] * levels[seat]
            if own > 0.0 and presence > 0.0:
                others = max(total - own, LONE * priorities[seat, part])
                ratio = priorities[seat, part] / others
                own /= 1.0 + ratio * (1.0 - levels[seat])
                out[seat, part] = own
                bent_total += own
        for seat in range(seats):
            if bent_total > 0.0:
                out[seat, part] = out[seat, part] / bent_total * presence
        out[neutral, part] = 1.0 - presence


@small_kernel
def _alike(priorities: Shares, levels: Shares, part: int) -> bool:
    """Return whether every action has the same priority on a body part as on the one before."""
    for seat in range(levels.shape[0]):
        if priorities[seat, part] != priorities[seat, part - 1]:
            return False
    return True


@small_kernel
def slot_duration(shares: Weights, natural_durations: Seconds, count: int) -> float:
    """Return how long a slot lasts: the weighted mean of what its phases last (eq. 6).

    Args:
        shares: Leg weight of each action that votes, >= 0, shape (at least count,). They need
            not sum to one: the actions that do not vote, and the neutral motion, which never
            does, are left out. Where all are zero the plain mean is returned.
        natural_durations: What each of their phases in this slot lasts at the clip's own
            speed [s], shape (at least count,).
        count: How many actions vote, >= 1; entries from there on are not read.
    """
    total = 0.0
    weighted = 0.0
    plain = 0.0
    for voter in range(count):
        total += shares[voter]
        weighted += shares[voter] * natural_durations[voter]
        plain += natural_durations[voter]
    return mean_vote(total, weighted, plain, count)


@small_kernel
def mean_vote(total: float, weighted: float, plain: float, count: int) -> float:
    """Return the weighted mean of some votes from its sums (eq. 6).

    Args:
        total: The sum of all shares.
        weighted: That of each vote times its share.
        plain: That of the votes; their plain mean is returned where all shares are zero.
        count: How many votes there are, >= 1.
    """
    return weighted / total if total > 0.0 else plain / count
