"""What phases contribute to the slots that they cover."""

from __future__ import annotations

import pytest

from footfall.support import SupportSequence
from footfall.sync.shares import finish_slot, natural_duration, spend_slot
from footfall.sync.tables import SequenceTable
from footfall.sync.window import Window

TABLE = SequenceTable.of([SupportSequence.parse("R.4 D.1*"), SupportSequence.parse("D.3 L.6")])


def window(phases: list[int], *, sequence: int = 0, remaining: float) -> Window:
    made = Window.empty(1, len(phases) - 1)
    made.playing[0] = True
    made.sequence[0] = sequence
    made.phases[0, : len(phases)] = phases
    made.remaining[0] = remaining
    return made


def test_natural_durations_past_the_end() -> None:
    assert [natural_duration(TABLE, 0, phase) for phase in range(4)] == [0.4, 0.1, 0.4, 0.1]
    assert [natural_duration(TABLE, 1, phase) for phase in range(4)] == [0.3, 0.6, 0.6, 0.6]


def test_a_phase_is_over_when_its_slots_are() -> None:
    made = window([0, 0, 1, 2], sequence=1, remaining=0.3)
    made.pace[0, 0] = 0.5
    left: list[float] = []
    for duration, phases in ((0.3, [0, 1, 2, 3]), (0.3, [1, 2, 3, 4]), (0.6, [2, 3, 4, 5])):
        made.durations[0] = duration
        spend_slot(TABLE, made)
        left.append(made.remaining[0])
        made.phases[0, :4] = phases
    assert left == pytest.approx([0.15, 0.6, 0.0])


def test_a_double_support_that_is_split_over_its_own_time_is_not_held() -> None:
    made = window([0, 0, 1, 2], sequence=1, remaining=0.3)
    made.durations[0] = 0.2
    finish_slot(TABLE, made)
    assert made.held[0] == 0
    made.durations[0] = 0.4
    finish_slot(TABLE, made)
    assert made.held[0] == 1
    made.phases[0, :2] = (0, 1)
    finish_slot(TABLE, made)
    assert made.held[0] == 0


def test_a_muted_action_runs_on_over_its_phases() -> None:
    made = window([0, 0, 0, 0], remaining=0.1)
    made.muted[0] = True
    made.durations[0] = 0.45
    spend_slot(TABLE, made)
    assert made.phases[0, 1] == 2
    assert made.remaining[0] == pytest.approx(0.15)
    assert made.held[0] == 1
