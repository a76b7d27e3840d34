"""The planner's search: a beam over the coming columns, a horizon of seconds deep.

The state that is least far in time goes on first, so that those compared are about equally far.
A way that ends before the horizon is a last resort: behind it somebody must be muted.
"""

from __future__ import annotations

from typing import cast

import numpy as np

from footfall.compilation import inner_kernel
from footfall.support import Support
from footfall.sync.branching import expand
from footfall.sync.options import has_branch
from footfall.sync.paper import precedes
from footfall.sync.prices import EQUAL_CONCERN, TIME_VALUE
from footfall.sync.search_memory import DEEPEST, LANES, NODES, SearchMemory
from footfall.sync.tables import Rules, SequenceTable
from footfall.sync.window import Window

__all__ = ["HORIZON", "choose_path", "first_blocked", "gather_lanes", "plant_root"]

HORIZON = 2.0
"""How far the search looks ahead [s]."""

FLIGHT = int(Support.FLIGHT)

# A typed number: a literal would have everything that it is passed to compiled twice.
NOWHERE = cast(int, np.int64(-1))

LIGHTEST = 1e-6
"""Leg weight of an action without any [share]: it follows, and must not be divided by."""


@inner_kernel
def gather_lanes(
    table: SequenceTable, window: Window, memory: SearchMemory, rules: Rules, entering: int
) -> None:
    """Make every action that takes part a lane, highest priority first.

    Args:
        table: All sequences.
        window: The schedule.
        memory: Written.
        rules: The rules of the planner.
        entering: A seat that takes part although it does not play yet, or -1.
    """
    memory.lanes = 0
    memory.whole = table.whole
    memory.limit = rules.most_held
    total = 0.0
    for seat in range(window.playing.shape[0]):
        sequence = window.sequence[seat]
        ended = not table.cyclic[sequence] and (
            window.phases[seat, 0] >= table.phase_count[sequence]
        )
        takes_part = window.playing[seat] and not window.muted[seat] and not ended
        if not takes_part and seat != entering:
            continue
        place = memory.lanes
        while place > 0 and precedes(window, seat, memory.seat[place - 1]):
            place -= 1
        if place >= LANES:
            continue
        for lane in range(min(memory.lanes, LANES - 1), place, -1):
            memory.seat[lane] = memory.seat[lane - 1]
        memory.seat[place] = seat
        memory.lanes = min(memory.lanes + 1, LANES)
    for lane in range(memory.lanes):
        seat = memory.seat[lane]
        sequence = window.sequence[seat]
        memory.first[lane] = table.first[sequence]
        memory.count[lane] = table.phase_count[sequence]
        memory.cyclic[lane] = table.cyclic[sequence]
        memory.weight[lane] = max(window.weight[seat], LIGHTEST)
        total += memory.weight[lane]
    for lane in range(memory.lanes):
        memory.weight[lane] = max(memory.weight[lane] / total, LIGHTEST)
        equal = EQUAL_CONCERN / memory.lanes
        memory.concern[lane] = equal + (1.0 - EQUAL_CONCERN) * memory.weight[lane]


@inner_kernel
def plant_root(table: SequenceTable, window: Window, memory: SearchMemory) -> None:
    """Make the slot being played the only node, without a way to it."""
    for node in range(NODES):
        memory.alive[node] = 0
    combined = memory.whole
    for lane in range(memory.lanes):
        seat = memory.seat[lane]
        phase = window.phases[seat, 0]
        memory.root[lane] = phase
        memory.phase[0, lane] = phase
        memory.left[lane] = window.remaining[seat]
        memory.since[0, lane] = 0.0
        memory.held[0, lane] = window.held[seat]
        combined &= table.supports[memory.first[lane] + phase % memory.count[lane]]
    memory.alive[0] = 1
    memory.time[0] = memory.cost[0] = memory.rank[0] = memory.offset[0] = 0.0
    memory.depth[0] = 0
    memory.steady[0] = window.steady[0]
    memory.grounded[0] = combined != FLIGHT


@inner_kernel
def choose_path(table: SequenceTable, memory: SearchMemory) -> tuple[int, bool]:
    """Search from the root that has been planted.

    Returns:
        The node with the best way to it, or -1 if there is no way at all; and whether that way
        reaches the horizon.
    """
    while True:
        node = NOWHERE
        for other in range(NODES):
            open_end = memory.time[other] < HORIZON and memory.depth[other] < DEEPEST
            if (
                memory.alive[other]
                and open_end
                and (node < 0 or memory.time[other] < memory.time[node])
            ):
                node = other
        if node < 0:
            return _best(memory), True
        if _all_have_ended(memory, node):
            memory.rank[node] -= TIME_VALUE * (HORIZON - memory.time[node])
            memory.time[node] = HORIZON
            continue
        if expand(table, memory, node) == 0 and _best(memory) < 0:
            return (node if memory.depth[node] > 0 else NOWHERE), False


@inner_kernel
def _best(memory: SearchMemory) -> int:
    best = NOWHERE
    for node in range(NODES):
        if memory.alive[node] and (best < 0 or memory.rank[node] < memory.rank[best]):
            best = node
    return best


@inner_kernel
def _all_have_ended(memory: SearchMemory, node: int) -> bool:
    for lane in range(memory.lanes):
        if memory.cyclic[lane] or memory.phase[node, lane] < memory.count[lane]:
            return False
    return True


@inner_kernel
def first_blocked(table: SequenceTable, memory: SearchMemory) -> int:
    """Return the first lane in order of priority that finds no way beside those before it.

    The first of all always finds one (S-19), so this one can be muted.
    """
    for lanes in range(2, memory.lanes):
        if not has_branch(table, memory, lanes):
            return lanes - 1
    return memory.lanes - 1
