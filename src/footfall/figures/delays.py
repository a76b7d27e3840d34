"""Figure 18: walking, fighting, walking and a jump: some starts are delayed."""

from __future__ import annotations

from functools import lru_cache

from footfall.figures.arrows import draw_arrow
from footfall.figures.cast import Cast
from footfall.figures.comparison import draw_transition_legend, slip_sentence
from footfall.figures.figure import LEFT, TOP, Figure, begin_sheet
from footfall.figures.performing import Cues, perform_cues
from footfall.figures.silhouettes import Silhouettes
from footfall.figures.way import Way, apart, draw_figures, draw_slides
from footfall.report import RATE, Trace, Track, measure, performance_trace
from footfall.scenario.performance import Performance
from footfall.view.svg import Picture
from footfall.view.text_width import text_width

__all__ = ["delays_figure", "delays_performances"]

CLAIM = (
    "This animation with motions such as walking, fighting, another walking and a jump shows "
    "delayed actions. Contrary to the first row, the two others show the animation with "
    "synchronization."
)
CUES: Cues = (
    (0.0, "start", "walk"),
    (1.87, "start", "kick"),
    (2.25, "stop", "walk"),
    (3.11, "start", "fast walk"),
    (3.95, "stop", "kick"),
    (6.69, "start", "jump"),
    (7.1, "stop", "fast walk"),
)
DURATION = 9.0
APART, ON_THE_SPOT = (0.22, 0.44), 0.45
"""Between two figures, drawn as sticks or as a skin [m], and of a body on the spot [s]."""

ROWS = (
    "Without synchronization",
    "Synchronized by the paper’s rule",
    "Synchronized by footfall’s planner, on a skinned character",
)


@lru_cache(maxsize=2)
def delays_performances(cast: Cast) -> tuple[Performance, Performance, Performance]:
    """Return the cues performed without synchronization, by the paper's rule, and by ours."""
    ranks = {"kick": 3.0, "jump": 3.0}
    return (
        perform_cues(cast, CUES, DURATION, priorities=ranks, synchronized=False, footprints=False),
        perform_cues(cast, CUES, DURATION, priorities=ranks, planner="paper"),
        perform_cues(cast, CUES, DURATION, priorities=ranks),
    )


def delays_figure(cast: Cast) -> Figure:
    """Draw the three rows."""
    performances = delays_performances(cast)
    traces = [performance_trace(performance) for performance in performances]
    title = "Walking, fighting, walking, and a jump: delayed actions"
    note = "Marks under the rows: where each action was commanded, and what waited for how long"
    way = Way.of(traces, tallest=240.0)
    panel = way.height + 110.0
    picture = begin_sheet(18, title, note, TOP + 3 * panel)
    draw_transition_legend(picture, 900.0)
    skeleton = performances[0].recording.skeleton
    facts: list[str] = []
    for row, (name, performance, trace) in enumerate(zip(ROWS, performances, traces, strict=True)):
        base = TOP + (row + 1) * panel - 60.0
        picture.words(LEFT, base - way.height - 6, name, size=16, font_weight="600")
        frames = apart(way, trace, APART[row == 2], ON_THE_SPOT)
        sticks = frames if row < 2 else ()
        draw_figures(picture, way, trace, skeleton.parents, base, sticks)
        if row == 2:
            silhouettes = Silhouettes(trace, skeleton, way, base)
            for frame in frames:
                silhouettes.draw(picture, frame)
        facts.append(slip_sentence(name, measure(trace)))
        if row == 0:
            draw_slides(picture, way, trace, base, 3)
        else:
            _draw_delays(picture, way, performance, trace, base)
            facts.append(f"{name}: {'; '.join(_told(performance))}.")
    return Figure(18, "delays", title, CLAIM, tuple(facts), picture.to_svg())


def _told(performance: Performance) -> list[str]:
    told: list[str] = []
    for start in performance.starts:
        if start.actual is None:
            told.append(f"{start.action} never")
            continue
        delay = start.actual - start.commanded
        told.append(f"{start.action} {'at once' if delay < 1e-6 else f'after {delay:.2f} s'}")
    return told


def _draw_delays(
    picture: Picture, way: Way, performance: Performance, trace: Trace, base: float
) -> None:
    """Draw an arrow from where each action was commanded to where it started."""
    along = way.stage.along(Track.from_trace(trace).joints[:, 0])
    free = -1.0
    for start in performance.starts:
        actual = start.commanded if start.actual is None else start.actual
        commanded, began = (
            way.x(float(along[min(round(time * RATE), len(along) - 1)]))
            for time in (start.commanded, actual)
        )
        y = base + 12
        picture.line(commanded, base + 3, commanded, y + 6, class_="pen", stroke_width=2.2)
        if began - commanded > 2.0:
            draw_arrow(picture, (commanded, y), (max(began, commanded + 12.0), y), width=2.2)
        delay = actual - start.commanded
        told = start.action if delay < 1e-6 else f"{start.action} +{delay:.2f} s"
        lower = commanded < free
        picture.words(commanded, y + (38 if lower else 21), told, size=14, font_weight="600")
        if not lower:
            free = commanded + text_width(told, 14, bold=True) + 8.0
