"""Section 5.1: the start of an action, and what the number of synchronized elements does."""

from __future__ import annotations

import inspect
from itertools import product

import pytest
from tests.paper.requirements import requirement
from tests.sync.strict_sequences import every_strict_text

import footfall as ff
from footfall.scenario.schedule_fields import ScheduleProblem
from footfall.scenario.schedule_problem import solve
from footfall.support import SupportSequence
from footfall.sync import Synchronizer

CYCLIC = [text for text in every_strict_text(3) if text.endswith("*")]


@requirement(72, "the action is started at the first synchronized element")
@pytest.mark.parametrize("lookahead", [1, 2, 5])
def test_a_start_examines_one_column_more_than_the_window_keeps(lookahead: int) -> None:
    # Without holds, a conflict in column k + nk + 1 forbids the start, one column later does not.
    walk = SupportSequence.parse("D R D L*")
    for column, starts in ((lookahead + 1, False), (lookahead + 2, True)):
        foot = "L" if walk.at(column).support.symbol == "R" else "R"
        if walk.at(column).support.symbol == "D":
            continue
        letters = ["D" if k % 2 else "-" for k in range(column)] + [foot]
        late = SupportSequence.parse(" ".join(letters))
        synchronizer = Synchronizer(
            [walk, late], planner="paper", lookahead=lookahead, start_policy="native"
        )
        synchronizer.start(0)
        assert synchronizer.start(1) is starts
        if starts:
            assert synchronizer.schedule.rows[1].phases[0] == 0
            assert len(synchronizer.schedule.results) == lookahead + 1


@requirement(
    74,
    "The default value used for all our animations inside MKM is 5. It allows to synchronize more"
    " than a complete cycle of locomotion.",
)
def test_five_elements_by_default_more_than_a_cycle_of_locomotion() -> None:
    for thing in (ff.Character, ff.Crowd, Synchronizer, ScheduleProblem):
        assert inspect.signature(thing).parameters["lookahead"].default == 5
    walk = SupportSequence.parse("R D L D*")
    synchronizer = Synchronizer([walk])
    synchronizer.start(0)
    assert len(synchronizer.schedule.results) == 6 > len(walk.phases)


def at_once(lookahead: int, policy: str) -> int:
    """Return how many of all ordered pairs of short cycles start the second at once."""
    started = 0
    for texts in product(CYCLIC, repeat=2):
        fields = {
            "sequences": list(texts),
            "lookahead": lookahead,
            "slots": 1,
            "planner": "paper",
            "start_policy": policy,
        }
        started += solve(ScheduleProblem.of(fields))["started"][1] == 0
    return started


@requirement(
    75,
    "it is more difficult to start a new action since the algorithm must synchronize more support"
    " phases at the beginning of the motion",
)
def test_without_holds_a_larger_look_ahead_starts_less_often() -> None:
    native = [at_once(lookahead, "native") for lookahead in (1, 2, 3, 5)]
    assert native == sorted(native, reverse=True)
    assert native[0] > native[1] > native[2] > native[3]
    assert native[3] < 0.8 * native[0]


def test_with_holds_it_makes_no_difference() -> None:
    # S-10: where phases may be held to make room, the trade-off is gone.
    extend = {at_once(lookahead, "extend") for lookahead in (1, 2, 3, 5)}
    assert len(extend) == 1
    assert extend.pop() > at_once(1, "native")
