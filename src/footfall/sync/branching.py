"""One step of the search: what may follow a state, and what it costs."""

from __future__ import annotations

import math
from typing import cast

import numpy as np

from footfall.compilation import inner_kernel, small_kernel
from footfall.support import Support
from footfall.sync.options import bounds_of, disagreement, open_node, sets_to_try
from footfall.sync.prices import (
    DISAGREEMENT_PRICE,
    FLIGHT_VOTE,
    SHORTEST_SUPPORT,
    TIME_VALUE,
    stretch_cost,
)
from footfall.sync.search_memory import DEEPEST, NODES, SearchMemory
from footfall.sync.tables import SequenceTable

__all__ = ["expand"]

FLIGHT = int(Support.FLIGHT)

# A typed number: a literal would have everything that it is passed to compiled twice.
NONE = cast(int, np.int64(-1))

SHORTEST_COLUMN = 0.03
"""A column lasts this long [s] where the rates allow it."""

SAME_TIME = 0.04
"""Two ways to the same phases within this time [s] are one; the cheaper is kept."""


@small_kernel
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
    limit = _worst_kept(memory, node)
    ways = 0
    for index in range(sets_to_try(memory)):
        mask = memory.masks[index]
        possible, after, soonest, latest = bounds_of(memory, node, mask)
        if not possible:
            continue
        ways += 1
        mean, duration = _mean_vote(memory, mask, doubt)
        if memory.lanes > 1:
            # An action alone is played as it is.
            duration = max(duration, SHORTEST_COLUMN)
            if after != combined:
                duration = max(duration, SHORTEST_SUPPORT - memory.steady[node])
        duration = min(max(duration, soonest), latest)
        time = memory.time[node] + duration
        cost = memory.cost[node] + DISAGREEMENT_PRICE * doubt * duration
        if cost - TIME_VALUE * time >= limit:
            # Stretching costs more, and it would not be kept as it is.
            continue
        paid, overdue = _stretch_costs(memory, mask, duration)
        cost += paid
        rank = cost + overdue - TIME_VALUE * time
        child = _place_for(memory, node, mask, time, rank)
        if child >= 0:
            limit = _worst_kept(memory, node)
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


@small_kernel
def _worst_kept(memory: SearchMemory, node: int) -> float:
    """Return the rank below which a child finds a place beside the other nodes; inf if any does."""
    worst = -math.inf
    for other in range(NODES):
        if other != node:
            if not memory.alive[other]:
                return math.inf
            worst = max(worst, memory.rank[other])
    return worst


@small_kernel
def _stretch_costs(memory: SearchMemory, mask: int, duration: float) -> tuple[float, float]:
    """Return what the phases cost that end with a column, and those that are overdue then."""
    paid = overdue = 0.0
    for lane in range(memory.lanes):
        played = memory.played[lane] + duration
        goes_on = mask >> lane & 1
        if memory.vote[lane] >= 0.0 and (goes_on or played > memory.own[lane]):
            cost = stretch_cost(
                played / memory.own[lane], memory.support[lane], memory.concern[lane]
            )
            if goes_on:
                paid += cost
            else:
                overdue += cost
    return paid, overdue


@small_kernel
def _place_for(memory: SearchMemory, node: int, mask: int, time: float, rank: float) -> int:
    """Return a node to be overwritten by a child, or -1 if a better one is kept instead."""
    free = worst = NONE
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
                return other if rank < memory.rank[other] else NONE
        if worst < 0 or memory.rank[other] > memory.rank[worst]:
            worst = other
    if free >= 0:
        return free
    return worst if rank < memory.rank[worst] else NONE


@small_kernel
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
