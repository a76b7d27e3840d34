"""Start, stop and step: what a person does with the synchronizer."""

from __future__ import annotations

import pytest
from tests.paper.requirements import requirement

from footfall.errors import ArgumentError, SupportSequenceError
from footfall.support import Support, SupportSequence
from footfall.sync import Synchronizer

WALK = SupportSequence.parse("R D L D*")
HOP = SupportSequence.parse("L -*")


@requirement(
    73,
    "Then, the start of the action is delayed until the next element of the sequence is reached.",
)
def test_a_delayed_start_happens_in_a_later_slot_and_says_why_it_waits() -> None:
    synchronizer = Synchronizer([WALK, HOP], names=["walk", "hop"], planner="paper")
    assert synchronizer.start(0)
    assert not synchronizer.start(1)
    assert synchronizer.waiting == {1: "waits: L of 'hop' conflicts with R of 'walk'"}
    synchronizer.next_slot()
    assert synchronizer.waiting == {}
    assert synchronizer.playing == (0, 1)


@pytest.mark.parametrize(
    ("late", "reason"),
    [
        ("D L -*", "waits: in the next slot L of 'late' would conflict with R of 'walk'"),
        ("- D - R", "waits: 3 slots later R of 'late' would conflict with L of 'walk'"),
        ("D - D L*", None),
    ],
)
def test_the_reason_of_a_wait_may_lie_ahead(late: str, reason: str | None) -> None:
    walk = SupportSequence.parse("D R D L*")
    synchronizer = Synchronizer(
        [walk, SupportSequence.parse(late)],
        names=["walk", "late"],
        planner="paper",
        start_policy="native",
    )
    synchronizer.start(0)
    assert synchronizer.start(1) is (reason is None)
    assert synchronizer.waiting.get(1) == reason


def test_a_stop_cancels_a_wait() -> None:
    synchronizer = Synchronizer([WALK, HOP], planner="paper")
    synchronizer.start(0)
    synchronizer.start(1)
    synchronizer.stop(1)
    assert synchronizer.waiting == {}
    synchronizer.next_slot()
    assert synchronizer.playing == (0,)


def test_the_oldest_command_is_tried_first() -> None:
    # Both may start in slot 1, but not beside each other.
    right, left = SupportSequence.parse("R -*"), SupportSequence.parse("L -*")
    synchronizer = Synchronizer([WALK, left, right], [3, 1, 2], planner="paper")
    synchronizer.start(0)
    synchronizer.start(1)
    assert list(synchronizer.waiting) == [1]
    synchronizer.next_slot()
    assert not synchronizer.start(2)
    assert synchronizer.playing == (0, 1)


def test_starting_twice_changes_nothing() -> None:
    synchronizer = Synchronizer([WALK, HOP], planner="paper")
    assert synchronizer.start(0)
    before = str(synchronizer.schedule)
    assert synchronizer.start(0)
    assert not synchronizer.start(1)
    assert not synchronizer.start(1)
    assert str(synchronizer.schedule) == before
    assert list(synchronizer.waiting) == [1]


def test_no_slot_follows_a_failure() -> None:
    sequences = [SupportSequence.parse("D L*"), SupportSequence.parse("D R")]
    synchronizer = Synchronizer(sequences, planner="paper", lookahead=1, priorities=[2, 1])
    synchronizer.start(0)
    synchronizer.start(1)
    while synchronizer.result is not Support.CONFLICT:
        synchronizer.next_slot()
    with pytest.raises(
        ArgumentError,
        match=r"^the rule failed in slot \d+, so no slot follows it; "
        r"stop an action that has ended$",
    ):
        synchronizer.next_slot()


def test_appendix_a_can_be_asked_for() -> None:
    sequences = [SupportSequence.parse("D L*"), SupportSequence.parse("D R")]
    synchronizer = Synchronizer(sequences, planner="paper", falls_back=True)
    synchronizer.start(0)
    synchronizer.start(1)
    results = [synchronizer.next_slot() for _ in range(20)]
    assert Support.CONFLICT not in results


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"sequences": []}, "no sequence; a synchronizer needs at least one"),
        (
            {"priorities": [1.0]},
            "2 sequences, 1 priorities and 2 names; give one of each for every action",
        ),
        (
            {"names": ["walk"]},
            "2 sequences, 2 priorities and 1 names; give one of each for every action",
        ),
        ({"lookahead": 0}, "a look-ahead of 0 slots; it must be at least 1"),
        ({"planner": "best"}, 'no planner \'best\'; there are "footfall" and "paper"'),
        (
            {"planner": "paper", "start_policy": "later"},
            'no start policy \'later\'; there are "extend" and "native"',
        ),
        (
            {"planner": "paper", "ended": "neutral"},
            '\'neutral\' is no end of the planner "paper"; "repeat" or "stop" is',
        ),
        (
            {"ended": "repeat"},
            'the start policy "native", the end "repeat" and the fallback belong to the '
            'planner "paper"; the planner is "footfall"',
        ),
    ],
)
def test_wrong_arguments_are_explained(options: dict[str, object], message: str) -> None:
    with pytest.raises(ArgumentError) as caught:
        Synchronizer(**({"sequences": [WALK, HOP]} | options))  # pyright: ignore[reportArgumentType]
    assert str(caught.value) == message


def test_an_unknown_action_is_named() -> None:
    with pytest.raises(ArgumentError, match=r"^no action 2; there are 0 to 1$"):
        Synchronizer([WALK, HOP]).start(2)


@pytest.mark.parametrize("planner", ["paper", "footfall"])
def test_a_cycle_of_one_foot_is_refused(planner: str) -> None:
    with pytest.raises(SupportSequenceError) as caught:
        Synchronizer([WALK, SupportSequence.parse("R*")], planner=planner)  # pyright: ignore[reportArgumentType]
    assert str(caught.value) == (
        "phases 0 and 0, neighbors in the cycle, are both RIGHT: a cycle of a single R never "
        "changes feet; leave out the * or add a phase, such as R D*"
    )
