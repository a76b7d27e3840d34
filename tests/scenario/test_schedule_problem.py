"""One JSON problem a line in, one JSON answer a line out."""

from __future__ import annotations

import json
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.sync.strict_sequences import strict_texts

from footfall.errors import ScenarioError
from footfall.scenario.schedule_fields import ScheduleProblem
from footfall.scenario.schedule_problem import (
    describe_problem,
    solve,
    solve_batch,
    solve_problem,
)

WALK, SHOT = "R D L D*", "L D - D L"


def answer(**fields: Any) -> dict[str, Any]:
    return solve_problem(json.dumps(fields))


def test_the_answer_to_the_example_of_the_contract() -> None:
    assert answer(
        sequences=[WALK, SHOT],
        priorities=[2, 1],
        start=[0, 0],
        lookahead=5,
        slots=24,
        planner="paper",
    ) == {
        "result": ["R", "L", "L", "-", "R", "L", "L", "L", "Err"],
        "rows": [[0, 1, 2, 3, 0, 1, 2, 3, 0], [None, 0, 1, 2, 3, 4, 4, 4, 4]],
        "started": [0, 1],
        "durations": None,
        "muted": None,
        "error": "the rule fails in slot 8: sequence 0 stands on R and sequence 1 on L, "
        "and one of them has ended and cannot give way",
    }


def test_the_ended_action_may_be_stopped_instead() -> None:
    result = answer(sequences=[WALK, SHOT], slots=12, planner="paper", ended="stop")
    assert result["error"] is None
    assert result["rows"][1] == [None, 0, 1, 2, 3, 4, 4, 4, None, None, None, None]
    assert result["result"][8:] == ["R", "D", "L", "D"]


def test_before_anything_starts_the_neutral_motion_stands() -> None:
    result = answer(sequences=["R.4 D.1*"], start=[2], slots=4, planner="paper")
    assert result["result"] == ["D", "D", "R", "D"]
    assert result["rows"] == [[None, None, 0, 1]]
    assert result["durations"] == [None, None, 0.4, 0.1]


def test_a_command_after_the_last_slot_is_never_given() -> None:
    assert answer(sequences=[WALK], start=[9], slots=3)["started"] == [None]


def test_paper_mode_lets_a_held_phase_vote_with_its_whole_duration() -> None:
    # S-20, E1: the hop's flight, .24 s, votes in slots 1 and 2.
    result = answer(
        sequences=["R.4 D.14 L.4 D.14*", "R.28 -.24*"], priorities=[3, 1], slots=4, planner="paper"
    )
    assert result["rows"] == [[0, 1, 2, 3], [0, 1, 1, 0]]
    expected = [0.75 * 0.4 + 0.25 * 0.28, 0.75 * 0.14 + 0.06, 0.75 * 0.4 + 0.06, 0.105 + 0.07]
    assert result["durations"] == pytest.approx(expected)


def test_the_default_planner_splits_a_held_phase_over_its_slots() -> None:
    # S-20, E3, and S-21: the double support of the second goes on at its own speed meanwhile.
    result = answer(sequences=["D.2 R.4 D.2", "D.6 L.4 D.2"], priorities=[1, 1], slots=3)
    assert result["rows"] == [[0, 1, 2], [0, 0, 0]]
    assert result["durations"][:2] == pytest.approx([0.2, 0.4])


def test_seconds_are_given_only_where_every_phase_has_them() -> None:
    assert answer(sequences=["R.4 D*"], slots=2)["durations"] is None
    assert answer(sequences=["R.4 D.1*", "R D*"], slots=2)["durations"] is None


