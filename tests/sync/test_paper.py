"""The priority rule against the paper's own reasoning, and against the slow synchronizer."""

from __future__ import annotations

import json
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.oracles.slow_synchronizer import SlowSynchronizer, play
from tests.paper.requirements import requirement
from tests.sync.strict_sequences import every_strict_text, strict_texts

from footfall.scenario.schedule_problem import solve_problem
from footfall.support import Support, SupportSequence
from footfall.sync.columns import combine_column, support_of
from footfall.sync.paper import precedes, synchronize_column, try_start
from footfall.sync.tables import SequenceTable, rules_of
from footfall.sync.window import Window


def running(
    texts: list[str], *, columns: int, priorities: list[float] | None = None
) -> tuple[SequenceTable, Window]:
    """Put all in at their first phase, with the first named having priority."""
    table = SequenceTable.of([SupportSequence.parse(text) for text in texts])
    window = Window.empty(len(texts), columns - 2)
    window.playing[:] = True
    window.sequence[:] = window.age[:] = range(len(texts))
    window.priority[:] = range(len(texts), 0, -1) if priorities is None else priorities
    window.phases[:, 0] = 0
    return table, window


@requirement(5, "we demonstrate that our algorithm always finds at least one solution")
@pytest.mark.parametrize("planner", ["paper", "footfall"])
def test_the_rule_never_fails_on_strict_sequences_that_never_end(planner: Any) -> None:
    # Theorem S-1, for every pair of cyclic strict sequences of up to three phases.
    rules = rules_of(planner)
    cyclic = [text for text in every_strict_text(3) if text.endswith("*")]
    for one, other in product(cyclic, repeat=2):
        table, window = running([one, other], columns=20)
        if combine_column(table, window, rules, 0):
            for column in range(1, 20):
                assert synchronize_column(table, window, rules, column), (one, other, column)


@settings(deadline=None, max_examples=150)
@given(
    texts=st.lists(strict_texts(longest=8, cyclic=True), min_size=2, max_size=8),
    priorities=st.lists(st.sampled_from([1.0, 2.0, 3.0]), min_size=8, max_size=8),
)
def test_nor_do_eight_of_them_of_any_length(texts: list[str], priorities: list[float]) -> None:
    rules = rules_of("paper")
    table, window = running(texts, columns=40, priorities=priorities[: len(texts)])
    if combine_column(table, window, rules, 0):
        leader = max(range(len(texts)), key=lambda i: (priorities[i], -i))
        for column in range(1, 40):
            assert synchronize_column(table, window, rules, column)
        # S-5: the first in order of priority is never held.
        assert np.array_equal(window.phases[leader], np.arange(40))


@requirement(128, "Ties of priority are resolved by the order of activation.")
def test_of_equal_priorities_the_older_one_goes_first() -> None:
    _, window = running(["R D*", "L D*"], columns=3, priorities=[1.0, 1.0])
    window.age[:] = [4, 3]
    assert precedes(window, 1, 0)
    assert not precedes(window, 0, 1)
    window.priority[0] = 1.5
    assert precedes(window, 0, 1)


def test_the_paper_example_of_a_held_double_support() -> None:
    # Figure 8 with the second action having priority.
    table, window = running(["D R*", "- L*"], columns=3, priorities=[1.0, 2.0])
    assert combine_column(table, window, rules_of("paper"), 0)
    assert synchronize_column(table, window, rules_of("paper"), 1)
    assert window.phases[:, 1].tolist() == [0, 1]
    assert window.results[1] == Support.LEFT


def test_the_rule_fails_where_an_ended_action_has_the_other_foot() -> None:
    table, window = running(["D L*", "R"], columns=3)
    assert combine_column(table, window, rules_of("paper"), 0)
    assert not synchronize_column(table, window, rules_of("paper"), 1)
    assert window.results[1] == Support.CONFLICT


def test_stopping_the_ended_action_lets_the_others_go_on() -> None:
    table, window = running(["D L*", "R"], columns=6)
    rules = rules_of("paper", ended="stop")
    assert combine_column(table, window, rules, 0)
    for column in range(1, 6):
        assert synchronize_column(table, window, rules, column)
    assert window.phases.tolist() == [[0, 1, 2, 3, 4, 5], [0, -1, -1, -1, -1, -1]]
    assert window.results.tolist() == [5, 3, 7, 3, 7, 3]


@requirement(122, "Unfortunately, this solution does not solve the problem but just delays it.")
def test_appendix_a_always_finds_a_column_and_may_starve_the_first() -> None:
    rules = rules_of("paper", falls_back=True)
    table, window = running(["D L*", "R"], columns=6)
    assert combine_column(table, window, rules, 0)
    for column in range(1, 6):
        assert synchronize_column(table, window, rules, column)
    assert window.phases[0].tolist() == [0, 0, 0, 0, 0, 0]


