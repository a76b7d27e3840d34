"""Figures 6, 8 and 9 and Appendix A as pictures in letters, the same for every look-ahead."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from footfall.support import Support, SupportSequence
from footfall.sync import Synchronizer

GOLDEN = Path(__file__).parents[1] / "golden" / "figures"

FIGURES: dict[str, tuple[dict[str, str], list[float], int, dict[str, Any]]] = {
    "figure_06": ({"A1": "D L D R*", "A2": "L D - D L"}, [2.0, 1.0], 8, {}),
    "figure_08": ({"A1": "D R D L*", "A2": "- L D*"}, [1.0, 2.0], 6, {}),
    "figure_09": ({"A1": "D", "A2": "D R*", "A3": "D L - L*"}, [3.0, 2.0, 1.0], 8, {}),
    "appendix_a": ({"A1": "D L*", "A2": "R"}, [2.0, 1.0], 6, {"falls_back": True}),
}


def drawn(name: str, lookahead: int) -> str:
    """Return a figure as text."""
    sequences, priorities, slots, options = FIGURES[name]
    synchronizer = Synchronizer(
        [SupportSequence.parse(text) for text in sequences.values()],
        priorities,
        names=list(sequences),
        planner="paper",
        lookahead=lookahead,
        **options,
    )
    for action in range(len(sequences)):
        assert synchronizer.start(action)
    while synchronizer.slot + 1 < slots and synchronizer.result is not Support.CONFLICT:
        synchronizer.next_slot()
    return synchronizer.trace.describe() + "\n"


@pytest.mark.parametrize("lookahead", [1, 2, 3, 5])
@pytest.mark.parametrize("name", FIGURES)
def test_figure(name: str, lookahead: int) -> None:
    assert drawn(name, lookahead) == (GOLDEN / f"{name}.txt").read_text(encoding="utf-8")
