"""Arrows, brackets and legends."""

from __future__ import annotations

import math

from footfall.view.svg import Picture

__all__ = ["draw_arrow", "draw_legend"]

_HEAD = 9.0


def draw_arrow(
    picture: Picture,
    start: tuple[float, float],
    end: tuple[float, float],
    *,
    stroke: str | None = None,
    width: float = 1.8,
) -> None:
    """Draw an arrow from one point to another."""
    x, y = end[0] - start[0], end[1] - start[1]
    length = max(math.hypot(x, y), 1e-9)
    x, y = x / length, y / length
    neck = (end[0] - _HEAD * x, end[1] - _HEAD * y)
    side = 0.45 * _HEAD
    pen = {"stroke": stroke} if stroke else {"class_": "softpen"}
    fill = {"fill": stroke} if stroke else {"class_": "soft"}
    picture.line(*start, *neck, stroke_width=width, **pen)
    picture.area(
        [
            end,
            (neck[0] - side * y, neck[1] + side * x),
            (neck[0] + side * y, neck[1] - side * x),
        ],
        **fill,
    )


def draw_legend(
    picture: Picture, x: float, y: float, color: str, text: str, *, dashed: bool = False
) -> None:
    """Draw a short line of a color and say what it means; y is that of the words' feet."""
    picture.line(
        x,
        y - 5,
        x + 26,
        y - 5,
        stroke=color,
        stroke_width=3,
        stroke_linecap=None if dashed else "round",
        stroke_dasharray="6 4" if dashed else None,
    )
    picture.words(x + 34, y, text, size=14, class_="soft")
