"""What is read off the way that the search has found: how fast each action plays."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from tests.sync.test_muting import running_window

from footfall.sync.columns import has_ended
from footfall.sync.tables import SequenceTable
from footfall.sync.window import Window

PAIRS = [
    ("R.4 D.14 L.4 D.14*", "R.3 D.3 L.3 D.3*"),
    ("R.4 D.14 L.4 D.14*", "D.9 R.2 -.2*"),
    ("D.5 L.4 D.3 R.4*", "D.2 R.4 -.2 L.4*"),
    ("R.4 D.14 L.4 D.14*", "L.3 R.3 D1.6"),
]


def spans(window: Window, seat: int) -> list[tuple[int, int, int]]:
    """Return phase, first column and the column behind the last of what columns 0 and 1 play.

    A phase that goes on behind the last decided column is left out.
    """
    phases = window.phases[seat].tolist()
    found: list[tuple[int, int, int]] = []
    for column in (0, 1):
        first = phases.index(phases[column])
        behind = first + phases.count(phases[column])
        if behind < len(phases) - 1:
            found.append((column, first, behind))
    return found


def own_duration(table: SequenceTable, window: Window, seat: int, column: int) -> float:
    """Return how long what is played in a column lasts at the clip's own speed."""
    phase = window.phases[seat, column]
    if phase == window.phases[seat, 0]:
        return float(window.remaining[seat])
    return float(table.durations[table.first[seat] + phase % table.phase_count[seat]])


@pytest.mark.parametrize("texts", PAIRS)
def test_a_phase_is_played_evenly_over_all_its_columns(texts: tuple[str, str]) -> None:
    held = 0
    for phases in product(range(4), range(3)):
        table, window = running_window(list(texts), list(phases), [2.0, 1.0])
        for seat in np.flatnonzero(~window.muted).tolist():
            for column, first, behind in spans(window, seat):
                lasting = window.durations[first:behind].sum()
                own = own_duration(table, window, seat, column)
                if has_ended(table, seat, int(window.phases[seat, column])):
                    own = 0.0
                assert window.pace[seat, column] * lasting == pytest.approx(own, abs=1e-9)
                held += behind - first > 1
    assert held > 0, "no phase lasts longer than a column: nothing was tested"


@pytest.mark.parametrize("text", ["R.01 D.02 L.01 D.02*", "R.4 -.03 L.4 -.03*", "D.02"])
def test_an_action_alone_is_played_as_it_is_however_short_its_phases(text: str) -> None:
    table, window = running_window([text], [0], [1.0])
    for column in range(int(table.phase_count[0])):
        assert window.durations[column] == pytest.approx(table.durations[column])
    assert window.pace[0, 0] == 1.0
