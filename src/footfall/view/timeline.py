"""The schedule as lanes: what played when, in which support, with how much weight."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from footfall.view.lanes import ActionLane, CueMark, LanePhase, Timeline
from footfall.view.palette import SUPPORT_COLORS, SUPPORT_NAMES, readable_symbol
from footfall.view.svg import Picture, points_text
from footfall.view.text_width import shortened, text_width

__all__ = ["runs", "timeline_svg"]

WIDTH = 1200.0
LEFT, WIDEST_LEFT, RIGHT = 132.0, 300.0, 24.0
NAME = 14.0
"""Size of the lanes' names [pixels]."""

TOP = 58.0
LANE = 46.0
GAP = 16.0
LEGEND = 172.0
BAR = 34.0

_ON_COLOR = "#10151a"
"""Letters on the colors of supports."""

HELD = 1.2
"""A phase that takes this many times its own seconds or more is drawn as held."""


def timeline_svg(timeline: Timeline) -> str:
    """Draw the schedule: a lane an action, the result below, in seconds.

    A bar is as high as its action's weight; hatching marks phases that were made to wait.
    """
    scale = _Scale.of(timeline)
    height = TOP + (len(timeline.lanes) + 1) * (LANE + GAP) + 34.0
    picture = Picture("timeline", "What played when, and on which foot", WIDTH, height)
    picture.words(20, 28, "Schedule", size=17, font_weight="600")
    _hatching(picture)
    _legend(picture)
    _axis(picture, scale, height)
    for row, lane in enumerate(timeline.lanes):
        _draw_lane(picture, scale, lane, TOP + row * (LANE + GAP))
    _draw_result(picture, scale, TOP + len(timeline.lanes) * (LANE + GAP))
    return picture.to_svg(
        duration=f"{timeline.duration:.4f}",
        left=scale.left,
        right=WIDTH - RIGHT,
        top=TOP - 14.0,
        bottom=height - 28.0,
    )


def _hatching(picture: Picture) -> None:
    picture.open(
        "pattern",
        id="timeline-held",
        width=6,
        height=6,
        patternUnits="userSpaceOnUse",
        patternTransform="rotate(45)",
    )
    picture.line(0, 0, 0, 6, stroke=_ON_COLOR, stroke_width=2.4, stroke_opacity=0.5)
    picture.close("pattern")


def _legend(picture: Picture) -> None:
    x = LEGEND
    for symbol, name in SUPPORT_NAMES.items():
        picture.rectangle(x, 16, 18, 14, rx=3, fill=SUPPORT_COLORS[symbol])
        _letter(picture, x + 9, 27, symbol, 11)
        picture.words(x + 25, 27.5, name, class_="soft")
        x += 100.0
    picture.rectangle(x, 16, 18, 14, rx=3, fill=SUPPORT_COLORS["-"])
    picture.rectangle(x, 16, 18, 14, rx=3, fill="url(#timeline-held)")
    picture.words(x + 25, 27.5, "held: made to wait", class_="soft")
    _mark(picture, "start", x + 168, 23)
    picture.words(x + 180, 27.5, "start", class_="soft")
    _mark(picture, "stop", x + 230, 23)
    picture.words(x + 242, 27.5, "stop, and the delay until it comes about", class_="soft")


@dataclass(frozen=True, slots=True)
class _Scale:
    """Where clock times lie."""

    timeline: Timeline
    left: float
    """The x of time 0: the names of the lanes stand before it."""

    @classmethod
    def of(cls, timeline: Timeline) -> _Scale:
        widest = max([text_width(lane.name, NAME, bold=True) for lane in timeline.lanes], default=0)
        return cls(timeline, min(max(LEFT, 20.0 + widest + 16.0), WIDEST_LEFT))

    def at(self, seconds: float) -> float:
        """Return the x of a clock time."""
        share = min(max(seconds / self.timeline.duration, 0.0), 1.0)
        return self.left + share * (WIDTH - self.left - RIGHT)

    def write_name(self, picture: Picture, name: str, y: float) -> None:
        """Write the name of a lane, shortened where there is no room for it."""
        told = shortened(name, self.left - 36.0, NAME, bold=True)
        picture.words(20, y, told, size=NAME, font_weight="600")


def _axis(picture: Picture, scale: _Scale, height: float) -> None:
    timeline = scale.timeline
    step = next((s for s in (0.1, 0.25, 0.5, 1.0, 2.0, 5.0) if timeline.duration / s <= 16), 10.0)
    bottom = height - 28.0
    for tick in range(int(timeline.duration / step + 1e-6) + 1):
        x = scale.at(tick * step)
        picture.line(x, TOP - 14, x, bottom, class_="rule", stroke_width=1)
        label = f"{tick * step:g}" + (" s" if tick == 0 else "")
        picture.words(x, bottom + 17, label, text_anchor="middle", class_="soft")


