"""Figure 9: the same two sequences, once with either of them prior."""

from __future__ import annotations

from footfall.figures.cells import Grid, define_hatching
from footfall.figures.figure import TOP, Figure, begin_sheet
from footfall.support import Support, SupportSequence
from footfall.sync import Synchronizer
from footfall.sync.schedule import Schedule
from footfall.view.svg import Picture

__all__ = ["priorities_figure"]

CLAIM = (
    "Example of synchronization using priorities. The resulting support phase respects the action "
    "with the highest priority."
)
SEQUENCES = ("D R D L*", "D L D R*")
"""Two walks, half a cycle apart."""

NAMES = ("A₁", "A₂")
COLUMNS = 7


def priorities_figure() -> Figure:
    """Draw both sequences without synchronization, and with either of them prior."""
    title = "Synchronization using priorities"
    note = (
        "Two walks half a cycle apart, planner “paper”; hatched: extended elements. "
        "The result has every RS and LS of the action with the higher priority"
    )
    picture = begin_sheet(9, title, note, 716.0)
    define_hatching(picture)
    sequences = [SupportSequence.parse(text) for text in SEQUENCES]
    plain = [[sequence.at(k).support for k in range(COLUMNS)] for sequence in sequences]
    grid = Grid(272.0, TOP + 6.0, 126.0, 52.0)
    for column in range(COLUMNS):
        grid.heading(picture, column, 0, f"k+{column}" if column else "k")
    results = [a & b for a, b in zip(*plain, strict=True)]
    _draw(picture, grid, 1.0, "not synchronized", plain, [[False] * COLUMNS] * 2, results)
    facts: list[str] = [f"Not synchronized: {results.count(Support.CONFLICT)} columns are Err."]
    for place, leader in enumerate((0, 1)):
        trace = _played(sequences, leader)
        rows = [[s for s in row.supports if s is not None] for row in trace.rows]
        held = [list(row.held) for row in trace.rows]
        told = f"{NAMES[leader]} has priority"
        _draw(picture, grid, 4.8 + 3.8 * place, told, rows, held, list(trace.results))
        words = " ".join(one.symbol for one in trace.results)
        facts.append(f"{NAMES[leader]} prior: {words}; it is extended {sum(held[leader])} times.")
    return Figure(9, "priorities", title, CLAIM, tuple(facts), picture.to_svg())


def _played(sequences: list[SupportSequence], leader: int) -> Schedule:
    ranks = [2.0, 1.0] if leader == 0 else [1.0, 2.0]
    synchronizer = Synchronizer(sequences, ranks, planner="paper", names=NAMES)
    for action in (leader, 1 - leader):
        synchronizer.start(action)
    for _ in range(COLUMNS - 1):
        synchronizer.next_slot()
    return synchronizer.trace


def _draw(
    picture: Picture,
    grid: Grid,
    first: float,
    told: str,
    rows: list[list[Support]],
    held: list[list[bool]],
    results: list[Support],
) -> None:
    for row, name in enumerate(NAMES):
        grid.row_name(picture, first + row, name)
        for column, support in enumerate(rows[row]):
            grid.cell(picture, column, first + row, support, held=held[row][column])
    picture.words(24, grid.middle(0, first + 0.5)[1] + 5, told, size=15, class_="soft")
    y = grid.top + (first + 2) * grid.height + 2.0
    right = grid.left + COLUMNS * grid.width - grid.gap
    picture.line(24, y, right, y, class_="softpen", stroke_width=1.4)
    grid.row_name(picture, first + 2.16, "result ⊕")
    for column, support in enumerate(results):
        grid.cell(picture, column, first + 2.16, support)
