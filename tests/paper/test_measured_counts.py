"""How often the paper's rule fails, waits for ever or hides a conflict, counted exhaustively.

Every ordered pair of strict sequences of up to four phases, 280 of them, against the counts of
another implementation: if one reading of section 5.1 differs, so does a count.
"""

from __future__ import annotations

import json
from collections import Counter
from itertools import permutations, product
from pathlib import Path

import numpy as np
import pytest
from tests.sync.strict_sequences import every_strict_text

from footfall.arrays import Flags
from footfall.compilation import kernel
from footfall.scenario.schedule_problem import solve_problem
from footfall.support import Support, SupportSequence
from footfall.sync.columns import combine_column, has_ended
from footfall.sync.events import enter_next_slot, reconsider, release_action, start_action
from footfall.sync.paper import synchronize_column
from footfall.sync.planner import REFUSED
from footfall.sync.shares import spend_slot
from footfall.sync.tables import ABSENT, MOST_HELD, Rules, SequenceTable, rules_of
from footfall.sync.window import Window

pytestmark = pytest.mark.full

TEXTS = every_strict_text(4)
CYCLIC = np.array([text.endswith("*") for text in TEXTS])
CONFLICT = int(Support.CONFLICT)
SLOTS = 24
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


@kernel
def planned(table: SequenceTable, window: Window, rules: Rules, first: int, second: int) -> int:
    """Start two, one slot after the other, and let them run: as `footfall sync` does.

    Returns 1 if the second has started, 0 if it waits all along, -1 if a slot failed, and -2 if
    one that had not ended stood still or was held for too long.
    """
    window.sequence[0] = first
    window.sequence[1] = second
    window.playing[:] = False
    window.muted[:] = False
    window.phases[:] = ABSENT
    start_action(table, window, rules, 0, 0.0)
    begun = False
    for _ in range(SLOTS):
        if not begun and not window.playing[1]:
            begun = start_action(table, window, rules, 1, 0.0) != REFUSED
        if window.results[0] == CONFLICT:
            return -1
        goes_on = False
        anybody = False
        for seat in range(2):
            if window.playing[seat]:
                anybody = True
                goes_on = goes_on or window.phases[seat, 1] != window.phases[seat, 0]
                if not window.muted[seat] and window.held[seat] > MOST_HELD:
                    return -2
        if anybody and not goes_on:
            return -2
        spend_slot(table, window)
        enter_next_slot(table, window, rules)
        for seat in range(2):
            if window.playing[seat] and has_ended(
                table, window.sequence[seat], window.phases[seat, 0]
            ):
                release_action(table, window, rules, seat)
    return 1 if begun else 0


def test_the_default_planner_neither_fails_nor_starves_and_all_but_few_start() -> None:
    window = Window.empty(2, 5)
    window.priority[:] = window.weight[:] = (0.7, 0.3)
    window.age[:] = (0, 1)
    rules = rules_of("footfall")
    outcomes = Counter(
        planned(TABLE, window, rules, first, second)
        for first, second in product(range(len(TEXTS)), repeat=2)
    )
    assert set(outcomes) == {0, 1}
    assert outcomes[1] >= 0.95 * outcomes.total()


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
    # S-11: without holds a larger look-ahead starts less often.
    found = never_started(policy, lookahead, priorities)
    assert found.sum() == never
    assert found[np.ix_(CYCLIC, CYCLIC)].sum() == never_cyclic


REALISTIC = Path(__file__).parents[3] / "shared" / "cases" / "realistic.json"


@pytest.mark.skipif(not REALISTIC.is_file(), reason="the realistic cases lie outside the project")
@pytest.mark.parametrize("weights", [(0.7, 0.3), (0.5, 0.5)])
def test_on_realistic_pairs_at_least_965_of_1000_starts_are_immediate(
    weights: tuple[float, float],
) -> None:
    cases = json.loads(REALISTIC.read_text())
    texts = {
        name: " ".join(f"{s}{d}" for s, d in case["phases"]) + "*" * case["cyclic"]
        for name, case in cases.items()
    }
    asked = at_once = 0
    never: set[tuple[str, str]] = set()
    for one, other in permutations(texts, 2):
        table = SequenceTable.of([SupportSequence.parse(texts[name]) for name in (one, other)])
        for phase in range(len(cases[one]["phases"])):
            asked += 1
            waited = slots_until_start(table, phase, weights)
            at_once += waited == 0
            if waited is None:
                never.add((one, other))
    assert asked == 1_360
    assert at_once >= 0.965 * asked
    assert never == {("rhop", "lhop"), ("lhop", "rhop")}


def slots_until_start(table: SequenceTable, phase: int, weights: tuple[float, float]) -> int | None:
    """Return how many slots the second waits, asked for at a phase of the first; None: for ever."""
    rules = rules_of("footfall")
    window = Window.empty(2, 5)
    window.sequence[:] = window.age[:] = (0, 1)
    window.priority[:] = window.weight[:] = weights
    window.playing[0] = True
    window.phases[0, 0] = phase
    window.remaining[0] = table.durations[phase]
    reconsider(table, window, rules)
    for slot in range(SLOTS):
        if start_action(table, window, rules, 1, 0.0) != REFUSED:
            return slot
        spend_slot(table, window)
        enter_next_slot(table, window, rules)
        if window.playing[0] and has_ended(table, 0, window.phases[0, 0]):
            release_action(table, window, rules, 0)
    return None
