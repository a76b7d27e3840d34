"""One step of the search: who may go on at the end of a column, when that is, what it costs."""

from __future__ import annotations

import math

from footfall.compilation import inner_kernel
from footfall.support import Support
from footfall.sync.prices import (
    DISAGREEMENT_PRICE,
    FLIGHT_VOTE,
    GREATEST_RATE,
    LEAST_RATE,
    SHORTEST_SUPPORT,
    TIME_VALUE,
    stretch_cost,
)
from footfall.sync.search_memory import DEEPEST, LANES, NODES, SearchMemory
from footfall.sync.tables import SequenceTable

__all__ = ["disagreement", "expand", "has_branch", "open_node"]

FLIGHT, CONFLICT = int(Support.FLIGHT), int(Support.CONFLICT)

ENDED = -1.0
"""The vote of an action that has ended."""

SOON = 0.05
"""Whoever is held must be able to go on for this long afterwards [s]."""

SHORTEST_COLUMN = 0.03
"""A column lasts this long [s] where the rates allow it."""

SAME_TIME = 0.04
"""Two ways to the same phases within this time [s] are one; the cheaper is kept."""

FULL_SEARCH = 4
"""Up to this many lanes all sets are tried; of more, those that are due first."""


@inner_kernel
def open_node(table: SequenceTable, memory: SearchMemory, node: int) -> tuple[int, float]:
    """Work out what each lane stands on and when its phase may end, seen from one node.

    Returns:
        The combined support, and how much the feet disagree, 0 to 1 a foot.
    """
    combined = memory.whole
    for lane in range(memory.lanes):
        phase = memory.phase[node, lane]
        count = memory.count[lane]
        first = memory.first[lane]
        memory.coming[lane] = memory.whole
        if not memory.cyclic[lane] and phase >= count:
            memory.support[lane] = memory.whole
            memory.vote[lane] = ENDED
            memory.own[lane] = memory.latest[lane] = math.inf
            memory.played[lane] = memory.soonest[lane] = 0.0
            continue
        support = table.supports[first + phase % count]
        combined &= support
        memory.support[lane] = support
        if memory.cyclic[lane] or phase + 1 < count:
            memory.coming[lane] = table.supports[first + (phase + 1) % count]
        own = table.durations[first + phase % count]
        left = memory.left[lane] if phase == memory.root[lane] else own
        since = memory.since[node, lane]
        memory.own[lane] = own
        memory.played[lane] = own - left + since
        memory.vote[lane] = max(left - since, 0.0)
        memory.soonest[lane] = max(left / GREATEST_RATE - since, 0.0)
        memory.latest[lane] = left / LEAST_RATE - since
    return combined, disagreement(memory, 0)


@inner_kernel
def disagreement(memory: SearchMemory, mask: int) -> float:
    """Return the sum over the limbs of 4 a (1 - a) once a set of lanes has gone on.

    The share a is that of the leg weight of those who plant the limb; the ended do not count.
    """
    total = 0.0
    for lane in range(memory.lanes):
        if memory.vote[lane] >= 0.0:
            total += memory.weight[lane]
    if total <= 0.0:
        return 0.0
    doubt = 0.0
    limb = 2
    while limb <= memory.whole:
        share = 0.0
        for lane in range(memory.lanes):
            if memory.vote[lane] >= 0.0:
                support = memory.coming[lane] if mask >> lane & 1 else memory.support[lane]
                if support & limb:
                    share += memory.weight[lane]
        share /= total
        doubt += 4.0 * share * (1.0 - share)
        limb <<= 1
    return doubt


@inner_kernel
def has_branch(table: SequenceTable, memory: SearchMemory, lanes: int) -> bool:
    """Return whether the first lanes, without the others, can go on from the root."""
    kept = memory.lanes
    memory.lanes = lanes
    open_node(table, memory, 0)
    found = False
    for index in range(_sets_to_try(memory)):
        if not found and _bounds(memory, 0, memory.masks[index])[0]:
            found = True
    memory.lanes = kept
    return found


@inner_kernel
def _sets_to_try(memory: SearchMemory) -> int:
    """Write the sets of lanes that may go on to `memory.masks`; return how many."""
    if memory.lanes <= FULL_SEARCH:
        for mask in range(1, 1 << memory.lanes):
            memory.masks[mask - 1] = mask
        return (1 << memory.lanes) - 1
    everybody = (1 << memory.lanes) - 1
    memory.masks[0] = _without_conflict(memory, everybody)
    mask = 0
    for size in range(memory.lanes - 1):
        due = -1
        for lane in range(memory.lanes):
            free = not mask >> lane & 1
            if free and (due < 0 or memory.vote[lane] < memory.vote[due]):
                due = lane
        mask |= 1 << due
        memory.masks[size + 1] = _without_conflict(memory, mask)
    return memory.lanes


@inner_kernel
def _without_conflict(memory: SearchMemory, mask: int) -> int:
    """Let each lane, highest priority first, go on or wait instead if only that is possible."""
    constraint = memory.whole
    for lane in range(memory.lanes):
        bit = 1 << lane
        support = memory.coming[lane] if mask & bit else memory.support[lane]
        if support != FLIGHT and constraint & support == CONFLICT:
            mask ^= bit
            support = memory.coming[lane] if mask & bit else memory.support[lane]
        if support != FLIGHT:
            constraint &= support
    return mask


