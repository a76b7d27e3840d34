"""How wide words are, near enough to keep them apart: a picture cannot ask the font."""

from __future__ import annotations

from unicodedata import combining, east_asian_width

__all__ = ["shortened", "text_width", "wrapped"]

# Widths in ems of a common sans-serif such as DejaVu Sans, the widest of those a picture names.
_NARROW = frozenset("iIjl.,:;'|!()[]")
_SLIM = frozenset(' frt-/"*')
_WIDE = frozenset("mwMWØ@%—")
_BOLD = 1.09


def text_width(text: str, size: float, *, bold: bool = False) -> float:
    """Return about how wide a line of text is [pixels], rather too wide than too narrow."""
    ems = sum(_ems(letter) for letter in text)
    return ems * size * (_BOLD if bold else 1.0)


def shortened(text: str, width: float, size: float, *, bold: bool = False) -> str:
    """Return a text, its end replaced by an ellipsis if it is wider than `width` [pixels]."""
    if text_width(text, size, bold=bold) <= width:
        return text
    kept = text
    while kept and text_width(kept + "…", size, bold=bold) > width:
        kept = kept[:-1]
    return kept.rstrip() + "…"


def wrapped(text: str, width: float, size: float) -> list[str]:
    """Return a text as lines of at most `width` [pixels], broken between words."""
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".lstrip()
        if lines[-1] and text_width(longer, size) > width:
            lines.append(word)
        else:
            lines[-1] = longer
    return lines


def _ems(letter: str) -> float:
    if combining(letter):
        return 0.0
    if east_asian_width(letter) in "WF":
        return 1.0
    for letters, ems in ((_NARROW, 0.34), (_SLIM, 0.42), (_WIDE, 0.96)):
        if letter in letters:
            return ems
    return 0.7 if letter.isupper() else 0.61
