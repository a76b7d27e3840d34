"""Schedules settled once and for all: real motions, figures 6, 13, 14 and 15 in letters.

`~` marks a phase that is held; the first action has the higher priority.
"""

from __future__ import annotations

import json

import pytest

from footfall.scenario.schedule_problem import solve_problem
from footfall.support import SupportSequence
from footfall.sync import Synchronizer

GOLDEN = {
    "walk and right hop": (
        ("R D L D*", "R -*"),
        "R -  -  R - R -",
        ("R D L D R D L", "R - -~ R - R -"),
    ),
    "run and handball shot, figure 13": (
        ("- L - R*", "L D R - L D R D"),
        "- L - - - L - R - L - R",
        ("- L - R - L - R - L - R", "L D R - L D R D D D D D"),
    ),
    "walk and walk-to-hop, figure 14": (
        ("R D L D*", "R D L D R - R - R D"),
        "R D L D R - - R - R L D",
        ("R D L D R D L D R D L D", "R D L D R - -~ R - R D D"),
    ),
    "side step and walk, figure 15": (
        ("D R D L*", "R D L D*"),
        "R R L L",
        ("D R D L", "R D L D"),
    ),
    "walk and run": (("R D L D*", "R - L -*"), "R - L -", ("R D L D", "R - L -")),
    "walk and backward walk": (
        ("D L D R*", "L D R D*"),
        "L L R R",
        ("D L D R", "L D R D"),
    ),
    "right hop and left hop": (("- R*", "L -*"), "- - -", ("- R -", "L - L")),
    "the pair of figure 6": (
        ("D L D R*", "L D - D L"),
        "L L - R L L L Err",
        ("D L D R D L D R", "L D - D L L L L"),
    ),
}


@pytest.mark.parametrize("name", GOLDEN)
def test_the_synchronizer_plays_it(name: str) -> None:
    texts, result, rows = GOLDEN[name]
    synchronizer = Synchronizer([SupportSequence.parse(text) for text in texts], planner="paper")
    for action in range(len(texts)):
        assert synchronizer.start(action)
    for _ in result.split()[1:]:
        synchronizer.next_slot()
    trace = synchronizer.trace
    assert [support.symbol for support in trace.results] == result.split()
    for row, expected in zip(trace.rows, rows, strict=True):
        assert list(row.cells) == expected.split()


@pytest.mark.parametrize(
    ("name", "lookahead"),
    [
        (name, lookahead)
        for name in GOLDEN
        for lookahead in (1, 2, 3, 5, 8)
        if lookahead <= 5 or name != "the pair of figure 6"
    ],
)
def test_the_batch_answers_it_whatever_the_look_ahead(name: str, lookahead: int) -> None:
    # S-10: with holds allowed at the start the look-ahead changes nothing, except that a window
    # that already shows the failure refuses the start.
    texts, result, rows = GOLDEN[name]
    expected = result.split()
    slots = len(expected)
    problem = {
        "sequences": texts,
        "priorities": [2, 1],
        "start": [0, 0],
        "lookahead": lookahead,
        "slots": slots,
        "planner": "paper",
    }
    answer = solve_problem(json.dumps(problem))
    assert answer["result"] == expected
    assert answer["started"] == [0, 0]
    for text, indices, cells in zip(texts, answer["rows"], rows, strict=True):
        letters = text.removesuffix("*").split()
        assert [letters[index] for index in indices] == cells.replace("~", "").split()
    failed = expected[-1] == "Err"
    assert (answer["error"] is not None) is failed
    if failed:
        assert answer["error"] == (
            "the rule fails in slot 7: sequence 0 stands on R and sequence 1 on L, "
            "and one of them has ended and cannot give way"
        )