@inner_kernel
def _bounds(memory: SearchMemory, node: int, mask: int) -> tuple[bool, int, float, float]:
    """Return whether a set may go on, the support then, and when that is at the soonest, latest."""
    combined = grounded = memory.whole
    soonest, latest = 0.0, math.inf
    possible = mask != 0
    for lane in range(memory.lanes):
        vote = memory.vote[lane]
        if mask >> lane & 1:
            support = memory.coming[lane]
            soonest = max(soonest, memory.soonest[lane])
            latest = min(latest, memory.latest[lane])
            if vote < 0.0:
                possible = False
        else:
            support = memory.support[lane]
            waits = support != memory.whole or vote <= 0.0
            if vote >= 0.0 and waits and memory.held[node, lane] >= memory.limit:
                possible = False
            latest = min(latest, memory.latest[lane] - SOON)
        combined &= support
        if support != FLIGHT:
            grounded &= support
    return possible and grounded != CONFLICT and soonest <= latest, combined, soonest, latest


@inner_kernel
def _mean_vote(memory: SearchMemory, mask: int, doubt: float) -> tuple[float, float]:
    """Return the weighted mean of when a set would end, and when the feet would like it to end.

    A column in which the feet disagree more than in the next one is better short, and long if
    they disagree less. Between the first and the last vote no length strays from both.
    """
    weighted = total = last = 0.0
    first = math.inf
    for lane in range(memory.lanes):
        if mask >> lane & 1:
            vote = memory.vote[lane]
            weight = memory.weight[lane]
            if memory.support[lane] == FLIGHT:
                weight *= FLIGHT_VOTE
            weighted += weight * vote
            total += weight
            first, last = min(first, vote), max(last, vote)
    mean = weighted / total
    if last - first < 1e-9:
        return mean, mean
    worse = 2.0 * (doubt - disagreement(memory, mask))
    wanted = first if worse > 0.0 else last
    return mean, mean + min(abs(worse), 1.0) * (wanted - mean)


@inner_kernel
def expand(table: SequenceTable, memory: SearchMemory, node: int) -> int:
    """Replace a node by what may follow it; return how many ways there are."""
    combined, doubt = open_node(table, memory, node)
    ways = 0
    for index in range(_sets_to_try(memory)):
        mask = memory.masks[index]
        possible, after, soonest, latest = _bounds(memory, node, mask)
        if not possible:
            continue
        ways += 1
        mean, duration = _mean_vote(memory, mask, doubt)
        duration = max(duration, SHORTEST_COLUMN)
        if after != combined:
            duration = max(duration, SHORTEST_SUPPORT - memory.steady[node])
        duration = min(max(duration, soonest), latest)
        cost = memory.cost[node] + DISAGREEMENT_PRICE * doubt * duration
        overdue = 0.0
        for lane in range(memory.lanes):
            played = memory.played[lane] + duration
            goes_on = mask >> lane & 1
            if memory.vote[lane] >= 0.0 and (goes_on or played > memory.own[lane]):
                paid = stretch_cost(
                    played / memory.own[lane], memory.support[lane], memory.concern[lane]
                )
                if goes_on:
                    cost += paid
                else:
                    overdue += paid
        time = memory.time[node] + duration
        rank = cost + overdue - TIME_VALUE * time
        child = _place_for(memory, node, mask, time, rank)
        if child >= 0:
            memory.time[child] = time
            memory.cost[child] = cost
            memory.rank[child] = rank
            memory.steady[child] = memory.steady[node] + duration if after == combined else 0.0
            memory.grounded[child] = memory.grounded[node] or after != FLIGHT
            _go_on(memory, node, child, mask, duration)
            if memory.depth[node] == 0:
                memory.offset[child] = duration - mean
    memory.alive[node] = 0
    return ways


@inner_kernel
def _place_for(memory: SearchMemory, node: int, mask: int, time: float, rank: float) -> int:
    """Return a node to be overwritten by a child, or -1 if a better one is kept instead."""
    free = worst = -1
    for other in range(NODES):
        if other == node:
            continue
        if not memory.alive[other]:
            free = other
            continue
        if abs(memory.time[other] - time) < SAME_TIME:
            same = True
            for lane in range(memory.lanes):
                phase = memory.phase[node, lane] + (mask >> lane & 1)
                if memory.phase[other, lane] != phase:
                    same = False
                    break
            if same:
                return other if rank < memory.rank[other] else -1
        if worst < 0 or memory.rank[other] > memory.rank[worst]:
            worst = other
    if free >= 0:
        return free
    return worst if rank < memory.rank[worst] else -1


@inner_kernel
def _go_on(memory: SearchMemory, node: int, child: int, mask: int, duration: float) -> None:
    """Write the state after a column."""
    for lane in range(memory.lanes):
        goes_on = mask >> lane & 1
        memory.phase[child, lane] = memory.phase[node, lane] + goes_on
        memory.since[child, lane] = 0.0 if goes_on else memory.since[node, lane] + duration
        splits = memory.support[lane] == memory.whole and memory.vote[lane] > duration
        held = memory.held[node, lane] + (0 if splits else 1)
        memory.held[child, lane] = 0 if goes_on else held
    depth = memory.depth[node]
    for column in range(depth):
        memory.advancing[child, column] = memory.advancing[node, column]
        memory.durations[child, column] = memory.durations[node, column]
    memory.advancing[child, depth] = mask
    memory.durations[child, depth] = duration
    memory.depth[child] = min(depth + 1, DEEPEST)
    memory.offset[child] = memory.offset[node]
    memory.alive[child] = 1


assert FULL_SEARCH < LANES
