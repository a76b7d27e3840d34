"""Figure 7: one index k runs through all actions, whenever each of them was started."""

from __future__ import annotations

from footfall.figures.arrows import draw_arrow
from footfall.figures.cast import Cast
from footfall.figures.cells import Grid, define_hatching
from footfall.figures.figure import TOP, Figure, begin_sheet
from footfall.support import Support
from footfall.sync import Synchronizer
from footfall.sync.schedule import Schedule
from footfall.view.svg import Picture

__all__ = ["indices_figure"]

CLAIM = (
    "Change of variable for the indices. All the current sequences are indexed by k (bottom of "
    "figure) whenever the corresponding actions were started (top of figure)."
)
ROLES = ("walk", "fast walk", "jump")
STARTS = (0, 1, 3)
"""The slot in which each action is started."""

NOW, LAST = 4, 7
"""The present slot, k, and the last one that is shown."""

_SUBSCRIPTS = "₁₂₃"


def indices_figure(cast: Cast) -> Figure:
    """Draw three actions under their own indices, and the same under the index k."""
    title = "Change of variable for the indices"
    note = (
        "Top: each action counts its own phases, from its own start. "
        "Bottom: all of them under the index of the slot that is played"
    )
    synchronizer = Synchronizer(
        [cast.motion(role).supports for role in ROLES],
        names=ROLES,
        planner="paper",
        lookahead=LAST - NOW,
    )
    for slot in range(NOW + 1):
        for action in range(len(ROLES)):
            if STARTS[action] == slot:
                synchronizer.start(action)
        if slot < NOW:
            synchronizer.next_slot()
    picture = begin_sheet(7, title, note, 636.0)
    define_hatching(picture)
    trace, coming = synchronizer.trace, synchronizer.schedule
    counts = _counts(trace, coming)
    top = Grid(196.0, TOP + 4.0, 120.0, 62.0)
    _draw_rows(picture, top, counts, trace, coming, primed=False)
    _draw_change(picture, top)
    bottom = Grid(top.left, top.top + 3 * top.height + 96.0, top.width, top.height)
    _draw_rows(picture, bottom, counts, trace, coming, primed=True)
    _mark_present(picture, bottom)
    started = [
        next(slot for slot, support in enumerate(row.supports) if support is not None)
        for row in trace.rows
    ]
    facts = tuple(
        f"{role}: started in slot {slot}; at k it plays its phase {counts[action][NOW]}."
        for action, (role, slot) in enumerate(zip(ROLES, started, strict=True))
    )
    return Figure(7, "indices", title, CLAIM, facts, picture.to_svg())


def _counts(trace: Schedule, coming: Schedule) -> list[list[int]]:
    """Return which of its own phases, from 1, each action plays in each slot; 0 before it."""
    rows: list[list[int]] = []
    for supports, held in _whole_rows(trace, coming):
        count, counts = 0, list[int]()
        for support, held_here in zip(supports, held, strict=True):
            count += support is not None and not held_here
            counts.append(count)
        rows.append(counts)
    return rows


def _whole_rows(trace: Schedule, coming: Schedule) -> list[tuple[list[Support | None], list[bool]]]:
    """Return what each action stands on from slot 0 to the last decided one, and where it is held.

    One that has left the schedule stands on nothing.
    """
    left = ([None] * LAST, [False] * LAST)
    later = {row.name: (list(row.supports[1:]), list(row.held[1:])) for row in coming.rows}
    rows: list[tuple[list[Support | None], list[bool]]] = []
    for row in trace.rows:
        supports, held = later.get(row.name, left)
        rows.append(([*row.supports, *supports[: LAST - NOW]], [*row.held, *held[: LAST - NOW]]))
    return rows


def _draw_rows(
    picture: Picture,
    grid: Grid,
    counts: list[list[int]],
    trace: Schedule,
    coming: Schedule,
    *,
    primed: bool,
) -> None:
    for row, (supports, held) in enumerate(_whole_rows(trace, coming)):
        name = f"S{'′' if primed else ''}{_SUBSCRIPTS[row]}"
        grid.row_name(picture, row, name, remark=ROLES[row])
        for slot, support in enumerate(supports):
            if support is None or (primed and slot < NOW - 1):
                continue
            ahead = slot - NOW
            index = f"k{ahead:+d}".replace("-", "−") if ahead else "k"
            label = f"{name}({index if primed else counts[row][slot]})"
            grid.cell(picture, slot, row, support, label=label, held=held[slot])


def _draw_change(picture: Picture, grid: Grid) -> None:
    x = grid.middle(NOW, 0)[0]
    top = grid.top + 3 * grid.height
    draw_arrow(picture, (x, top + 8), (x, top + 78))
    picture.words(x + 18, top + 48, "change of indices", size=15, class_="soft")


def _mark_present(picture: Picture, grid: Grid) -> None:
    """Draw a frame around the column k."""
    x, y = grid.left + NOW * grid.width - 5.0, grid.top - 6.0
    width, height = grid.width + 10.0 - grid.gap, 3 * grid.height + 12.0 - grid.gap
    picture.rectangle(x, y, width, height, rx=8, fill="none", class_="pen", stroke_width=2)
    middle = grid.middle(NOW, 0)[0]
    picture.words(
        middle, y + height + 24, "now playing: k", size=15, text_anchor="middle", font_weight="600"
    )
