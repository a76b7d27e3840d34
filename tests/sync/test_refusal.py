"""Why an action waits, for what and how long, or the proof that it can never start."""

from __future__ import annotations

import pytest

from footfall.errors import ArgumentError
from footfall.support import SupportSequence
from footfall.sync import Synchronizer
from footfall.sync.refusal import Refusal


def synchronizer_of(*texts: str) -> Synchronizer:
    return Synchronizer([SupportSequence.parse(text) for text in texts])


def test_what_never_finds_ground_is_proved_impossible() -> None:
    synchronizer = synchronizer_of("R.5 -.3*", "L.4 -.2*")
    synchronizer.start(0)
    assert not synchronizer.start(1)
    assert synchronizer.foresee(1) == Refusal(
        "impossible beside '0': in none of their 4 joint phases does anything touch the ground; "
        "L of '1' conflicts with R of '0'; with '1' no foot would touch the ground",
        None,
        True,
    )


def test_nothing_is_foreseen_of_what_started_at_once() -> None:
    synchronizer = synchronizer_of("R D L D*", "R D L D*")
    synchronizer.start(0)
    assert synchronizer.start(1)
    assert synchronizer.foresee(1) is None


def test_it_is_told_who_must_change_and_in_how_many_seconds() -> None:
    synchronizer = synchronizer_of("R.5 D.5*", "L.4")
    synchronizer.start(0)
    assert not synchronizer.start(1)
    assert synchronizer.foresee(1) == Refusal(
        "waits for '0' R→D, 0.50 s: L of '1' conflicts with R of '0'", 0.5, False
    )


def test_an_action_that_is_none_is_not_foreseen() -> None:
    with pytest.raises(ArgumentError):
        synchronizer_of("R D L D*").foresee(1)


def test_of_many_at_once_nobody_conflicts_and_all_go_on() -> None:
    gaits = ["R D L D*", "R D L D*", "L D R D*", "D R D L*", "D*", "D R*", "D L*"]
    synchronizer = synchronizer_of(*gaits)
    for action in range(len(gaits)):
        assert synchronizer.start(action)
        synchronizer.next_slot()
    phases = [set[str]() for _ in gaits]
    for _ in range(12):
        assert synchronizer.next_slot().symbol in {"R", "L", "D"}
        for action, row in enumerate(synchronizer.schedule.rows):
            phases[action].add(row.cells[0].removesuffix("~"))
    # The last three are never due alone: what matters is that no gait starves.
    assert [len(seen) for seen in phases[:4]] == [3, 3, 3, 3]


def test_a_wait_that_is_longer_than_is_foreseen_is_not_called_impossible() -> None:
    synchronizer = synchronizer_of("R6 +l6 R6 D1*", "L.4")
    synchronizer.start(0)
    assert not synchronizer.start(1)
    assert synchronizer.foresee(1) == Refusal(
        "waits for more than 10 s: L of '1' conflicts with R of '0'", None, False
    )
