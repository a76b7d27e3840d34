"""Figure 6: what follows the end of a sequence, cyclic or not (section 4.3)."""

from __future__ import annotations

import json

from tests.paper.requirements import requirement

from footfall.scenario.schedule_problem import solve_problem
from footfall.support import SupportSequence
from footfall.sync import Synchronizer


def letters(sequence: SupportSequence, count: int) -> str:
    return " ".join(sequence.at(k).support.symbol for k in range(count))


@requirement(57, "their sequences are repeated as a whole")
def test_the_cyclic_row() -> None:

    assert letters(SupportSequence.parse("R D L D*"), 8) == "R D L D R D L D"


@requirement(58, "So only the last element of their sequence is repeated as long as necessary.")
def test_the_clamped_row() -> None:
    # only the last element is repeated.
    assert letters(SupportSequence.parse("L D - D L"), 8) == "L D - D L L L L"


@requirement(59, "is repeated as a whole; only the last element of")
def test_both_rows_as_the_synchronizer_plays_them_alone() -> None:
    for text, row in (("R D L D*", "R D L D R D L D"), ("L D - D L", "L D - D L L L L")):
        synchronizer = Synchronizer([SupportSequence.parse(text)], planner="paper")
        synchronizer.start(0)
        for _ in range(7):
            synchronizer.next_slot()
        assert " ".join(synchronizer.trace.rows[0].cells) == row


@requirement(
    60, "To use our algebraic relation after the third element, we need to extend the sequence"
)
def test_both_rows_as_the_batch_answers_them_alone() -> None:
    for text, result, row in (
        ("R D L D*", "R D L D R D L D", [0, 1, 2, 3, 0, 1, 2, 3]),
        ("L D - D L", "L D - D L L L L", [0, 1, 2, 3, 4, 4, 4, 4]),
    ):
        problem = {"sequences": [text], "slots": 8, "planner": "paper"}
        answer = solve_problem(json.dumps(problem))
        assert answer["result"] == result.split()
        assert answer["rows"] == [row]


def test_the_figure_itself_walk_first_is_an_error_that_the_paper_does_not_see() -> None:
    # S-3: the ended action stands on L for ever, and the walk comes to R.
    problem = {"sequences": ["D L D R*", "L D - D L"], "slots": 12, "planner": "paper"}
    answer = solve_problem(json.dumps(problem))
    assert " ".join(answer["result"]) == "L L - R L L L Err"


def test_the_default_planner_stands_on_both_feet_after_the_end() -> None:
    problem = {"sequences": ["L D - D L"], "slots": 7, "planner": "footfall"}
    answer = solve_problem(json.dumps(problem))
    assert " ".join(answer["result"]) == "L D - D L D D"
    assert answer["rows"] == [[0, 1, 2, 3, 4, None, None]]
