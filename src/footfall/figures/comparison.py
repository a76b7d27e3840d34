"""Figure 17: the same locomotions without and with synchronization."""

from __future__ import annotations

from functools import lru_cache

from footfall.figures.cast import Cast
from footfall.figures.figure import LEFT, TOP, Figure, begin_sheet
from footfall.figures.performing import Cues, perform_cues
from footfall.figures.way import Way, draw_figures, draw_slides, every
from footfall.report import MethodReport, Track, measure, performance_trace
from footfall.scenario.performance import Performance
from footfall.view.palette import SLIP
from footfall.view.svg import Picture

__all__ = [
    "comparison_figure",
    "comparison_performances",
    "draw_transition_legend",
    "slip_sentence",
]

CLAIM = (
    "The first row shows the animation without synchronization. When there are transitions between "
    "motions (in red) the feet are sliding on the floor. With synchronization (second row), the "
    "foot strikes are respected."
)
CUES: Cues = (
    (0.0, "start", "walk"),
    (1.73, "start", "fast walk"),
    (2.21, "stop", "walk"),
    (3.37, "start", "run"),
    (3.94, "stop", "fast walk"),
    (5.18, "start", "walk"),
    (5.63, "stop", "run"),
)
DURATION = 6.9
EVERY = 0.2
"""Between two figures [s]."""

ELLIPSES = 3
"""As in the paper."""


@lru_cache(maxsize=2)
def comparison_performances(cast: Cast) -> tuple[Performance, Performance]:
    """Return the cues performed without and with synchronization."""
    ranks, fades = {"run": 2.0}, {"run": 0.4}
    return (
        perform_cues(
            cast, CUES, DURATION, priorities=ranks, fades=fades, synchronized=False,
            footprints=False,
        ),
        perform_cues(cast, CUES, DURATION, priorities=ranks, fades=fades),
    )  # fmt: skip


def comparison_figure(cast: Cast) -> Figure:
    """Draw both rows."""
    performances = comparison_performances(cast)
    traces = [performance_trace(performance) for performance in performances]
    title = "The same locomotions without and with synchronization"
    note = (
        "Walk, fast walk, run and walk, started and stopped at the same moments; "
        f"a figure every {EVERY:g} s"
    )
    way = Way.of(traces)
    panel = way.height + 96.0
    picture = begin_sheet(17, title, note, TOP + 2 * panel + 6.0)
    draw_transition_legend(picture, 900.0)
    parents = performances[0].recording.skeleton.parents
    facts: list[str] = []
    for row, (name, trace) in enumerate(
        zip(("Without synchronization", "With synchronization"), traces, strict=True)
    ):
        base = TOP + (row + 1) * panel - 46.0
        picture.words(LEFT, base - way.height - 16, name, size=16, font_weight="600")
        draw_figures(
            picture, way, trace, parents, base, every(EVERY, Track.from_trace(trace).frames)
        )
        draw_slides(picture, way, trace, base, ELLIPSES)
        facts.append(slip_sentence(name, measure(trace)))
    return Figure(17, "comparison", title, CLAIM, tuple(facts), picture.to_svg())


def draw_transition_legend(picture: Picture, x: float) -> None:
    """Say what red figures and ellipses are."""
    picture.line(x, 31, x + 26, 31, stroke=SLIP, stroke_width=3, stroke_linecap="round")
    picture.words(x + 34, 36, "in transition", size=14, class_="soft")
    picture.add("ellipse", cx=x + 158, cy=31, rx=15, ry=8, fill="none", stroke=SLIP, stroke_width=2)
    picture.words(x + 182, 36, "feet slide", size=14, class_="soft")


def slip_sentence(name: str, report: MethodReport) -> str:
    """Say how far planted feet slip."""
    moved, all_spans = report.slip.transitions, report.slip.overall
    if moved.p95 is None or moved.maximum is None or all_spans.median is None:
        return f"{name}: no support span is long enough to be measured."
    return (
        f"{name}: planted feet slip {all_spans.median:.1f} mm in the median; in transitions "
        f"95 % of them at most {moved.p95:.0f} mm, the worst {moved.maximum:.0f} mm."
    )
