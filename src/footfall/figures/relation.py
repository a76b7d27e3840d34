"""Figure 4: what two supports make together."""

from __future__ import annotations

from itertools import product

from footfall.figures.cells import ON_COLOR, Grid, color_of, notation
from footfall.figures.figure import TOP, Figure, begin_sheet
from footfall.support import Support
from footfall.view.svg import Picture

__all__ = ["relation_figure"]

ORDER = (Support.DOUBLE, Support.RIGHT, Support.LEFT, Support.CONFLICT, Support.FLIGHT)
"""The order of the paper's table."""

CLAIM = "Algebraic relation that determines if motions can be blended."

_PLACES = {
    Support.DOUBLE: (0.0, 0.0),
    Support.LEFT: (-1.0, 1.0),
    Support.RIGHT: (1.0, 1.0),
    Support.CONFLICT: (0.0, 2.0),
    Support.FLIGHT: (0.0, 3.0),
}
"""Of the elements in the drawing of their order."""


def relation_figure() -> Figure:
    """Draw the table of the relation, and the order of which it is the meet."""
    title = "The relation ⊕ of two supports"
    note = "Each cell is worked out from its row and its column: the meet of the order on the right"
    picture = begin_sheet(4, title, note, 492.0)
    grid = Grid(64.0, TOP + 12.0, 104.0, 60.0)
    _draw_table(picture, grid)
    _draw_order(picture, 872.0, TOP + 56.0)
    laws = all(
        (a & b) is (b & a) and ((a & b) & c) is (a & (b & c))
        for a, b, c in product(ORDER, repeat=3)
    )
    conflicts = sum((a & b) is Support.CONFLICT for a, b in product(ORDER, repeat=2))
    facts = (
        f"25 cells, {conflicts} of them Err.",
        f"Commutative and associative in all 125 triples: {'yes' if laws else 'no'}.",
    )
    return Figure(4, "relation", title, CLAIM, facts, picture.to_svg())


def _draw_table(picture: Picture, grid: Grid) -> None:
    corner = grid.middle(0, 0)
    picture.words(corner[0], corner[1] + 9, "⊕", size=26, text_anchor="middle", font_weight="600")
    for index, support in enumerate(ORDER):
        for column, row in ((index + 1, 0), (0, index + 1)):
            x, y = grid.middle(column, row)
            picture.words(
                x,
                y + 6,
                notation(support),
                size=18,
                text_anchor="middle",
                font_weight="600",
                fill=color_of(support),
            )
    for (row, one), (column, other) in product(enumerate(ORDER), repeat=2):
        grid.cell(picture, column + 1, row + 1, one & other)
    right, bottom = grid.left + 6 * grid.width, grid.top + 6 * grid.height
    x, y = grid.left + grid.width - 0.5 * grid.gap, grid.top + grid.height - 0.5 * grid.gap
    picture.line(x, grid.top, x, bottom - grid.gap, class_="softpen", stroke_width=1.2)
    picture.line(grid.left, y, right - grid.gap, y, class_="softpen", stroke_width=1.2)


def _draw_order(picture: Picture, x: float, top: float) -> None:
    """Draw which support gives way to which: lines lead down to what wins."""

    def place(support: Support) -> tuple[float, float]:
        across, down = _PLACES[support]
        return x + 96.0 * across, top + 82.0 * down

    for above, below in product(ORDER, repeat=2):
        if _covers(above, below):
            picture.line(*place(above), *place(below), class_="softpen", stroke_width=1.8)
    for support in ORDER:
        middle = place(support)
        picture.add("circle", cx=middle[0], cy=middle[1], r=27, fill=color_of(support))
        ink = "#ffffff" if support is Support.CONFLICT else ON_COLOR
        picture.words(
            middle[0],
            middle[1] + 6,
            notation(support),
            size=17,
            text_anchor="middle",
            font_weight="600",
            fill=ink,
        )
    for support, told in (
        (Support.DOUBLE, "neutral: gives way to any other"),
        (Support.FLIGHT, "absorbs every other"),
    ):
        at = place(support)
        picture.words(at[0] + 40, at[1] + 5, told, size=14, class_="soft")


def _covers(above: Support, below: Support) -> bool:
    """Return whether `below` is the next under `above`."""
    if above is below or (above & below) is not below:
        return False
    between = (c for c in ORDER if c not in (above, below))
    return not any((above & c) is c and (c & below) is below for c in between)
