"""Figure 8: one element is extended, and the pair can be blended again (nk = 1)."""

from __future__ import annotations

import json

import pytest
from tests.paper.requirements import requirement

from footfall.scenario.schedule_problem import solve_problem

# The figure shows the columns k + 1 and k + 2: S1 = (DS, RS), S2 = (Ø, LS).
FIRST, SECOND = "D R D L*", "- L D*"


@requirement(
    66, "Deleting or reducing one of the two concerned elements does not solve the problem."
)
@requirement(
    67,
    "After synchronization, all the actions can be blended and the relation determines the new "
    "support phase.",
)
@pytest.mark.parametrize(
    ("priorities", "result", "rows"),
    [
        # As printed: extending S1(k+1) = DS solves it; the result is LS.
        ([1, 2], "- L", [[0, 0], [0, 1]]),
        # The other solution, an extended flight, belongs to the other priority.
        ([2, 1], "- -", [[0, 1], [0, 0]]),
    ],
)
def test_the_pair_of_the_figure(priorities: list[int], result: str, rows: list[int]) -> None:
    problem = {
        "sequences": [FIRST, SECOND],
        "priorities": priorities,
        "lookahead": 1,
        "slots": 2,
        "planner": "paper",
    }
    answer = solve_problem(json.dumps(problem))
    assert " ".join(answer["result"]) == result
    assert answer["rows"] == rows
    assert answer["error"] is None
