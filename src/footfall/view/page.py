"""The demo page: two players side by side, the schedule, the foot traces, and the figures.

One file that works from a disk without a network; style and script are files of their own in
the package and are put into it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from importlib import resources
from pathlib import Path
from string import Template

from footfall.errors import ArgumentError
from footfall.io.atomic import write_atomically
from footfall.report import METHODS, GroupedSpread, MethodReport, Spread, Trace
from footfall.skeleton import Skeleton
from footfall.view.foot_traces import foot_traces_svg
from footfall.view.lanes import Timeline
from footfall.view.page_data import player_json
from footfall.view.strip import strip_svg
from footfall.view.timeline import timeline_svg

__all__ = ["DemoPage", "demo_page_html", "write_demo_page"]

_SCRIPTS = ("takes.js", "drawing.js", "figure.js", "player.js")
"""Joined into one module, in the order in which they use each other."""

_METHOD_NAMES = {
    "cross-fade": "Plain cross-fade",
    "paper": "The paper's rule",
    "no-footprints": "footfall, without footprints",
    "footfall": "footfall",
}


@dataclass(frozen=True, eq=False)
class DemoPage:
    """What the page shows.

    Raises:
        ArgumentError: If there are no takes.
    """

    title: str
    """Its heading."""

    introduction: str
    """A sentence or two under it."""

    takes: tuple[tuple[str, Trace], ...]
    """A title and a motion a player, all of one body: first the one without, then the one
    with synchronization."""

    skeleton: Skeleton
    """The body of all takes."""

    timeline: Timeline
    """The schedule of the last take."""

    reports: Mapping[str, MethodReport]
    """The figures of each method by its name."""

    def __post_init__(self) -> None:
        if not self.takes:
            raise ArgumentError("a page without takes; give at least one title and motion")


def write_demo_page(path: Path, page: DemoPage) -> None:
    """Write a self-contained page.

    Args:
        path: The .html file; replaced if it exists.
        page: What it shows.

    Raises:
        FileFormatError: If the file cannot be written.
    """
    write_atomically(path, demo_page_html(page).encode())


def demo_page_html(page: DemoPage) -> str:
    """Return the text of the page."""
    return Template(_resource("page.html")).substitute(
        title=escape(page.title),
        introduction=escape(page.introduction),
        style=_resource("page.css"),
        players="".join(_player(index, title) for index, (title, _) in enumerate(page.takes)),
        timeline=timeline_svg(page.timeline),
        traces=foot_traces_svg(page.takes),
        strip=strip_svg(page.takes, page.skeleton.parents),
        table=_table(page.reports),
        data=player_json(page.takes, page.skeleton, page.timeline),
        script="\n".join(_resource(name) for name in _SCRIPTS),
    )


def _resource(name: str) -> str:
    return resources.files("footfall.view").joinpath(name).read_text(encoding="utf-8")


def _player(index: int, title: str) -> str:
    return (
        f'<figure class="player" data-take="{index}">'
        f'<figcaption><span class="name">{escape(title)}</span>'
        '<span class="slip"></span></figcaption>'
        f'<canvas tabindex="0" aria-label="{escape(title)}: drag to look around"></canvas>'
        '<div class="badges"><b class="foot left">L</b><b class="foot right">R</b></div>'
        "</figure>\n"
    )


def _table(reports: Mapping[str, MethodReport]) -> str:
    names = [name for name in METHODS if name in reports]
    names += [name for name in reports if name not in METHODS]
    return "\n".join(_row(name, reports[name]) for name in names)


def _row(name: str, report: MethodReport) -> str:
    mismatch = None if report.mismatch is None else report.mismatch.overall
    ratios = report.pop_ratios
    cells = [
        *_group_cells(report.slip),
        *_spread_cells(report.drift.overall),
        "–" if mismatch is None else f"{100.0 * mismatch:.1f}",
        "–" if ratios is None else f"{ratios.acceleration_p999:.2f}",
    ]
    label = escape(_METHOD_NAMES.get(name, name))
    own = ' class="own"' if name == "footfall" else ""
    return f"<tr{own}><th>{label}</th>" + "".join(f"<td>{c}</td>" for c in cells) + "</tr>"


def _group_cells(spreads: GroupedSpread) -> list[str]:
    groups: Sequence[Spread] = (spreads.alone, spreads.transitions, spreads.mixes)
    return [cell for spread in groups for cell in _spread_cells(spread)]


def _spread_cells(spread: Spread) -> list[str]:
    values = (spread.median, spread.p95, spread.maximum)
    return ["–" if value is None else _millimeters(value) for value in values]


def _millimeters(value: float) -> str:
    return f"{value:.1f}" if value < 9.95 else f"{value:.0f}"
