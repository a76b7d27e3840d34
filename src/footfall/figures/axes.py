"""Curves over axes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from footfall.arrays import Flags, Floats
from footfall.view.svg import Picture

__all__ = ["Axes"]


@dataclass(frozen=True, slots=True)
class Axes:
    """A rectangle of a picture, and what its sides stand for."""

    left: float
    """[pixels]"""

    top: float
    """[pixels]"""

    width: float
    """[pixels]"""

    height: float
    """[pixels]"""

    x_range: tuple[float, float]
    """The numbers at the left and the right side."""

    y_range: tuple[float, float]
    """The numbers at the bottom and the top."""

    @property
    def right(self) -> float:
        """The x of the right side [pixels]."""
        return self.left + self.width

    @property
    def bottom(self) -> float:
        """The y of the bottom [pixels]."""
        return self.top + self.height

    def x(self, value: float) -> float:
        """Return where a number lies from left to right [pixels]."""
        low, high = self.x_range
        return self.left + (value - low) / (high - low) * self.width

    def y(self, value: float) -> float:
        """Return where a number lies from bottom to top [pixels]."""
        low, high = self.y_range
        return self.bottom - (value - low) / (high - low) * self.height

    def at(self, x: float, y: float) -> tuple[float, float]:
        """Return where a point lies [pixels]."""
        return self.x(x), self.y(y)

    def draw(
        self,
        picture: Picture,
        *,
        x_ticks: Sequence[float] = (),
        y_ticks: Sequence[float] = (),
        x_label: str = "",
        y_label: str = "",
    ) -> None:
        """Draw a panel with lines and numbers at the ticks, and a label at each side."""
        picture.rectangle(self.left, self.top, self.width, self.height, rx=4, class_="panel")
        for tick in x_ticks:
            x = self.x(tick)
            picture.line(x, self.top, x, self.bottom, class_="rule", stroke_width=1)
            picture.words(
                x, self.bottom + 19, f"{tick:g}", size=13, text_anchor="middle", class_="soft"
            )
        for tick in y_ticks:
            y = self.y(tick)
            picture.line(self.left, y, self.right, y, class_="rule", stroke_width=1)
            picture.words(
                self.left - 9, y + 5, f"{tick:g}", size=13, text_anchor="end", class_="soft"
            )
        if x_label:
            y = self.bottom + (40 if x_ticks else 22)
            picture.words(self.right, y, x_label, size=14, text_anchor="end", class_="soft")
        if y_label:
            picture.words(self.left, self.top - 10, y_label, size=14, class_="soft")

    def curve(
        self, picture: Picture, x: Floats, y: Floats, **attributes: float | str | None
    ) -> None:
        """Draw a line through points; those on a straight stretch are left out."""
        kept = _bends(x, y, 0.15 * (self.y_range[1] - self.y_range[0]) / self.height)
        points = [self.at(*point) for point in zip(x[kept].tolist(), y[kept].tolist(), strict=True)]
        picture.path(points, **{"stroke_width": 2.6, "stroke_linejoin": "round", **attributes})

    def mark(self, picture: Picture, x: float, y: float, fill: str, radius: float = 4.5) -> None:
        """Draw a point."""
        picture.add("circle", cx=self.x(x), cy=self.y(y), r=radius, fill=fill)


def _bends(x: Floats, y: Floats, tolerance: float) -> Flags:
    """Return which points are needed so that the line passes all others within a tolerance."""
    kept = np.zeros(len(x), dtype=np.bool_)
    kept[[0, -1]] = True
    stretches = [(0, len(x) - 1)]
    while stretches:
        first, last = stretches.pop()
        if last - first < 2:
            continue
        inside = slice(first + 1, last)
        share = (x[inside] - x[first]) / max(float(x[last] - x[first]), 1e-12)
        off = np.abs(y[first] + share * (y[last] - y[first]) - y[inside])
        if float(off.max()) > tolerance:
            middle = first + 1 + int(off.argmax())
            kept[middle] = True
            stretches += [(first, middle), (middle, last)]
    return kept