@pytest.mark.parametrize(
    ("line", "error"),
    [
        ("{", "not JSON at column 2: Expecting property name enclosed in double quotes"),
        ("[]", 'a problem is a JSON object, such as {"sequences": ["R D L D*"]}'),
        ("{}", "sequences is None; it must be a list with at least one entry"),
        ('{"sequences": []}', "sequences is []; it must be a list with at least one entry"),
        (
            '{"sequences": [3]}',
            'sequences[0] is 3; it must be a text such as "R D L D*"',
        ),
        (
            '{"sequences": ["R D*"], "slot": 3}',
            "no field named 'slot'; there are: sequences, priorities, start, lookahead, slots, "
            "planner, start_policy, ended",
        ),
        (
            '{"sequences": ["D", "R X"]}',
            "sequences[1], 'R X': 'X' in 'R X' is no support phase; write R, L, D or -, "
            "with its seconds if wanted, such as R.38, and * at the very end for a cycle",
        ),
        (
            '{"sequences": ["R R D"]}',
            "sequences[0], 'R R D': phases 0 and 1 are both RIGHT; merge them into one",
        ),
        (
            '{"sequences": ["R D R*"]}',
            "sequences[0], 'R D R*': phases 2 and 0, neighbors in the cycle, are both RIGHT; "
            "merge them into one",
        ),
        (
            '{"sequences": ["L*"]}',
            "sequences[0], 'L*': phases 0 and 0, neighbors in the cycle, are both LEFT: a cycle "
            "of a single L never changes feet; leave out the * or add a phase, such as L D*",
        ),
        (
            '{"sequences": ["R"], "priorities": [NaN]}',
            "priorities[0] is nan; it must be a number, at least 0",
        ),
        (
            '{"sequences": ["R"], "priorities": [true]}',
            "priorities[0] is True; it must be a number, at least 0",
        ),
        (
            '{"sequences": ["R"], "priorities": [1, 2]}',
            "2 values in priorities for 1 sequences; give one for each",
        ),
        (
            '{"sequences": ["R"], "start": [-1]}',
            "start[0] is -1; it must be a whole number of slots, at least 0",
        ),
        (
            '{"sequences": ["R"], "start": [1.5]}',
            "start[0] is 1.5; it must be a whole number of slots, at least 0",
        ),
        (
            '{"sequences": ["R"], "lookahead": 0}',
            "lookahead is 0; it must be a whole number from 1 to 1000",
        ),
        (
            '{"sequences": ["R"], "slots": 0}',
            "slots is 0; it must be a whole number from 1 to 1000000",
        ),
        (
            '{"sequences": ["R"], "planner": "best"}',
            """planner is 'best'; it must be "footfall" or "paper\"""",
        ),
        (
            '{"sequences": ["R"], "planner": ["paper"]}',
            """planner is ['paper']; it must be "footfall" or "paper\"""",
        ),
        (
            '{"sequences": ["R"], "planner": "paper", "ended": "neutral"}',
            """ended is 'neutral'; it must be "repeat" or "stop\"""",
        ),
        (
            '{"sequences": ["R"], "start_policy": "native"}',
            'the start policy "native", the end "repeat" and the fallback belong to the planner '
            '"paper"; the planner is "footfall"',
        ),
    ],
)
def test_a_bad_problem_gets_only_an_error(line: str, error: str) -> None:
    assert solve_problem(line) == {"error": error}


def test_a_bad_problem_leaves_the_others_alone() -> None:
    good = json.dumps({"sequences": [WALK], "slots": 2})
    answers = [json.loads(line) for line in solve_batch([good, "nonsense", "\n", good])]
    assert [sorted(one) == ["error"] for one in answers] == [False, True, False]
    assert answers[0] == answers[2]
    assert answers[0]["result"] == ["R", "D"]


def test_a_cycle_of_double_support_is_welcome() -> None:
    result = answer(sequences=["D*", WALK], slots=9)
    assert {"R", "L", "D"} == set(result["result"])
    assert result["muted"] is None


def test_missing_fields_have_defaults() -> None:
    problem = ScheduleProblem.of({"sequences": [WALK, SHOT]})
    assert problem == ScheduleProblem((WALK, SHOT), (2.0, 1.0), (0, 0), 5, 12, "footfall")


def test_a_problem_built_in_python_is_checked_too() -> None:
    with pytest.raises(ScenarioError, match="1 values in start for 2 sequences"):
        ScheduleProblem((WALK, SHOT), (2.0, 1.0), (0,))


def test_the_text_form() -> None:
    problem = ScheduleProblem.of({"sequences": [WALK, SHOT], "planner": "paper"})
    assert describe_problem(problem) == (
        "slot            0    1    2    3    4    5    6    7    8\n"
        "R D L D*   2    R    D    L    D    R    D    L    D    R\n"
        "L D - D L  1    .    L    D    -    D    L    L    L    L\n"
        "blend           R    L    L    -    R    L    L    L    Err\n"
        "slot 0: 'L D - D L' waits: L of 'L D - D L' conflicts with R of 'R D L D*'\n"
        "the rule fails in slot 8: sequence 0 stands on R and sequence 1 on L, "
        "and one of them has ended and cannot give way"
    )


@settings(deadline=None, max_examples=80)
@given(
    texts=st.lists(strict_texts(longest=5), min_size=1, max_size=4),
    starts=st.lists(st.integers(0, 6), min_size=4, max_size=4),
    lookahead=st.integers(1, 6),
    planner=st.sampled_from(["paper", "footfall"]),
)
def test_the_text_and_the_batch_agree(
    texts: list[str], starts: list[int], lookahead: int, planner: str
) -> None:
    problem = ScheduleProblem.of(
        {
            "sequences": texts,
            "start": starts[: len(texts)],
            "lookahead": lookahead,
            "slots": 15,
            "planner": planner,
        }
    )
    result = solve(problem)
    lines = describe_problem(problem).splitlines()
    assert lines[len(texts) + 1].split()[1:] == result["result"]
    for line, text, row in zip(lines[1:], texts, result["rows"], strict=False):
        letters = [*text.removesuffix("*").split(), "."]
        cells = line.split("~ held")[0].removeprefix(text).split()[1:]
        indices: list[int | None] = row
        expected = [letters[-1 if index is None else index] for index in indices]
        assert [cell.removesuffix("~") for cell in cells] == expected
