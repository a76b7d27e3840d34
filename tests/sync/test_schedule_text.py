"""Everything that was decided, as text."""

from __future__ import annotations

from footfall.support import SupportSequence
from footfall.sync import Synchronizer

WAITED = """\
slot          0     1     2     3
seconds       .5    .31   .29   .31
walk     1    R     D     L     D
              ×1    ×3.14 ×.57  ×3.14
hop      2.5  w     L     -     L
                    ×.79  ×1.43 ×.79
blend         R     L     -     L
slot 0: 'hop' waits: L of 'hop' conflicts with R of 'walk'"""

FORESEEN = """\
slot          k     k+1   k+2   k+3   k+4   k+5
seconds       .31   .29   .31   .29   .31   .29
walk     1    D     R     D     L     D     R
              ×3.14 ×.57  ×3.14 ×.57  ×3.14 ×.57
hop      2.5  L     -     L     -     L     -
              ×.79  ×1.43 ×.79  ×1.43 ×.79  ×1.43
blend         L     -     L     -     L     -"""


def test_phases_seconds_stretches_and_waits_are_told_slot_by_slot() -> None:
    walk, hop = (SupportSequence.parse(text) for text in ("R.5 D.1 L.5 D.1*", "L.4 -.2*"))
    synchronizer = Synchronizer(
        [walk, hop], names=["walk", "hop"], priorities=[1.0, 2.5], planner="paper"
    )
    synchronizer.start(0)
    synchronizer.start(1)
    for _ in range(3):
        synchronizer.next_slot()
    assert synchronizer.trace.describe() == WAITED
    assert synchronizer.schedule.describe() == FORESEEN


def test_a_hold_is_marked_from_the_first_slot_that_repeats_a_phase() -> None:
    texts = ["R.4 D.14 L.4 D.14*", "D.9 R.2 D.2 L.2*"]
    synchronizer = Synchronizer([SupportSequence.parse(text) for text in texts])
    first = 0
    for action in (0, 1):
        synchronizer.start(action)
    for _ in range(12):
        synchronizer.next_slot()
        for row in synchronizer.schedule.rows:
            for slot in range(1, len(row.held)):
                assert row.held[slot] == (row.phases[slot] == row.phases[slot - 1])
            first += row.held[1]
    assert first > 0
