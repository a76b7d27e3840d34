"""Figure 6: what follows the end of a sequence, cyclic or not."""

from __future__ import annotations

from footfall.figures.arrows import draw_arrow
from footfall.figures.cells import Grid
from footfall.figures.figure import TOP, Figure, begin_sheet
from footfall.support import SupportSequence
from footfall.sync import Synchronizer

__all__ = ["extension_figure"]

CLAIM = (
    "Extension of cyclic (A1) and non-cyclic (A2) actions. A1 is repeated as a whole; only the "
    "last element of A2 is repeated."
)
SEQUENCES = ("R D L D*", "L D - D L")
"""Of the paper."""

COLUMNS = 8


def extension_figure() -> Figure:
    """Draw both rows as the synchronizer plays them in paper mode, each alone."""
    title = "Extension of cyclic and of non-cyclic actions"
    note = "Solid: the original motion; pale: what the synchronizer appends (planner “paper”)"
    picture = begin_sheet(6, title, note, 324.0)
    grid = Grid(232.0, TOP + 4.0, 114.0, 62.0)
    facts: list[str] = []
    for column in range(COLUMNS):
        grid.heading(picture, column, 0, f"Sᵢ({column + 1})")
    for row, text in enumerate(SEQUENCES):
        sequence = SupportSequence.parse(text)
        synchronizer = Synchronizer([sequence], planner="paper")
        synchronizer.start(0)
        for _ in range(COLUMNS - 1):
            synchronizer.next_slot()
        supports = synchronizer.trace.results
        kind = "cyclic" if sequence.cyclic else "non-cyclic"
        grid.row_name(picture, row + 1, "A₁" if row == 0 else "A₂", remark=kind)
        for column, support in enumerate(supports):
            repeated = column >= len(sequence.phases)
            grid.cell(picture, column, row + 1, support, repeated=repeated)
        facts.append(f"{text} is played as {' '.join(one.symbol for one in supports)}.")
    bottom = grid.top + 3 * grid.height + 26.0
    right = grid.left + COLUMNS * grid.width - grid.gap
    draw_arrow(picture, (grid.left, bottom), (right, bottom))
    picture.words(
        (grid.left + right) / 2,
        bottom - 9,
        "chronological order",
        size=14,
        text_anchor="middle",
        class_="soft",
    )
    return Figure(6, "extension", title, CLAIM, tuple(facts), picture.to_svg())