def _draw_lane(picture: Picture, scale: _Scale, lane: ActionLane, top: float) -> None:
    timeline, base = scale.timeline, top + LANE
    scale.write_name(picture, lane.name, base - 13)
    picture.line(scale.left, base, WIDTH - RIGHT, base, class_="rule", stroke_width=1)
    for phase in lane.phases:
        left, right = scale.at(phase.start), scale.at(phase.end)
        if right - left < 0.05:
            continue
        outline = points_text(_weight_outline(scale, lane, phase, base))
        picture.rectangle(
            left, base - BAR, right - left, BAR, fill=SUPPORT_COLORS[phase.symbol], opacity=0.16
        )
        picture.add("polygon", points=outline, fill=SUPPORT_COLORS[phase.symbol])
        if phase.stretch >= HELD:
            picture.add("polygon", points=outline, fill="url(#timeline-held)")
        picture.line(left, base, left, base - BAR, class_="softpen", stroke_width=0.6)
        if right - left >= 15:
            middle = 0.5 * (phase.start + phase.end) * timeline.fps
            weight = float(np.interp(middle, np.arange(len(lane.weights)), lane.weights))
            fill = _ON_COLOR if weight > 0.4 else None
            _letter(picture, (left + right) / 2, base - 5, phase.symbol, 12, fill)
    for cue in lane.cues:
        _draw_cue(picture, scale, cue, base - BAR - 7)


def _weight_outline(
    scale: _Scale, lane: ActionLane, phase: LanePhase, base: float
) -> list[tuple[float, float]]:
    """Return the outline of a phase whose height follows the weight."""
    timeline = scale.timeline
    frames = np.arange(len(timeline.supports)) / timeline.fps
    inside = frames[(frames > phase.start) & (frames < phase.end)]
    times = np.concatenate([[phase.start], inside, [phase.end]])
    heights = BAR * np.interp(times, frames, lane.weights)
    straight = np.abs(heights[:-2] - 2.0 * heights[1:-1] + heights[2:]) < 1e-3
    kept = np.concatenate([[True], ~straight, [True]])
    top = [
        (scale.at(time), base - height)
        for time, height in zip(times[kept].tolist(), heights[kept].tolist(), strict=True)
    ]
    return [(top[0][0], base), *top, (top[-1][0], base)]


def _letter(
    picture: Picture, x: float, y: float, symbol: str, size: float, fill: str | None = _ON_COLOR
) -> None:
    picture.words(
        x,
        y,
        readable_symbol(symbol),
        size=size,
        text_anchor="middle",
        font_weight="600",
        fill=fill,
        class_=None if fill else "ink",
    )


def _mark(picture: Picture, kind: str, x: float, y: float) -> None:
    if kind == "start":
        picture.area([(x - 4, y - 5), (x - 4, y + 5), (x + 5, y)], class_="ink")
    else:
        picture.rectangle(x - 4, y - 4, 8, 8, class_="ink")


def _draw_cue(picture: Picture, scale: _Scale, cue: CueMark, y: float) -> None:
    """Mark a command, with an arrow to when it came about if that was later."""
    x = scale.at(cue.commanded)
    _mark(picture, cue.kind, x, y)
    if cue.actual is None:
        picture.words(x + 9, y + 4, "never", size=11, class_="soft")
        return
    delay = cue.actual - cue.commanded
    if delay < 0.5 / scale.timeline.fps + 1e-9:
        return
    end = max(scale.at(cue.actual), x + 12.0)
    picture.line(x + 6, y, end - 4, y, class_="softpen", stroke_width=1.4)
    picture.area([(end - 5, y - 3.5), (end - 5, y + 3.5), (end, y)], class_="soft")
    picture.words(end + 4, y + 4, f"+{delay:.2f} s", size=11, class_="soft")


def _draw_result(picture: Picture, scale: _Scale, top: float) -> None:
    timeline, base = scale.timeline, top + LANE
    scale.write_name(picture, "result", base - 13)
    for symbol, first, last in runs(timeline.supports):
        left, right = (scale.at(frame / timeline.fps) for frame in (first, last))
        picture.rectangle(left, base - BAR, right - left, BAR, fill=SUPPORT_COLORS[symbol])
        if right - left >= 15:
            _letter(picture, (left + right) / 2, base - BAR / 2 + 5, symbol, 13)


def runs(labels: Sequence[str]) -> list[tuple[str, int, int]]:
    """Return each maximal run of equal labels: the label, its first frame, the one after."""
    found: list[tuple[str, int, int]] = []
    for frame, label in enumerate(labels):
        if found and found[-1][0] == label:
            found[-1] = (label, found[-1][1], frame + 1)
        else:
            found.append((label, frame, frame + 1))
    return found
