"""Paper mode on every ordered pair of short sequences is the rule as printed, whatever nk.

The batch command against the slow synchronizer, which has figure 4 as a table of letters and the
rule of section 5.1 as sentences.
"""

from __future__ import annotations

import json
import random
import resource
import subprocess
import sys
from itertools import product
from pathlib import Path
from typing import Any

import pytest
from tests.oracles.slow_synchronizer import SlowSynchronizer, play
from tests.sync.strict_sequences import every_strict_text

from footfall.scenario.schedule_problem import solve_problem

TEXTS = every_strict_text(4)
LOOKAHEADS = (1, 2, 3, 5)
SLOTS = 24

Case = tuple[str, str, int]


def line_of(case: Case) -> str:
    problem = {
        "sequences": case[:2],
        "lookahead": case[2],
        "slots": SLOTS,
        "planner": "paper",
    }
    return json.dumps(problem)


def expected(case: Case) -> tuple[list[str], list[list[int | None]], list[int | None]]:
    """Return the results, the phases as indices into each list, and the slots of the starts."""
    texts = list(case[:2])
    slow = SlowSynchronizer(texts, [2.0, 1.0], case[2])
    results, rows, started = play(slow, [0, 0], SLOTS)
    own: list[list[int | None]] = []
    for text, row in zip(texts, rows, strict=True):
        count = len(text.rstrip("*").split())
        cyclic = text.endswith("*")
        own.append([None if k is None else k % count if cyclic else min(k, count - 1) for k in row])
    return results, own, started


def check(case: Case, answer: dict[str, Any]) -> None:
    """Compare an answer of the batch with the oracle's."""
    assert (answer["result"], answer["rows"], answer["started"]) == expected(case), case
    assert (answer["error"] is not None) is (answer["result"][-1] == "Err"), case


def test_pairs_drawn_by_lot_are_played_as_printed() -> None:
    chosen = random.Random(5)
    for _ in range(1500):
        case = (chosen.choice(TEXTS), chosen.choice(TEXTS), chosen.choice(LOOKAHEADS))
        check(case, solve_problem(line_of(case)))


def test_there_are_280_sequences_and_so_78400_ordered_pairs() -> None:
    assert len(TEXTS) ** 2 == 78_400
    assert len(set(TEXTS)) == 280


@pytest.mark.full
def test_every_pair_with_every_look_ahead_is_played_as_printed_within_a_minute(
    tmp_path: Path,
) -> None:
    cases = [(one, other, nk) for nk in LOOKAHEADS for one, other in product(TEXTS, repeat=2)]
    batch = tmp_path / "pairs.jsonl"
    batch.write_text("".join(line_of(case) + "\n" for case in cases), encoding="utf-8")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with (tmp_path / "answers.jsonl").open("w+", encoding="utf-8") as answers:
        command = [sys.executable, "-m", "footfall", "sync", "--batch", str(batch)]
        subprocess.run(command, check=True, stdout=answers)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        # Seconds of the processor: what else runs here does not count.
        assert after.ru_utime - before.ru_utime < 60.0
        answers.seek(0)
        compared = 0
        for case, line in zip(cases, answers, strict=True):
            check(case, json.loads(line))
            compared += 1
    assert compared == 313_600
