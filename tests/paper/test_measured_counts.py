"""How often the paper's rule fails, waits for ever or hides a conflict, counted exhaustively.

Every ordered pair of strict sequences of up to four phases, 280 of them, against the counts of
another implementation: if one reading of section 5.1 differs, so does a count.
"""

from __future__ import annotations

import json
from itertools import product

import numpy as np
import pytest
from tests.sync.strict_sequences import every_strict_text

from footfall.arrays import Flags
from footfall.compilation import kernel
from footfall.scenario.schedule_problem import solve_problem
from footfall.support import Support, SupportSequence
from footfall.sync.columns import combine_column
from footfall.sync.paper import synchronize_column
from footfall.sync.tables import Rules, SequenceTable, rules_of
from footfall.sync.window import Window

pytestmark = pytest.mark.full

TEXTS = every_strict_text(4)
CYCLIC = np.array([text.endswith("*") for text in TEXTS])
TABLE = SequenceTable.of([SupportSequence.parse(text) for text in TEXTS])


def test_there_are_as_many_sequences_as_were_counted() -> None:
    assert len(TEXTS) == 280
    assert CYCLIC.sum() == 120


@kernel
def played(table: SequenceTable, window: Window, rules: Rules, first: int, second: int) -> int:
    """Let two run from their first phases: 1 if they can, 0 if not, -1 if not even begin."""
    window.sequence[0] = first
    window.sequence[1] = second
    window.phases[0, 0] = 0
    window.phases[1, 0] = 0
    if not combine_column(table, window, rules, 0):
        return -1
    for column in range(1, window.results.shape[0]):
        if not synchronize_column(table, window, rules, column):
            return 0
    return 1


def counts(rules: Rules) -> tuple[int, int, int, int, int]:
    """Return running pairs, failures, starved, running cyclic pairs, those that only fly."""
    window = Window.empty(2, 58)
    window.playing[:] = True
    window.priority[:] = (2.0, 1.0)
    running = failed = starved = cyclic = flying = 0
    for first, second in product(range(len(TEXTS)), repeat=2):
        outcome = played(TABLE, window, rules, first, second)
        if outcome < 0:
            continue
        both = bool(CYCLIC[first] and CYCLIC[second])
        stuck = window.phases[:, 30] == window.phases[:, -1]
        running += 1
        cyclic += both
        failed += outcome == 0
        starved += outcome == 1 and bool(stuck.any())
        flying += both and bool((window.results[30:] == Support.FLIGHT).all())
    return running, failed, starved, cyclic, flying


def test_an_ended_action_makes_the_rule_fail_or_another_starve() -> None:
    # S-3: 7 088 of 68 600 running pairs fail, 9 240 starve; S-6: 404 of 12 600 only fly.
    assert counts(rules_of("paper")) == (68_600, 7_088, 9_240, 12_600, 404)


def test_the_default_planner_neither_fails_nor_starves() -> None:
    running, failed, starved, cyclic, _ = counts(rules_of("footfall"))
    assert (running, failed, starved, cyclic) == (68_600, 0, 0, 12_600)


@pytest.mark.parametrize("options", [{"ended": "stop"}, {"falls_back": True}])
def test_neither_stopping_the_ended_nor_appendix_a_ever_fails(options: dict[str, object]) -> None:
    rules = rules_of("paper", **options)  # pyright: ignore[reportArgumentType]
    running, failed, *_ = counts(rules)
    assert (running, failed) == (68_600, 0)


def never_started(policy: str, lookahead: int, priorities: list[int]) -> Flags:
    """Return which seconds never start beside which firsts."""
    never = np.zeros((len(TEXTS), len(TEXTS)), dtype=np.bool_)
    for first, second in product(range(len(TEXTS)), repeat=2):
        problem = {
            "sequences": [TEXTS[first], TEXTS[second]],
            "priorities": priorities,
            "lookahead": lookahead,
            "slots": 24,
            "planner": "paper",
            "start_policy": policy,
        }
        never[first, second] = solve_problem(json.dumps(problem))["started"][1] is None
    return never


@pytest.mark.parametrize(
    ("policy", "lookahead", "priorities", "never", "never_cyclic"),
    [
        ("native", 1, [2, 1], 3_674, 48),
        ("native", 2, [2, 1], 10_008, 488),
        ("native", 3, [2, 1], 14_388, 1_248),
        ("native", 5, [2, 1], 20_916, 2_000),
        ("extend", 1, [1, 2], 1_004, 0),
        ("extend", 2, [1, 2], 2_680, 0),
        ("extend", 3, [1, 2], 4_632, 0),
        ("extend", 5, [1, 2], 7_700, 0),
    ],
)
def test_starts_that_never_happen(
    policy: str, lookahead: int, priorities: list[int], never: int, never_cyclic: int
) -> None:
    # S-11; and requirement 75: without holds a larger look-ahead starts less often.
    found = never_started(policy, lookahead, priorities)
    assert found.sum() == never
    assert found[np.ix_(CYCLIC, CYCLIC)].sum() == never_cyclic
