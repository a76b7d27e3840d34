"""The working memory of the planner's search: one record, made once, so that nothing is allocated.

A *lane* is an action that takes part in the search; a *node* is a state of all lanes at the end
of some column, with what it cost to get there.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from footfall.arrays import Counts, Floats, Indices, Seconds, Supports, Weights
from footfall.compilation import records

__all__ = [
    "DEEPEST",
    "LANES",
    "NODES",
    "PlannerMemory",
    "SearchMemories",
    "SearchMemory",
    "new_planner_memory",
    "new_search_memory",
]

SearchMemories = npt.NDArray[Any]
"""An array of one `SearchMemory`."""


class PlannerMemory(NamedTuple):
    """What planners work in, for all characters of one thread: as in `footfall.sync.Window`."""

    search: SearchMemories
    """That of the default planner."""

    spare_phases: Counts
    """Room for the decided phases of one character, shape (seats, lookahead + 2)."""

    spare_results: Supports
    """Room for their results, shape (lookahead + 2,)."""


LANES = 8
"""How many actions are searched over at most; those of the least priority beyond it are muted."""

NODES = 7
"""How many states are kept side by side, and so how wide the search is."""

DEEPEST = 24
"""How many columns ahead the search goes at most, however short they are."""

MASKS = 15
"""How many sets of actions are tried as those who go on at the end of a column."""


class SearchMemory:
    """What the kernels see: fields of `new_search_memory`, with axes (nodes, lanes) or (lanes,)."""

    lanes: int
    """How many lanes are in use."""

    whole: int
    """The support that gives way to any other."""

    limit: int
    """How many columns an action may be held."""

    seat: Indices
    """The seat of each lane, highest priority first."""

    first: Indices
    """Where its sequence begins in the table."""

    count: Indices
    """How many phases that has."""

    cyclic: Indices
    """Whether it starts over (0 or 1)."""

    weight: Weights
    """Its leg weight; all sum to one."""

    concern: Weights
    """How much its stretch counts; all sum to one."""

    root: Indices
    """Its phase as the search begins."""

    left: Seconds
    """What is left of that phase at the clip's own speed."""

    phase: Indices
    """Phase of each lane at each node, shape (nodes, lanes)."""

    since: Seconds
    """How long it has been played since it or the search began, shape (nodes, lanes)."""

    held: Indices
    """For how many columns it has been held, shape (nodes, lanes)."""

    alive: Indices
    """Whether a node is in use, shape (nodes,); likewise the following."""

    time: Seconds
    """When its column begins, from the beginning of the search."""

    cost: Floats
    """What the way to it costs."""

    rank: Floats
    """What nodes are compared by, smaller is better."""

    steady: Seconds
    """For how long the support before it has lasted when its column begins."""

    grounded: Indices
    """Whether anything but flight is on the way to it, its own column included."""

    depth: Indices
    """How many columns lead to it."""

    offset: Seconds
    """By how much its first column lasts longer than the weighted mean."""

    advancing: Indices
    """Bits of the lanes that go on at the end of each column, shape (nodes, columns)."""

    durations: Seconds
    """How long these columns last, shape (nodes, columns)."""

    masks: Indices
    """The sets of lanes to try, shape (masks,)."""

    support: Supports
    """The node being expanded: what each lane stands on, shape (lanes,); likewise the following."""

    coming: Supports
    """What it stands on in its next phase."""

    own: Seconds
    """How long its phase lasts at the clip's own speed; inf if it has ended."""

    played: Seconds
    """How long it has been played, as if at its own speed up to now."""

    vote: Seconds
    """When it would end at its own speed; -1 if the action has ended."""

    soonest: Seconds
    """When it can end at the greatest rate."""

    latest: Seconds
    """When it must end at the least rate."""


_NUMBERS = {
    np.int64: ("seat first count cyclic root support coming", "alive grounded depth", "phase held"),
    np.float64: (
        "weight concern left own played vote soonest latest",
        "time cost rank steady offset",
        "since",
    ),
}

_TYPE = np.dtype(
    [(name, np.int64) for name in ("lanes", "whole", "limit")]
    + [
        (name, kind, shape)
        for kind, fields in _NUMBERS.items()
        for names, shape in zip(fields, ((LANES,), (NODES,), (NODES, LANES)), strict=True)
        for name in names.split()
    ]
    + [("advancing", np.int64, (NODES, DEEPEST)), ("durations", np.float64, (NODES, DEEPEST))]
    + [("masks", np.int64, (MASKS,))],
    align=True,
)


def new_search_memory() -> SearchMemories:
    """Return the working memory of one thread: an array of one `SearchMemory`."""
    return records(np.zeros(1, dtype=_TYPE))


def new_planner_memory(seats: int, lookahead: int) -> PlannerMemory:
    """Return the memory of one thread for characters of so many seats that decide so far ahead."""
    columns = lookahead + 2
    return PlannerMemory(
        new_search_memory(),
        np.zeros((seats, columns), dtype=np.int32),
        np.zeros(columns, dtype=np.int64),
    )
