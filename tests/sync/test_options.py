"""Which actions may go on together, where there are too many to try every set of them."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.compilation import kernel
from footfall.support import Support
from footfall.sync.options import FULL_SEARCH, sets_to_try
from footfall.sync.search_memory import LANES, SearchMemories, new_search_memory

SUPPORTS = st.sampled_from([Support.FLIGHT, Support.LEFT, Support.RIGHT, Support.DOUBLE])
LANE = st.tuples(SUPPORTS, SUPPORTS, st.floats(0.1, 1.0))


@kernel
def count_sets(memories: SearchMemories) -> int:
    return sets_to_try(memories[0])


def sets_of(lanes: list[tuple[Support, Support, float]]) -> list[int]:
    """Return what is tried where each lane stands on one support and comes to another."""
    memories = new_search_memory()
    memories["lanes"], memories["whole"] = len(lanes), int(Support.DOUBLE)
    for lane, told in enumerate(lanes):
        for field, value in zip(("support", "coming", "vote"), told, strict=True):
            memories[field][0, lane] = value
    count = count_sets(memories)
    return memories["masks"][0, :count].tolist()


def clashes(support: Support, constraint: Support) -> bool:
    return support is not Support.FLIGHT and support & constraint is Support.CONFLICT


@settings(deadline=None)
@given(st.lists(LANE, min_size=FULL_SEARCH + 1, max_size=LANES))
def test_a_lane_goes_another_way_than_it_would_only_where_it_must(
    lanes: list[tuple[Support, Support, float]],
) -> None:
    masks = sets_of(lanes)
    assert len(masks) == len(lanes)
    by_vote = sorted(range(len(lanes)), key=lambda lane: lanes[lane][2])
    # First everybody goes on; then the first to end alone, the first two, and so on.
    asked = [set(by_vote), *(set(by_vote[:size]) for size in range(1, len(lanes)))]
    for mask, those in zip(masks, asked, strict=True):
        constraint = Support.DOUBLE
        for lane, (support, coming, _) in enumerate(lanes):
            wish, other = (coming, support) if lane in those else (support, coming)
            goes = bool(mask >> lane & 1)
            as_asked = goes == (lane in those)
            assert as_asked != clashes(wish, constraint)
            taken = wish if as_asked else other
            if taken is not Support.FLIGHT:
                constraint &= taken


def test_of_few_lanes_every_set_is_tried() -> None:
    for count in range(1, FULL_SEARCH + 1):
        masks = sets_of([(Support.DOUBLE, Support.DOUBLE, 1.0)] * count)
        assert masks == list(range(1, 2**count))
