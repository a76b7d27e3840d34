"""Traces as pictures: phases, seconds, stretches, who is muted, and what waits and why."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from footfall.support import SupportSequence
from footfall.sync import Schedule, Synchronizer

GOLDEN = Path(__file__).parents[1] / "golden" / "traces"
WALK, RUN, HOP = "R.4 D.14 L.4 D.14*", "R.2 -.14 L.2 -.14*", "R.28 -.24*"

Play = tuple[dict[str, str], str, tuple[tuple[int, str, str], ...], int]

PLAYS: dict[str, Play] = {
    "paper_walk_and_walk_to_hop": (
        {"walk": WALK, "hop": "R.4 D.14 L.4 D.14 R.3 -.24 R.28 -.24 R.3 D.4"},
        "paper",
        ((0, "start", "walk"), (3, "start", "hop")),
        16,
    ),
    "paper_run_and_shot": (
        {"run": RUN, "shot": "L.2 D.1 R.24 -.38 L.3 D.2 R.3 D.4"},
        "paper",
        ((0, "start", "run"), (1, "start", "shot")),
        14,
    ),
    "walk_and_two_hops": (
        {"walk": WALK, "right hop": HOP, "left hop": "L.28 -.24*"},
        "footfall",
        (
            (0, "start", "walk"),
            (2, "start", "right hop"),
            (3, "start", "left hop"),
            (9, "stop", "right hop"),
        ),
        16,
    ),
    "walk_stands_long": (
        {"walk": WALK, "stand": "D2 L.4 D.3"},
        "footfall",
        ((0, "start", "walk"), (1, "start", "stand")),
        14,
    ),
    "three_of_whom_one_is_muted": (
        {
            "one": "-.5 D.25 +l1.5",
            "two": "L1 -1 +l1 R1 -1 L1 -1*",
            "three": "L1 -.075 L+l.5*",
        },
        "footfall",
        (
            *((slot, "start", "one") for slot in (0, 3, 6, 9, 14)),
            (8, "start", "three"),
            (15, "start", "two"),
            (20, "raise", "three"),
        ),
        24,
    ),
}


def played(name: str) -> Synchronizer:
    sequences, planner, commands, slots = PLAYS[name]
    names = list(sequences)
    options: Any = {"planner": planner}
    synchronizer = Synchronizer(
        [SupportSequence.parse(text) for text in sequences.values()], names=names, **options
    )
    for slot in range(slots):
        if slot:
            synchronizer.next_slot()
        for when, command, action in commands:
            if when == slot and command == "raise":
                synchronizer.set_priority(names.index(action), 9.0)
            elif when == slot:
                getattr(synchronizer, command)(names.index(action))
    return synchronizer


@pytest.mark.parametrize("name", PLAYS)
def test_trace(name: str) -> None:
    text = played(name).trace.describe() + "\n"
    assert text == (GOLDEN / f"{name}.txt").read_text(encoding="utf-8")


def test_a_muted_action_stands_in_brackets_and_has_no_stretch() -> None:
    trace = played("three_of_whom_one_is_muted").trace
    row = muted_row(trace)
    assert "(" in trace.describe()
    for muted, stretch, phase in zip(row.muted, row.stretches, row.phases, strict=True):
        assert (stretch is None) is (muted or phase is None)


def muted_row(trace: Schedule) -> Any:
    return next(row for row in trace.rows if any(row.muted))


@pytest.mark.parametrize("name", PLAYS)
def test_the_numbers_of_a_trace_agree(name: str) -> None:
    synchronizer = played(name)
    trace = synchronizer.trace
    for row in trace.rows:
        for slot, stretch in enumerate(row.stretches):
            if stretch is None:
                continue
            own = trace.rows.index(row)
            phase, support = row.phases[slot], row.supports[slot]
            assert phase is not None
            assert support is not None
            sequence = list(PLAYS[name][0].values())[own]
            duration = SupportSequence.parse(sequence).phases[phase].duration
            first = last = slot
            while first > 0 and row.held[first]:
                first -= 1
            while last + 1 < len(row.held) and row.held[last + 1]:
                last += 1
            lasting = sum(trace.durations[k] or 0.0 for k in range(first, last + 1))
            assert stretch == pytest.approx(lasting / duration)
