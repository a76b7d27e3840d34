"""One color for one meaning, the same in every picture and readable to the color-blind."""

from __future__ import annotations

from footfall.support.palette import SUPPORT_COLORS, SUPPORT_NAMES

__all__ = ["BODY", "FOOT_COLORS", "SLIP", "SUPPORT_COLORS", "SUPPORT_NAMES", "readable_symbol"]

FOOT_COLORS = (SUPPORT_COLORS["L"], SUPPORT_COLORS["R"])
"""Left and right foot."""

SLIP = "#d7263d"
"""A planted foot that moves, and a blend in transition."""

BODY = "#7d8794"
"""The body and its way over the ground."""


def readable_symbol(symbol: str) -> str:
    """Return a support's symbol as it is printed: a dash for flight."""
    return "–" if symbol == "-" else symbol
