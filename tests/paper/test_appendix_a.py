"""Appendix A, equations 7 to 12: that a column in conflict always has a solution."""

from __future__ import annotations

from itertools import combinations, product

import pytest
from tests.paper.requirements import requirement
from tests.sync.strict_sequences import every_strict_text

from footfall.support import Support, SupportSequence
from footfall.sync import Synchronizer
from footfall.sync.columns import combine_column
from footfall.sync.paper import synchronize_column
from footfall.sync.tables import SequenceTable, rules_of
from footfall.sync.window import Window

ELEMENTS = (Support.FLIGHT, Support.LEFT, Support.RIGHT, Support.DOUBLE)
CYCLIC = [text for text in every_strict_text(3) if text.endswith("*")]


def combined(supports: list[Support]) -> Support:
    """Return what some supports make together."""
    result = Support.DOUBLE
    for support in supports:
        result = result & support
    return result


@requirement(121, "The algorithm tries to extend some of the last synchronized elements.")
@requirement(64, "Consider that the motion is synchronized until the step k+nk")
@pytest.mark.parametrize("lookahead", [1, 2, 5])
def test_equations_7_to_9_every_column_of_the_window_is_free_of_conflict(lookahead: int) -> None:
    for one, other in product(CYCLIC[::3], repeat=2):
        synchronizer = Synchronizer(
            [SupportSequence.parse(one), SupportSequence.parse(other)],
            planner="paper",
            lookahead=lookahead,
        )
        synchronizer.start(0)
        synchronizer.start(1)
        for _ in range(6):
            results = synchronizer.schedule.results
            assert len(results) == lookahead + 1
            assert Support.CONFLICT not in results
            synchronizer.next_slot()


@requirement(63, "The following algorithm is then applied iteratively during the animation.")
@requirement(65, "our algorithm must synchronize step k + nk + 1")
@requirement(68, "without creating discontinuities in the animation")
def test_only_the_new_last_column_is_decided_at_each_step() -> None:
    pairs = list(product(CYCLIC[::4], repeat=2))
    for one, other in pairs:
        synchronizer = Synchronizer(
            [SupportSequence.parse(one), SupportSequence.parse(other)], planner="paper", lookahead=3
        )
        synchronizer.start(0)
        if not synchronizer.start(1):
            continue
        before = synchronizer.schedule
        synchronizer.next_slot()
        if synchronizer.waiting:
            continue
        after = synchronizer.schedule
        # What was decided stays, so what is extended has not begun: nothing jumps.
        assert after.results[:-1] == before.results[1:]
        for row_before, row_after in zip(before.rows, after.rows, strict=True):
            assert row_after.phases[:-1] == row_before.phases[1:]


@requirement(123, "be the maximal set with the elements at step")
@requirement(
    125,
    "represents the indices of the motions in which last synchronized elements have been extended"
    " to solve the synchronization problem",
)
@pytest.mark.parametrize("count", [2, 3])
def test_equations_10_to_12_the_set_that_goes_on_is_never_empty_and_the_rest_is_held(
    count: int,
) -> None:
    conflicts = 0
    for present in product(ELEMENTS, repeat=count):
        before = combined(list(present))
        if before in (Support.CONFLICT, Support.FLIGHT):
            continue
        for coming in product(ELEMENTS, repeat=count):
            if combined(list(coming)) is not Support.CONFLICT:
                continue
            conflicts += 1
            largest = max(
                (
                    chosen
                    for size in range(count + 1)
                    for chosen in combinations(range(count), size)
                    if before & combined([coming[i] for i in chosen]) is not Support.CONFLICT
                ),
                key=len,
            )
            assert largest
            column = [coming[i] if i in largest else present[i] for i in range(count)]
            # Equation 12 prints other than Ø; other than Err is what the argument needs (S-29).
            assert combined(column) is not Support.CONFLICT
    assert conflicts > 10


@requirement(126, "does not represent all the solutions of the synchronization")
def test_the_priority_rule_finds_another_solution_than_appendix_a() -> None:
    table = SequenceTable.of([SupportSequence.parse(text) for text in ("D L*", "R D*")])
    rules = rules_of("paper")
    window = Window.empty(2, 1)
    window.playing[:] = True
    window.sequence[:] = window.age[:] = (0, 1)
    window.priority[:] = (2.0, 1.0)
    window.phases[:, 0] = (0, 1)
    assert combine_column(table, window, rules, 0)
    assert synchronize_column(table, window, rules, 1)
    # By priority the second waits; held would be, as well, the first.
    assert window.phases[:, 1].tolist() == [1, 1]
    window.phases[:, 1] = (0, 2)
    assert combine_column(table, window, rules, 1)
