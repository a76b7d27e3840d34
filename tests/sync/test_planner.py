"""The default planner: never in conflict, never only flying, entering where it costs least."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.oracles.slow_synchronizer import SlowSynchronizer, play
from tests.sync.strict_sequences import strict_texts

from footfall.scenario.schedule_problem import solve_problem
from footfall.support import Support, SupportPhase, SupportSequence
from footfall.sync import Synchronizer
from footfall.sync.columns import combine_column
from footfall.sync.paper import synchronize_column
from footfall.sync.planner import REFUSED, start_action, window_cost
from footfall.sync.tables import Planner, SequenceTable, rules_of
from footfall.sync.window import Window

CASES = Path(__file__).parents[3] / "shared" / "cases" / "realistic.json"

walks = strict_texts(longest=6)


@settings(deadline=None, max_examples=100)
@given(
    texts=st.lists(walks, min_size=1, max_size=6),
    commands=st.lists(
        st.tuples(st.integers(0, 5), st.sampled_from(["start", "stop", "up"])), max_size=40
    ),
    lookahead=st.integers(1, 6),
)
def test_no_command_at_any_moment_leads_to_a_conflict(
    texts: list[str], commands: list[tuple[int, str]], lookahead: int
) -> None:
    synchronizer = Synchronizer(
        [SupportSequence.parse(text) for text in texts], lookahead=lookahead
    )
    for number, (action, command) in enumerate(commands):
        if action < len(texts):
            if command == "start":
                synchronizer.start(action)
            elif command == "stop":
                synchronizer.stop(action)
            else:
                synchronizer.set_priority(action, float(number))
        assert Support.CONFLICT not in synchronizer.schedule.results
        grounded = [row.supports for row in synchronizer.schedule.rows]
        for column in zip(*grounded, strict=True):
            feet = {s for s in column if s in (Support.LEFT, Support.RIGHT)}
            assert len(feet) < 2, "a conflict is hidden below a flight"
        if number % 2:
            assert synchronizer.next_slot() is not Support.CONFLICT


@settings(deadline=None, max_examples=80)
@given(
    texts=st.lists(strict_texts(longest=6, cyclic=False), min_size=1, max_size=4),
    starts=st.lists(st.integers(0, 6), min_size=4, max_size=4),
    lookahead=st.integers(1, 6),
)
def test_the_mended_rule_is_that_of_the_slow_synchronizer(
    texts: list[str], starts: list[int], lookahead: int
) -> None:
    # Clamped actions have one entry only, so that nothing is left to choose.
    priorities = [float(len(texts) - i) for i in range(len(texts))]
    slow = SlowSynchronizer(texts, priorities, lookahead, mended=True)
    results, _, started = play(slow, starts[: len(texts)], 16)
    problem = {
        "sequences": texts,
        "start": starts[: len(texts)],
        "lookahead": lookahead,
        "slots": 16,
    }
    answer = solve_problem(json.dumps(problem))
    assert answer["result"] == results
    assert answer["started"] == started


def test_right_hop_and_left_hop_never_play_together() -> None:
    hops = [SupportSequence.parse("R -*"), SupportSequence.parse("L -*")]
    synchronizer = Synchronizer(hops, names=["right hop", "left hop"])
    assert synchronizer.start(0)
    assert not synchronizer.start(1)
    for _ in range(40):
        synchronizer.next_slot()
        assert synchronizer.playing == (0,)
    assert synchronizer.waiting == {
        1: "waits: L of 'left hop' conflicts with R of 'right hop'; "
        "with 'left hop' no foot would touch the ground for 7 slots"
    }


def test_an_ended_action_stands_on_both_feet_and_leaves() -> None:
    synchronizer = Synchronizer([SupportSequence.parse("R -"), SupportSequence.parse("D L*")])
    assert synchronizer.start(0)
    synchronizer.next_slot()
    assert synchronizer.playing == (0,)
    synchronizer.next_slot()
    assert synchronizer.playing == ()
    assert synchronizer.result is Support.DOUBLE
    assert synchronizer.start(1)
    assert [row.cells for row in synchronizer.trace.rows] == [("R", "-", "."), (".", ".", "D")]


def start_beside(
    running: str, entry: int, starting: str, elapsed: float = 0.0
) -> tuple[int, Window]:
    """Put `running` in at a phase, then start the other one; return where that entered."""
    table = SequenceTable.of([SupportSequence.parse(running), SupportSequence.parse(starting)])
    window = Window.empty(2, 5)
    rules = rules_of("footfall")
    window.sequence[:] = window.age[:] = (0, 1)
    window.priority[:] = window.weight[:] = (0.7, 0.3)
    window.playing[0] = True
    window.phases[0, 0] = entry
    window.remaining[0] = table.durations[entry] * (1.0 - elapsed)
    combine_column(table, window, rules, 0)
    for column in range(1, 6):
        synchronize_column(table, window, rules, column)
    return start_action(table, window, rules, 1, elapsed), window


WALK = "R.4 D.14 L.4 D.14*"


@pytest.mark.parametrize("phase", range(4))
@pytest.mark.parametrize("elapsed", [0.0, 0.5])
def test_a_walk_enters_a_walk_in_step(phase: int, elapsed: float) -> None:
    entry, window = start_beside(WALK, phase, "R.42 D.18 L.42 D.18*", elapsed)
    assert entry == phase
    assert window.remaining[1] == pytest.approx((1.0 - elapsed) * (0.42, 0.18)[phase % 2])


@pytest.mark.parametrize(("phase", "expected"), [(0, 0), (1, 1), (2, 2), (3, 3)])
def test_a_run_enters_a_walk_with_its_flights_in_the_double_supports(
    phase: int, expected: int
) -> None:
    assert start_beside(WALK, phase, "R.2 -.14 L.2 -.14*")[0] == expected


def test_a_clamped_action_enters_at_its_first_phase_or_not_at_all() -> None:
    assert start_beside(WALK, 0, "L.2 D.2 R.3")[0] == REFUSED
    assert start_beside(WALK, 1, "L.2 D.2 R.3")[0] == 0


def test_no_entry_costs_less_than_the_one_taken() -> None:
    entry, taken = start_beside(WALK, 2, "D.3 R.45 D.25 R.45 D.3 L.45 D.25 L.45*")
    table = SequenceTable.of(
        [
            SupportSequence.parse(WALK),
            SupportSequence.parse("D.3 R.45 D.25 R.45 D.3 L.45 D.25 L.45*"),
        ]
    )
    rules = rules_of("footfall")
    least = window_cost(table, taken, rules)
    for other in range(8):
        trial = taken.copy()
        trial.phases[1, 0] = other
        trial.remaining[1] = table.durations[4 + other]
        playable = combine_column(table, trial, rules, 0)
        for column in range(1, 7):
            synchronize_column(table, trial, rules, column)
        if playable and other != entry:
            assert window_cost(table, trial, rules) >= least


def test_the_cost_of_a_hold_counts_thrice_in_flight() -> None:
    table = SequenceTable.of([SupportSequence.parse("D R*"), SupportSequence.parse("- R*")])
    rules = rules_of("footfall")
    window = Window.empty(1, 2)
    window.playing[0] = True
    window.weight[0] = window.remaining[0] = 1.0
    window.phases[0] = (0, 0, 1, 2)
    assert window_cost(table, window, rules) == (1.0, 0.0)
    window.sequence[0] = 1
    assert window_cost(table, window, rules) == (3.0, 0.0)


def test_an_empty_window_costs_nothing() -> None:
    table = SequenceTable.of([SupportSequence.parse("D R*")])
    assert window_cost(table, Window.empty(2, 3), rules_of("footfall")) == (0.0, 0.0)


@pytest.mark.parametrize(
    ("planner", "cells"), [("footfall", "D L D R . ."), ("paper", "D D~ L D R R")]
)
def test_a_stop_frees_what_was_held_for_its_sake(planner: Planner, cells: str) -> None:
    # S-14: the default planner decides anew, paper mode keeps its decisions.
    walks = [SupportSequence.parse("D R D L*"), SupportSequence.parse("D L D R")]
    synchronizer = Synchronizer(walks, planner=planner)
    synchronizer.start(0)
    synchronizer.start(1)
    assert synchronizer.schedule.rows[1].cells[:2] == ("D", "D~")
    synchronizer.stop(0)
    assert " ".join(synchronizer.schedule.rows[0].cells) == cells


@pytest.mark.parametrize(
    ("planner", "rows"), [("footfall", ["D D~", "D L"]), ("paper", ["D R", "D D~"])]
)
def test_a_priority_takes_effect_in_the_next_slot(planner: Planner, rows: list[str]) -> None:
    # S-16: the default planner decides anew, paper mode keeps its decisions.
    walks = [SupportSequence.parse("D R D L"), SupportSequence.parse("D L D R")]
    synchronizer = Synchronizer(walks, planner=planner)
    synchronizer.start(0)
    synchronizer.start(1)
    synchronizer.set_priority(1, 3.0)
    assert [" ".join(row.cells[:2]) for row in synchronizer.schedule.rows] == rows


@pytest.mark.skipif(not CASES.is_file(), reason="the realistic cases lie outside the project")
def test_realistic_pairs_nearly_always_start_at_once() -> None:
    cases = json.loads(CASES.read_text())
    sequences = {
        name: SupportSequence(
            tuple(SupportPhase(Support.from_symbol(s), d) for s, d in case["phases"]),
            case["cyclic"],
        )
        for name, case in cases.items()
    }
    delays: Counter[int] = Counter()
    never: set[tuple[str, str]] = set()
    for one in sequences:
        for other in sequences:
            if one != other:
                synchronizer = Synchronizer([sequences[one], sequences[other]], [0.7, 0.3])
                synchronizer.start(0)
                synchronizer.start(1)
                while synchronizer.waiting and synchronizer.slot < 20:
                    synchronizer.next_slot()
                delays[synchronizer.slot] += 1
                if synchronizer.waiting:
                    never.add((one, other))
    # S-6: 293 at once, 11 one phase later, and only right hop with left hop never.
    assert delays == {0: 293, 1: 11, 20: 2}
    assert never == {("rhop", "lhop"), ("lhop", "rhop")}
