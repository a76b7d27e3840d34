"""The page of an archive: how much its feet slip, what failed, and the worst files first."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from importlib import resources
from string import Template

from footfall.datasets.clip_annotation import ClipAnnotation
from footfall.datasets.histogram import histogram_svg
from footfall.report import Spread
from footfall.support import SupportSequence
from footfall.view.palette import SUPPORT_COLORS, SUPPORT_NAMES

__all__ = ["summary_page", "worst_first"]

MOST_ROWS = 500
"""Files that are shown; the table holds them all."""

MOST_PHASES = 200
"""Phases of a motion that are drawn: more could not be told apart."""


def worst_first(rows: Sequence[ClipAnnotation]) -> list[ClipAnnotation]:
    """Return the rows of the usable files, those that slip most on top."""

    def slip(row: ClipAnnotation) -> tuple[float, str]:
        return (-1.0 if row.slip_p95_mm is None else row.slip_p95_mm), row.file

    return sorted((row for row in rows if row.error is None), key=slip, reverse=True)


def summary_page(rows: Sequence[ClipAnnotation], name: str) -> str:
    """Return a self-contained page.

    Args:
        rows: The rows of all files.
        name: What the archive is called.
    """
    usable = worst_first(rows)
    failed = [row for row in rows if row.error is not None]
    slips = [row.slip_p95_mm for row in usable if row.slip_p95_mm is not None]
    return Template(_resource("page.html")).substitute(
        title=f"Supports of {escape(name)}",
        style=_resource("page.css"),
        tiles=_tiles(rows, usable, slips),
        histogram=histogram_svg(slips, "95th percentile of a file's slip [mm]"),
        failures=_failures(failed),
        shown=_shown(len(usable)),
        legend="".join(
            f'<span><i style="background:{color}"></i>{escape(SUPPORT_NAMES[symbol])}</span>'
            for symbol, color in SUPPORT_COLORS.items()
        ),
        rows="\n".join(_row(row) for row in usable[:MOST_ROWS]),
    )


def _resource(name: str) -> str:
    return resources.files("footfall.datasets").joinpath(name).read_text(encoding="utf-8")


def _tiles(
    rows: Sequence[ClipAnnotation], usable: Sequence[ClipAnnotation], slips: Sequence[float]
) -> str:
    seconds = sum(row.seconds or 0.0 for row in usable)
    spread = Spread.of(slips)
    facts = {
        "files": f"{len(rows):,}",
        "not usable": f"{len(rows) - len(usable):,}",
        "motion": _duration(seconds),
        "median file, slip p95": _millimeters(spread.median, " mm"),
        "worst file, slip p95": _millimeters(spread.maximum, " mm"),
    }
    return "".join(f"<div><dt>{name}</dt><dd>{fact}</dd></div>" for name, fact in facts.items())


def _duration(seconds: float) -> str:
    if seconds < 120.0:
        return f"{seconds:.0f} s"
    return f"{seconds / 60.0:.0f} min" if seconds < 7200.0 else f"{seconds / 3600.0:.1f} h"


def _millimeters(value: float | None, unit: str = "") -> str:
    return (
        "–" if value is None else f"{value:.1f}{unit}" if value < 99.95 else f"{value:,.0f}{unit}"
    )


def _failures(failed: Sequence[ClipAnnotation]) -> str:
    if not failed:
        return ""
    rows = "\n".join(
        f"<tr><td>{escape(row.file)}</td><td>{escape(row.error or '')}</td></tr>"
        for row in failed[:MOST_ROWS]
    )
    more = len(failed) - MOST_ROWS
    rest = f'<p class="note">and {more:,} more, in the table</p>' if more > 0 else ""
    return (
        f'<section class="failures"><h2>Not usable: {len(failed):,}</h2><div class="scroll"><table>'
        f"<tbody>\n{rows}\n</tbody></table></div>{rest}</section>"
    )


def _shown(count: int) -> str:
    order = "Ordered by the 95th percentile of the slip."
    if count <= MOST_ROWS:
        return order
    return f"{order} The worst {MOST_ROWS} of {count:,} are shown; the table holds all."


def _row(row: ClipAnnotation) -> str:
    cells = [
        f"{row.seconds or 0.0:.1f}",
        str(row.spans),
        *(
            _millimeters(value)
            for value in (row.slip_p95_mm, row.slip_median_mm, row.slip_max_mm, row.drift_max_mm)
        ),
    ]
    numbers = "".join(f"<td>{cell}</td>" for cell in cells)
    supports = escape(row.supports or "", quote=True)
    return (
        f'<tr><td>{escape(row.file)}</td><td class="strip"><div title="{supports[:400]}">'
        f"{_strip(row.supports or '')}</div></td>{numbers}</tr>"
    )


def _strip(supports: str) -> str:
    """Return the phases as colored bars, as long as they last."""
    phases = SupportSequence.parse(supports).phases[:MOST_PHASES]
    return "".join(
        f'<i style="flex-grow:{phase.duration:.3f};'
        f'background:{SUPPORT_COLORS[phase.support.symbol]}"></i>'
        for phase in phases
    )
