"""One color for one meaning, the same in every picture and readable to the color-blind.

Hues of Okabe and Ito's set, evened in lightness so that they hold on light and dark paper.
"""

from __future__ import annotations

__all__ = ["BODY", "FOOT_COLORS", "SLIP", "SUPPORT_COLORS", "SUPPORT_NAMES", "readable_symbol"]

SUPPORT_COLORS = {"R": "#e6912a", "L": "#3b8fd0", "D": "#35a47a", "-": "#a4adb8"}
"""Fill of each symbol of a support."""

SUPPORT_NAMES = {"R": "right foot", "L": "left foot", "D": "both feet", "-": "flight"}
"""What each symbol means, for legends."""

FOOT_COLORS = (SUPPORT_COLORS["L"], SUPPORT_COLORS["R"])
"""Left and right foot."""

SLIP = "#d7263d"
"""A planted foot that moves, and a blend in transition."""

BODY = "#7d8794"
"""The body and its way over the ground."""


def readable_symbol(symbol: str) -> str:
    """Return a support's symbol as it is printed: a dash for flight."""
    return "–" if symbol == "-" else symbol
