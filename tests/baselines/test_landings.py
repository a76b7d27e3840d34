"""What animators mark in a clip: the moments in which a foot comes down."""

from __future__ import annotations

import pytest

from footfall.baselines import landings
from footfall.support import SupportSequence


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("R.4 D.1 L.4 D.1*", [(0.4, 0), (0.9, 1)]),
        ("R.3 -.1 L.3 -.1*", [(0.0, 1), (0.4, 0)]),
        ("R.3 -.2*", [(0.0, 1)]),
        ("D1*", []),
        ("R.4 D.1 L.4", [(0.4, 0)]),
        ("D.7 -.4 D.9", [(1.1, 0), (1.1, 1)]),
    ],
)
def test_every_landing_once_in_order(text: str, expected: list[tuple[float, int]]) -> None:
    found = landings(SupportSequence.parse(text))
    assert [foot for _, foot in found] == [foot for _, foot in expected]
    assert [time for time, _ in found] == pytest.approx([time for time, _ in expected])


def test_a_cycle_cut_in_the_middle_of_a_phase_counts_within_its_turn() -> None:
    phases = SupportSequence.parse("R.4 D.1 L.4 D.1").phases
    found = landings(SupportSequence((*phases,), cyclic=True, start=-0.25))
    assert [time for time, _ in found] == pytest.approx([0.15, 0.65])
