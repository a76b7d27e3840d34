"""The methods side by side, as plain text."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from footfall.report.spreads import Spread
from footfall.report.summary import MethodReport

__all__ = ["METHODS", "text_table"]

METHODS = (
    "cross-fade",
    "equal-cycles",
    "marker-leader",
    "paper",
    "no-footprints",
    "footfall",
)
"""The methods that are compared, in the order of the table (measures, section 3)."""

HEADINGS = (
    ("", "slip", "slip", "slip", "excess", "excess", "drift", "mismatch", "pops"),
    ("method", "alone", "transitions", "mixes", "transitions", "mixes", "all spans", "", "ratio"),
)

LEGEND = (
    "slip, excess and drift: median / p95 over support spans in mm, without 67 ms at each end; "
    "pops: acceleration p99.9 over that of the clips; - where there is nothing to measure"
)

GAP = "  "


def text_table(reports: Mapping[str, MethodReport]) -> str:
    """Lay out the reports of several methods, one a line.

    Args:
        reports: The report of each method by its name.

    Returns:
        The table: first the methods of `METHODS` in their order, then the others in the order
        of the mapping; under it a legend.
    """
    names = [name for name in METHODS if name in reports]
    names += [name for name in reports if name not in METHODS]
    rows = [*HEADINGS, *(_cells(name, reports[name]) for name in names)]
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    return "\n".join([*(_line(row, widths) for row in rows), LEGEND])


def _line(row: Sequence[str], widths: Sequence[int]) -> str:
    first = row[0].ljust(widths[0])
    others = [cell.rjust(width) for cell, width in zip(row[1:], widths[1:], strict=True)]
    return GAP.join([first, *others]).rstrip()


def _cells(name: str, report: MethodReport) -> tuple[str, ...]:
    mismatch = None if report.mismatch is None else report.mismatch.overall
    ratios = report.pop_ratios
    return (
        name,
        _spread(report.slip.alone),
        _spread(report.slip.transitions),
        _spread(report.slip.mixes),
        _spread(report.excess.transitions),
        _spread(report.excess.mixes),
        _spread(report.drift.overall),
        "-" if mismatch is None else f"{100.0 * mismatch:.1f} %",
        "-" if ratios is None else f"{ratios.acceleration_p999:.2f}",
    )


def _spread(spread: Spread) -> str:
    if spread.median is None or spread.p95 is None:
        return "-"
    return f"{spread.median:.1f} / {spread.p95:.1f}"
