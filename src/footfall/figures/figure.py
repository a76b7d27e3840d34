"""A figure of the paper, drawn anew: its picture, the paper's claim, and what was measured."""

from __future__ import annotations

from dataclasses import dataclass

from footfall.view.svg import Picture
from footfall.view.text_width import text_width

__all__ = ["LEFT", "TOP", "WIDTH", "Figure", "begin_sheet"]

WIDTH = 1200.0
"""Of every figure [pixels]."""

LEFT = 24.0
"""Where headings begin, and how far pictures stay from both sides [pixels]."""

TOP = 84.0
"""Where the picture begins under its heading [pixels]."""


@dataclass(frozen=True, slots=True)
class Figure:
    """One figure."""

    number: int
    """Its number in the paper."""

    name: str
    """What its file is called, after the number."""

    title: str
    """Its heading."""

    claim: str
    """What the paper says of it."""

    facts: tuple[str, ...]
    """What was measured while it was drawn; one sentence each."""

    svg: str
    """The picture."""

    @property
    def stem(self) -> str:
        """The name of its files without a suffix, such as ``figure_04_relation``."""
        return f"figure_{self.number:02d}_{self.name}"


def begin_sheet(number: int, title: str, note: str, height: float) -> Picture:
    """Begin a figure with its heading; `note` is a line under it."""
    picture = Picture(f"figure-{number:02d}", f"Figure {number}: {title}", WIDTH, height)
    label = f"Figure {number}"
    picture.words(LEFT, 36, label, size=20, font_weight="600", class_="soft")
    picture.words(
        LEFT + text_width(label, 20, bold=True) + 8, 36, title, size=20, font_weight="600"
    )
    picture.words(LEFT, 61, note, size=14, class_="soft")
    return picture
