"""Figure 3: the support phases of a locomotion, and the events of its feet."""

from __future__ import annotations

import math

import numpy as np

from footfall.detection import Contacts, detect_contacts, detect_supports
from footfall.figures.cast import Cast
from footfall.figures.cells import ON_COLOR
from footfall.figures.figure import LEFT, TOP, WIDTH, Figure, begin_sheet
from footfall.figures.strip import TimeAxis, draw_band, draw_poses, timed_phases
from footfall.report import clip_trace
from footfall.skeleton import find_anatomy
from footfall.support import Support, SupportSequence
from footfall.view.palette import FOOT_COLORS
from footfall.view.svg import Picture

__all__ = ["locomotion_figure"]

CLAIM = (
    "Definition of support phases of a locomotion. The feet events are under the figure and our "
    "representation is above."
)
FIGURES = 14
"""How many poses stand in a row."""

CYCLES = 1.5
"""How much of the walk is shown."""


def locomotion_figure(cast: Cast) -> Figure:
    """Draw a walk with what is detected in it."""
    walk = cast.motion("walk")
    anatomy = find_anatomy(walk.clip.skeleton)
    contacts = detect_contacts(walk.clip, anatomy)
    supports = detect_supports(walk.clip, anatomy)
    begins = _first_single(supports)
    shown = CYCLES * walk.clip.duration
    title = "Support phases of a locomotion"
    note = (
        "Above: the phases that the detector finds in the clip; "
        "below: when each foot strikes and leaves"
    )
    picture = begin_sheet(3, title, note, 470.0)
    axis = TimeAxis(LEFT + 66.0, WIDTH - LEFT - 44.0, shown, begins)
    draw_band(picture, axis, timed_phases(supports, axis.end), TOP + 6.0)
    base = TOP + 236.0
    trace = clip_trace(walk.clip, anatomy, walk.supports, 3)
    times = [begins + shown * (index + 0.5) / FIGURES for index in range(FIGURES)]
    draw_poses(picture, trace, walk.clip.skeleton.parents, axis, base, times, tallest=176.0)
    _draw_events(picture, axis, contacts, base + 34.0)
    facts = (
        f"Detected: {supports}.",
        _deviation(supports, walk.supports),
    )
    return Figure(3, "locomotion", title, CLAIM, facts, picture.to_svg())


def _draw_events(picture: Picture, axis: TimeAxis, contacts: Contacts, top: float) -> None:
    """Draw a bar for each contact of each foot, with its strike and its leaving."""
    for row, (foot, name) in enumerate(((1, "right"), (0, "left"))):
        y = top + 46.0 * row
        picture.words(LEFT, y + 17, name, size=15, font_weight="600")
        for interval in contacts.intervals[foot]:
            for turn in range(-1, 3):
                start = interval.start + turn * contacts.duration
                end = interval.end + turn * contacts.duration
                left, right = axis.x(start), axis.x(end)
                if right - left < 1.0:
                    continue
                picture.rectangle(left, y, right - left, 24, rx=12, fill=FOOT_COLORS[foot])
                if right - left > 66.0:
                    _draw_event(picture, axis, start, "strike", y)
                if right - left > 110.0:
                    _draw_event(picture, axis, end, "off", y)


def _draw_event(picture: Picture, axis: TimeAxis, time: float, word: str, y: float) -> None:
    if axis.start < time < axis.end - 1e-6:
        inward, side = (12, "start") if word == "strike" else (-12, "end")
        x = axis.x(time) + inward
        picture.words(x, y + 17, word, size=14, text_anchor=side, fill=ON_COLOR)


def _first_single(supports: SupportSequence) -> float:
    """Return when the first phase on the right foot begins [s]; 0 where there is none."""
    for phase, start in zip(supports.phases, supports.boundaries[:-1], strict=True):
        if phase.support is Support.RIGHT:
            return start % supports.duration
    return 0.0


def _deviation(found: SupportSequence, known: SupportSequence) -> str:
    """Say how far the detected boundaries are from those that the clip was made with."""
    symbols = [[phase.support for phase in one.phases] for one in (found, known)]
    count, cycle = len(symbols[0]), known.duration
    starts = [np.array(one.boundaries[:-1]) for one in (found, known)]
    worst = math.inf
    for turn in range(count):
        if symbols[0][turn:] + symbols[0][:turn] == symbols[1]:
            differences = np.roll(starts[0], -turn) - starts[1]
            wrapped = (differences + 0.5 * cycle) % cycle - 0.5 * cycle
            worst = min(worst, float(np.abs(wrapped).max()))
    if worst == math.inf:
        return "The clip brings no other supports to compare with."
    return f"Boundaries are within {1000.0 * worst:.0f} ms of those that the clip was made with."