def test_only_ended_actions_on_the_other_foot_are_stopped() -> None:
    rules = rules_of("paper", ended="stop")
    table, window = running(["D L*", "R", "D"], columns=3)
    assert combine_column(table, window, rules, 0)
    assert synchronize_column(table, window, rules, 1)
    assert window.phases[:, 1].tolist() == [1, -1, 1]


@requirement(
    124, "is enough to find a solution (even if the extension of a jump is not an ideal solution)"
)
def test_of_several_flights_appendix_a_holds_that_of_the_last_in_priority() -> None:
    rules = rules_of("paper", falls_back=True)
    for priorities, held in (([3.0, 2.0, 1.0], [1, 1, 0]), ([1.0, 2.0, 3.0], [0, 1, 1])):
        table, window = running(["- L*", "R", "- L D*"], columns=3, priorities=priorities)
        assert combine_column(table, window, rules, 0)
        assert synchronize_column(table, window, rules, 1)
        assert window.phases[:, 1].tolist() == held
        assert window.results[1] == Support.FLIGHT


@pytest.mark.parametrize("one", every_strict_text(2))
def test_appendix_a_never_fails(one: str) -> None:
    rules = rules_of("paper", falls_back=True)
    for other, third in product(every_strict_text(2), repeat=2):
        table, window = running([one, other, third], columns=8)
        if combine_column(table, window, rules, 0):
            for column in range(1, 8):
                assert synchronize_column(table, window, rules, column), (one, other, third)


def test_a_refused_start_changes_nothing() -> None:
    table, window = running(["R D L D*", "L D*"], columns=7)
    window.playing[1] = False
    rules = rules_of("paper")
    for column in range(6):
        if column:
            synchronize_column(table, window, rules, column)
        else:
            combine_column(table, window, rules, 0)
    before = window.copy()
    assert not try_start(table, window, rules, 1, 0)
    for name in ("playing", "phases", "results"):
        assert np.array_equal(getattr(window, name), getattr(before, name)), name


def test_a_conflict_below_a_flight_counts_only_for_the_default_planner() -> None:
    for planner, result in (("paper", Support.FLIGHT), ("footfall", Support.CONFLICT)):
        table, window = running(["R D*", "L D*", "- D*"], columns=3)
        combine_column(table, window, rules_of(planner), 0)  # pyright: ignore[reportArgumentType]
        assert window.results[0] == result


@settings(deadline=None, max_examples=300)
@given(
    texts=st.lists(strict_texts(longest=5), min_size=1, max_size=4),
    starts=st.lists(st.integers(0, 6), min_size=4, max_size=4),
    priorities=st.permutations([1.0, 1.0, 2.0, 3.0]),
    lookahead=st.integers(1, 6),
    native=st.booleans(),
)
def test_paper_mode_is_the_slow_synchronizer(
    texts: list[str],
    starts: list[int],
    priorities: list[float],
    lookahead: int,
    native: bool,
) -> None:
    count = len(texts)
    slow = SlowSynchronizer(texts, priorities[:count], lookahead, native)
    results, rows, started = play(slow, starts[:count], 20)
    problem = {
        "sequences": texts,
        "priorities": priorities[:count],
        "start": starts[:count],
        "lookahead": lookahead,
        "slots": 20,
        "planner": "paper",
        "start_policy": "native" if native else "extend",
    }
    answer = solve_problem(json.dumps(problem))
    assert answer["result"] == results
    assert answer["started"] == started
    assert answer["rows"] == [
        [None if phase is None else own_index(text, phase) for phase in row]
        for text, row in zip(texts, rows, strict=True)
    ]


def own_index(text: str, phase: int) -> int:
    count = len(text.rstrip("*").split())
    return phase % count if text.endswith("*") else min(phase, count - 1)


def test_supports_past_the_end() -> None:
    table = SequenceTable.of([SupportSequence.parse("R D L D*"), SupportSequence.parse("D - L")])
    cycle = [support_of(table, 0, phase, 1) for phase in range(-1, 9)]
    assert cycle == [7, 5, 7, 3, 7, 5, 7, 3, 7, 5]
    assert [support_of(table, 1, phase, 1) for phase in range(-1, 6)] == [7, 7, 0, 3, 3, 3, 3]
    assert [support_of(table, 1, phase, 0) for phase in range(-1, 6)] == [7, 7, 0, 3, 7, 7, 7]
