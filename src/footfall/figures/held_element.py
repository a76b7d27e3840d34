"""Figure 8: one element is extended, and the actions can be blended again."""

from __future__ import annotations

from footfall.figures.arrows import draw_arrow
from footfall.figures.cells import Grid, define_hatching
from footfall.figures.figure import TOP, Figure, begin_sheet
from footfall.support import Support, SupportSequence
from footfall.sync import Synchronizer
from footfall.view.svg import Picture

__all__ = ["held_element_figure"]

CLAIM = (
    "Example of extension of an element of the sequence. After synchronization, all the actions "
    "can be blended and the relation determines the new support phase."
)
FIRST, SECOND = "D R D L*", "- L D*"
"""Of the paper: S1 = (DS, RS), S2 = (Ø, LS) in the columns k + 1 and k + 2."""

COLUMNS = 4
LOOKAHEAD = 1


def held_element_figure() -> Figure:
    """Draw both rows as they are, and as the synchronizer plays them in paper mode."""
    title = "Extension of one element (nk = 1)"
    note = (
        "Left: the sequences as they are; right: as the synchronizer plays them, "
        "the second action having the higher priority; hatched: the extended element"
    )
    picture = begin_sheet(8, title, note, 356.0)
    define_hatching(picture)
    sequences = [SupportSequence.parse(text) for text in (FIRST, SECOND)]
    synchronizer = Synchronizer(
        sequences, [1.0, 2.0], planner="paper", lookahead=LOOKAHEAD, names=["S₁", "S₂"]
    )
    synchronizer.start(0)
    synchronizer.start(1)
    for _ in range(COLUMNS - 1):
        synchronizer.next_slot()
    trace = synchronizer.trace
    before = Grid(88.0, TOP + 6.0, 104.0, 60.0)
    plain = [[sequence.at(k).support for k in range(COLUMNS)] for sequence in sequences]
    nothing = [[False] * COLUMNS] * 2
    _draw(picture, before, plain, nothing, [a & b for a, b in zip(*plain, strict=True)])
    after = Grid(708.0, before.top, before.width, before.height)
    played = [[support for support in row.supports if support is not None] for row in trace.rows]
    _draw(picture, after, played, [list(row.held) for row in trace.rows], list(trace.results))
    x = before.left + COLUMNS * before.width
    y = before.top + 2.5 * before.height
    draw_arrow(picture, (x + 16, y), (after.left - 74, y), width=2.4)
    picture.words(
        (x + after.left - 58) / 2, y - 12, "extension", size=15, text_anchor="middle", class_="soft"
    )
    clash = [a & b for a, b in zip(*plain, strict=True)].index(Support.CONFLICT)
    facts = (
        f"Without extension column k+{clash + 1} is Err.",
        f"With it the result is {' '.join(one.symbol for one in trace.results)}; "
        f"{sum(sum(row.held) for row in trace.rows)} element is extended.",
    )
    return Figure(8, "extended_element", title, CLAIM, facts, picture.to_svg())


def _draw(
    picture: Picture,
    grid: Grid,
    rows: list[list[Support]],
    held: list[list[bool]],
    results: list[Support],
) -> None:
    for column in range(COLUMNS):
        grid.heading(picture, column, 0, f"k+{column + 1}")
    for row, name in enumerate(("S₁", "S₂")):
        grid.row_name(picture, row + 1, name)
        for column, support in enumerate(rows[row]):
            grid.cell(picture, column, row + 1, support, held=held[row][column])
    y = grid.top + 3 * grid.height + 5.0
    picture.line(
        grid.left - 44,
        y,
        grid.left + COLUMNS * grid.width - grid.gap,
        y,
        class_="softpen",
        stroke_width=1.4,
    )
    grid.row_name(picture, 3.2, "⊕")
    for column, support in enumerate(results):
        grid.cell(picture, column, 3.2, support)
