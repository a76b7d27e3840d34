"""Figure 13: handball shots synchronized with a run."""

from __future__ import annotations

from footfall.figures.cast import Cast
from footfall.figures.cells import define_hatching
from footfall.figures.figure import LEFT, TOP, WIDTH, Figure, begin_sheet
from footfall.figures.performing import Cues, perform_cues
from footfall.figures.played_lanes import draw_lane, draw_mark, draw_result, longest_stretch
from footfall.figures.strip import TimeAxis, draw_poses
from footfall.report import performance_trace
from footfall.scenario.performance import Performance
from footfall.view import performance_timeline
from footfall.view.svg import Picture

__all__ = ["shots_figure"]

CLAIM = "Synchronization sequences with handball shots."
ASKED = (1.43, 1.62, 1.8, 1.98)
"""When the shot is commanded in each example: at different phases of the run [s]."""

BEFORE, AFTER = 0.15, 1.75
"""What is shown around the command [s]."""

BAND = 24.0
PANEL = 236.0
POSES = 12


def shots_figure(cast: Cast) -> Figure:
    """Draw what becomes of a shot that is commanded at different phases of a run."""
    title = "Handball shots synchronized with a run"
    note = (
        "The same shot commanded at four moments of the run (triangle); "
        "hatched: phases made to last 1.2 times as long as in the clip, or longer"
    )
    picture = begin_sheet(13, title, note, TOP + PANEL * len(ASKED) + 8.0)
    define_hatching(picture)
    facts: list[str] = []
    for row, asked in enumerate(ASKED):
        cues: Cues = ((0.0, "start", "run"), (asked, "start", "shot"))
        performance = perform_cues(cast, cues, asked + AFTER + 0.1, priorities={"shot": 2.0})
        facts.append(_draw_row(picture, performance, asked, TOP + PANEL * row))
    return Figure(13, "shots", title, CLAIM, tuple(facts), picture.to_svg())


def _draw_row(picture: Picture, performance: Performance, asked: float, top: float) -> str:
    """Draw one example, and say in a sentence what became of it."""
    axis = TimeAxis(LEFT + 84.0, WIDTH - LEFT - 26.0, BEFORE + AFTER, asked - BEFORE)
    trace = performance_trace(performance)
    parents = performance.recording.skeleton.parents
    times = [axis.start + axis.duration * (index + 0.5) / POSES for index in range(POSES)]
    draw_poses(picture, trace, parents, axis, top + 122.0, times, tallest=112.0)
    timeline = performance_timeline(performance)
    bands = top + 138.0
    for lane_row, lane in enumerate(timeline.lanes):
        y = bands + lane_row * (BAND + 3)
        picture.words(LEFT, y + 17, lane.name, size=15, font_weight="600")
        draw_lane(picture, axis, lane, y, BAND)
    y = bands + 2 * (BAND + 3) + 3
    picture.words(LEFT, y + 17, "result", size=15, class_="soft")
    draw_result(picture, axis, timeline, y, BAND)
    draw_mark(picture, axis.x(asked), bands - 1)
    start = performance.starts[-1]
    if start.actual is None:
        return f"Commanded at {asked:.2f} s: never started: {start.reason}."
    delay = start.actual - start.commanded
    stretches = ", ".join(
        f"the {lane.name} up to {longest_stretch(lane, axis):.2f} times" for lane in timeline.lanes
    )
    when = "at once" if delay < 1e-6 else f"after {delay:.2f} s"
    return f"Commanded at {asked:.2f} s: started {when}; phases stretched: {stretches}."
