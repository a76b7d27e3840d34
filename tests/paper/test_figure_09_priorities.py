"""Figure 9, by its caption: "The resulting support phase respects the action with the highest
priority." Its picture is lost, so every pair of short strict sequences stands for it.
"""

from __future__ import annotations

import json

import pytest
from tests.paper.requirements import requirement
from tests.sync.strict_sequences import every_strict_text

from footfall.scenario.schedule_problem import solve_problem
from footfall.support import Support, SupportSequence

CYCLIC = [text for text in every_strict_text(3) if text.endswith("*")]


@requirement(
    69, "From the highest priority to the lowest one, it takes the first element of type RS or LS."
)
@requirement(70, "The resulting support phase respects the action with the highest priority.")
@requirement(
    71,
    "ensures that the constraint associated with the motion with the highest priority is respected",
)
@pytest.mark.parametrize("leader", CYCLIC)
def test_the_result_respects_the_action_with_the_highest_priority(leader: str) -> None:
    # The leader is never held, and the blend is its support or flight.
    own = SupportSequence.parse(leader)
    for other in CYCLIC:
        problem = {"sequences": [leader, other], "slots": 9, "lookahead": 2, "planner": "paper"}
        answer = solve_problem(json.dumps(problem))
        assert answer["error"] is None
        assert answer["rows"][0] == [k % len(own.phases) for k in range(9)]
        for k, symbol in enumerate(answer["result"]):
            support = own.at(k).support
            assert Support.from_symbol(symbol) & support is Support.from_symbol(symbol)
            if support in (Support.LEFT, Support.RIGHT):
                assert symbol in (support.symbol, "-")


@pytest.mark.parametrize("place", [0, 1, 2])
@pytest.mark.parametrize(("priorities", "result"), [([2, 1], "R"), ([1, 2], "L")])
def test_a_double_support_of_the_highest_priority_leaves_the_choice_to_the_next(
    priorities: list[int], result: str, place: int
) -> None:
    texts, ranks = ["D R*", "D L*"], list(priorities)
    texts.insert(place, "D")
    ranks.insert(place, 3)
    problem = {"sequences": texts, "priorities": ranks, "slots": 2, "planner": "paper"}
    assert solve_problem(json.dumps(problem))["result"] == ["D", result]
