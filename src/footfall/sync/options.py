"""Which actions may go on at the end of a column, and when, seen from one state of the search."""

from __future__ import annotations

import math
from typing import cast

import numpy as np

from footfall.compilation import inner_kernel, small_kernel
from footfall.support import Support
from footfall.sync.prices import GREATEST_RATE, LEAST_RATE, SOON
from footfall.sync.search_memory import SearchMemory
from footfall.sync.tables import SequenceTable

__all__ = ["bounds_of", "disagreement", "has_branch", "open_node", "sets_to_try"]

FLIGHT, CONFLICT = int(Support.FLIGHT), int(Support.CONFLICT)

# A typed number: a literal would have everything that it is passed to compiled twice.
ROOT = cast(int, np.int64(0))

ENDED = -1.0
"""The vote of an action that has ended."""

SHORTEST_WAIT = 1e-3
"""Whoever waits must be able to for this long [s]: a column of no length has no rate."""

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
        place = phase % count
        support = int(table.supports[first + place])
        combined &= support
        memory.support[lane] = support
        if place + 1 < count:
            memory.coming[lane] = table.supports[first + place + 1]
        elif memory.cyclic[lane]:
            memory.coming[lane] = table.supports[first]
        own = table.durations[first + place]
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
    open_node(table, memory, ROOT)
    found = False
    for index in range(sets_to_try(memory)):
        if not found and bounds_of(memory, ROOT, memory.masks[index])[0]:
            found = True
    memory.lanes = kept
    return found


@inner_kernel
def sets_to_try(memory: SearchMemory) -> int:
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


@small_kernel
def bounds_of(memory: SearchMemory, node: int, mask: int) -> tuple[bool, int, float, float]:
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
            longest = memory.latest[lane] - SOON
            if longest < SHORTEST_WAIT:
                possible = False
            latest = min(latest, longest)
        combined &= support
        if support != FLIGHT:
            grounded &= support
    return possible and grounded != CONFLICT and soonest <= latest, combined, soonest, latest
