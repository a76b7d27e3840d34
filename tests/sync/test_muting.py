"""Who plays beside the schedule because no room can be made for it (S-19)."""

from __future__ import annotations

import numpy as np
import pytest

from footfall.support import Support, SupportSequence
from footfall.sync.events import enter_next_slot, reconsider
from footfall.sync.search_memory import LANES
from footfall.sync.shares import spend_slot
from footfall.sync.tables import SequenceTable, rules_of
from footfall.sync.window import Window

WALK = "R.4 D.14 L.4 D.14*"


def running_window(
    texts: list[str], phases: list[int], weights: list[float]
) -> tuple[SequenceTable, Window]:
    """Put all in at the beginning of a phase, and plan."""
    table = SequenceTable.of([SupportSequence.parse(text) for text in texts])
    window = Window.empty(len(texts), 5)
    window.playing[:] = True
    window.sequence[:] = window.age[:] = range(len(texts))
    window.priority[:] = window.weight[:] = weights
    window.phases[:, 0] = phases
    window.remaining[:] = [
        table.durations[table.first[i] + phase] for i, phase in enumerate(phases)
    ]
    reconsider(table, window, rules_of("footfall"))
    return table, window


def test_of_two_that_cannot_wait_for_each_other_the_second_is_muted() -> None:
    # Right hop and left hop begun in flight, put side by side by force, then a third on R.
    texts = ["R.1 +l.1*".replace("+l", "L"), "+l.1 +r.1*"]
    table, window = running_window(texts, [0, 0], [2.0, 1.0])
    assert window.muted.tolist() == [False, True]
    assert window.results[0] == Support.RIGHT
    assert 1 not in window.results
    assert table.whole == 0b11111


def test_who_stands_in_nobodys_way_is_not_muted() -> None:
    _, window = running_window(["R.1 L.1*", "+l.1 +r.1*", "R.1 L.1*"], [0, 0, 0], [3.0, 2.0, 1.0])
    assert window.muted.tolist() == [False, True, False]


@pytest.mark.parametrize("more", [0, 1, 2])
def test_of_more_actions_than_can_be_searched_over_the_least_are_muted(more: int) -> None:
    texts = ["R.3 -.2*"] * (LANES + more)
    weights = np.arange(len(texts), 0.0, -1.0).tolist()
    _, window = running_window(texts, [0] * len(texts), weights)
    assert window.muted.tolist() == [False] * LANES + [True] * more


def test_a_muted_action_rejoins_when_there_is_room() -> None:
    table, window = running_window([WALK, "R.3 -.2*"], [0, 0], [2.0, 1.0])
    window.muted[1] = True
    rules = rules_of("footfall")
    reconsider(table, window, rules)
    muted = 0
    while window.muted[1] and muted < 12:
        spend_slot(table, window)
        enter_next_slot(table, window, rules)
        muted += 1
    # It rests for three slots at least.
    assert 3 <= muted < 12
    assert not window.muted[1]
