"""A schedule as a small table of HTML, for notebooks."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import TYPE_CHECKING

from footfall.support.palette import SUPPORT_COLORS, SUPPORT_NAMES

if TYPE_CHECKING:
    from footfall.sync.schedule import Schedule

__all__ = ["schedule_html"]

CELL = "padding:3px 9px;text-align:center;border-radius:4px;"
INK = "#10151a"
CONFLICT = "#d7263d"

HATCHED = "background-image:repeating-linear-gradient(-45deg,#10151a66 0 2px,transparent 2px 6px);"
"""Over a phase that is held."""


def schedule_html(schedule: Schedule, slots: Sequence[str]) -> str:
    """Return a table, a row an action; held phases are hatched and say why.

    Args:
        schedule: The schedule.
        slots: The heading of each column.
    """
    rows = [_row("", [_heading(slot) for slot in slots])]
    for row in schedule.rows:
        cells = [
            _cell(None if support is None else support.symbol, held=held, title=row.remark)
            for support, held in zip(row.supports, row.held, strict=True)
        ]
        rows.append(_row(f"{row.name} ({row.priority:g})", cells))
    rows.append(_row("blend", [_cell(result.symbol) for result in schedule.results]))
    style = "border-collapse:separate;border-spacing:2px;font:13px system-ui,sans-serif"
    return f'<table style="{style}">{"".join(rows)}</table>'


def _row(name: str, cells: Sequence[str]) -> str:
    heading = f'<th style="text-align:left;padding-right:12px">{escape(name)}</th>'
    return f"<tr>{heading}{''.join(cells)}</tr>"


def _heading(slot: str) -> str:
    return f'<td style="{CELL}opacity:.6">{escape(slot)}</td>'


def _cell(symbol: str | None, *, held: bool = False, title: str = "") -> str:
    if symbol is None:
        return f'<td style="{CELL}opacity:.4">·</td>'
    color = SUPPORT_COLORS.get(symbol, CONFLICT)
    told = SUPPORT_NAMES.get(symbol, "conflict") + (f", {title.lstrip('~ ')}" if held else "")
    hatched = HATCHED if held else ""
    return (
        f'<td title="{escape(told)}" style="{CELL}background-color:{color};{hatched}'
        f'color:{INK};font-weight:600">{"–" if symbol == "-" else escape(symbol)}</td>'
    )
