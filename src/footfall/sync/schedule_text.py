"""A schedule with everything that was decided in it, as text.

Under the phases of each action stands how many times as long as at its own speed each of them
lasts; in brackets is what plays beside the schedule, and `w` is where a start waits.

    slot         0     1     2     3
    seconds      .4    .16   .34   .16
    walk   0.7   R     D     L     D
                 ×1    ×1.6  ×.85  ×1.6
    hop    0.3   w     L     -     L
                       ×.53  ×1.7  ×.53
    blend        R     L     -     L
    slot 0: 'hop' waits: L of 'hop' conflicts with R of 'walk'
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from footfall.sync.schedule import Schedule, ScheduleRow

__all__ = ["schedule_text"]

CELL = 6
"""Characters a slot takes in print."""


def schedule_text(schedule: Schedule, slots: Sequence[str]) -> str:
    """Return phases, seconds, stretches, who is muted and what waits, and why.

    Args:
        schedule: The schedule.
        slots: The heading of each column.
    """
    seconds = [_number(one) for one in schedule.durations]
    lines = [("slot", "", slots), ("seconds", "", seconds)]
    for row in schedule.rows:
        lines.append((row.name, f"{row.priority:g}", _cells(row)))
        lines.append(("", "", [_number(one, "×") for one in row.stretches]))
    lines.append(("blend", "", [result.symbol for result in schedule.results]))
    name_wide = max(len(name) for name, _, _ in lines)
    rank_wide = max(len(rank) for _, rank, _ in lines)
    table = [
        f"{name:{name_wide}}  {rank:{rank_wide}}  "
        f"{''.join(f'{cell:{CELL}}' for cell in cells)}".rstrip()
        for name, rank, cells in lines
    ]
    return "\n".join([*table, *_waits(schedule, slots)])


def _cells(row: ScheduleRow) -> list[str]:
    cells: list[str] = []
    for cell, muted, wait in zip(row.cells, row.muted, row.waits, strict=True):
        cells.append("w" if wait else f"({cell})" if muted else cell)
    return cells


def _waits(schedule: Schedule, slots: Sequence[str]) -> list[str]:
    """Return a sentence wherever an action begins to wait, or waits for another reason."""
    sentences: list[str] = []
    for slot, label in enumerate(slots):
        for row in schedule.rows:
            before = row.waits[slot - 1] if slot else ""
            if row.waits[slot] and row.waits[slot] != before:
                sentences.append(f"slot {label}: {row.name!r} {row.waits[slot]}")
    return sentences


def _number(value: float | None, sign: str = "") -> str:
    """Return a number to two digits behind the point, or nothing."""
    if value is None:
        return ""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return sign + (text.removeprefix("0") if text not in ("0", "") else "0")
