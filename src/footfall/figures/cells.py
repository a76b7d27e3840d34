"""Supports as colored cells in the notation of the paper: RS, LS, DS, Ø and Err."""

from __future__ import annotations

from dataclasses import dataclass

from footfall.support import Support
from footfall.view.palette import SLIP, SUPPORT_COLORS
from footfall.view.svg import Picture

__all__ = ["ON_COLOR", "Grid", "color_of", "define_hatching", "notation"]

ON_COLOR = "#10151a"
"""Letters on the colors of supports."""

_NOTATION = {
    Support.RIGHT: "RS",
    Support.LEFT: "LS",
    Support.DOUBLE: "DS",
    Support.FLIGHT: "Ø",
    Support.CONFLICT: "Err",
}

_ROUND = 5.0


def notation(support: Support) -> str:
    """Return a support as the paper writes it."""
    return _NOTATION[support]


def color_of(support: Support) -> str:
    """Return the fill of a support."""
    return SLIP if support is Support.CONFLICT else SUPPORT_COLORS[support.symbol]


def define_hatching(picture: Picture) -> None:
    """Define the pattern of phases that are held."""
    picture.open(
        "pattern",
        id=f"{picture.name}-held",
        width=8,
        height=8,
        patternUnits="userSpaceOnUse",
        patternTransform="rotate(45)",
    )
    picture.line(0, 0, 0, 8, stroke=ON_COLOR, stroke_width=2.6, stroke_opacity=0.3)
    picture.close("pattern")


@dataclass(frozen=True, slots=True)
class Grid:
    """Where the cells of a table lie."""

    left: float
    """The x of the first column [pixels]."""

    top: float
    """The y of the first row [pixels]."""

    width: float = 92.0
    """From one column to the next [pixels]."""

    height: float = 52.0
    """From one row to the next [pixels]."""

    gap: float = 6.0
    """Between two cells [pixels]."""

    def middle(self, column: float, row: float) -> tuple[float, float]:
        """Return the middle of a cell."""
        x = self.left + (column + 0.5) * self.width - 0.5 * self.gap
        return x, self.top + (row + 0.5) * self.height - 0.5 * self.gap

    def cell(
        self,
        picture: Picture,
        column: float,
        row: float,
        support: Support,
        *,
        label: str = "",
        held: bool = False,
        repeated: bool = False,
    ) -> None:
        """Draw a cell.

        Args:
            picture: Where to.
            column: Which column, from 0.
            row: Which row, from 0.
            support: What it holds.
            label: A small line over the support, such as the index of the phase.
            held: Whether it is hatched: the phase of the column before goes on.
            repeated: Whether it is pale: not a part of the original motion.
        """
        x, y = self.left + column * self.width, self.top + row * self.height
        size = (self.width - self.gap, self.height - self.gap)
        fill = color_of(support)
        opacity = 0.38 if repeated else None
        picture.rectangle(x, y, *size, rx=_ROUND, fill=fill, fill_opacity=opacity)
        if repeated:
            picture.rectangle(
                x, y, *size, rx=_ROUND, fill="none", stroke=fill, stroke_dasharray="5 4"
            )
        if held:
            picture.rectangle(x, y, *size, rx=_ROUND, fill=f"url(#{picture.name}-held)")
        ink = {"class_": "ink"} if repeated else {"fill": _ink_on(support)}
        middle_x, middle_y = self.middle(column, row)
        if label:
            picture.words(middle_x, middle_y - 5, label, size=13, text_anchor="middle", **ink)
        picture.words(
            middle_x,
            middle_y + (14 if label else 6),
            notation(support),
            size=18,
            text_anchor="middle",
            font_weight="600",
            **ink,
        )

    def heading(self, picture: Picture, column: float, row: float, text: str) -> None:
        """Write a heading into the middle of a cell."""
        x, y = self.middle(column, row)
        picture.words(x, y + 5, text, size=15, text_anchor="middle", class_="soft")

    def row_name(self, picture: Picture, row: float, text: str, *, remark: str = "") -> None:
        """Write what a row is, before its first cell; a remark stands under it."""
        _, y = self.middle(0, row)
        y -= 7 if remark else 0
        picture.words(self.left - 16, y + 5, text, size=16, text_anchor="end", font_weight="600")
        if remark:
            picture.words(self.left - 16, y + 23, remark, size=13, text_anchor="end", class_="soft")


def _ink_on(support: Support) -> str:
    return "#ffffff" if support is Support.CONFLICT else ON_COLOR
