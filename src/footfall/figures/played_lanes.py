"""What was played when, as bands over a time axis: the rows of figures 13 and 14."""

from __future__ import annotations

from footfall.figures.strip import TimeAxis, draw_band
from footfall.support import Support
from footfall.view.lanes import ActionLane, Timeline
from footfall.view.svg import Picture
from footfall.view.timeline import HELD, runs

__all__ = ["draw_lane", "draw_mark", "draw_result", "longest_stretch"]


def draw_lane(
    picture: Picture, axis: TimeAxis, lane: ActionLane, top: float, height: float
) -> None:
    """Draw the phases of an action as they were played; those that were held are hatched."""
    phases = [(Support.from_symbol(p.symbol), p.start, p.end) for p in lane.phases]
    draw_band(picture, axis, phases, top, height)
    for phase in lane.phases:
        left, right = axis.x(phase.start), axis.x(phase.end)
        if phase.stretch >= HELD and right - left > 0.5:
            fill = f"url(#{picture.name}-held)"
            picture.rectangle(left, top, right - left, height, fill=fill)


def draw_result(
    picture: Picture, axis: TimeAxis, timeline: Timeline, top: float, height: float
) -> None:
    """Draw what the blend stands on."""
    phases = [
        (Support.from_symbol(symbol), first / timeline.fps, last / timeline.fps)
        for symbol, first, last in runs(timeline.supports)
    ]
    draw_band(picture, axis, phases, top, height)


def draw_mark(picture: Picture, x: float, y: float, *, stop: bool = False) -> None:
    """Draw the sign of a start command, its point down on a lane, or of a stop."""
    if stop:
        picture.rectangle(x - 5, y - 11, 10, 10, class_="ink")
    else:
        picture.area([(x - 6, y - 10), (x + 6, y - 10), (x, y)], class_="ink")


def longest_stretch(lane: ActionLane, axis: TimeAxis) -> float:
    """Return the greatest stretch of an action's phases that lie wholly on the axis."""
    inside = [p for p in lane.phases if axis.start <= p.start and p.end <= axis.end]
    return max((phase.stretch for phase in inside), default=1.0)
