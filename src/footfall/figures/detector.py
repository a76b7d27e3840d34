"""Figure 5: from heights and speeds of the feet to their contacts."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Flags, Floats
from footfall.detection import Contacts, contact_supports, detect_contacts
from footfall.figures.axes import Axes
from footfall.figures.cast import Cast
from footfall.figures.figure import LEFT, TOP, WIDTH, Figure, begin_sheet
from footfall.figures.strip import TimeAxis, draw_poses
from footfall.report import clip_trace
from footfall.skeleton import find_anatomy
from footfall.view.palette import FOOT_COLORS, SLIP
from footfall.view.svg import Picture

__all__ = ["detector_figure"]

CLAIM = (
    "Interface of the support phases generator. At the bottom, the two horizontal areas define "
    "the support phases for each foot."
)
LONGEST = 3.2
"""What is shown at most of a motion [s]."""

POSES = 13
FEET = ((1, "right foot"), (0, "left foot"))


def detector_figure(cast: Cast) -> Figure:
    """Draw what the detector sees of a handball shot, its limits and what it finds."""
    motion = cast.motion("shot")
    anatomy = find_anatomy(motion.clip.skeleton)
    contacts = detect_contacts(motion.clip, anatomy)
    shown = min(motion.clip.duration, LONGEST)
    title = "The generator of support phases"
    note = (
        "A handball shot: height and speed of the lowest point of each foot; "
        "a foot carries where both are under their limits"
    )
    picture = begin_sheet(5, title, note, 806.0)
    axis = TimeAxis(LEFT + 92.0, WIDTH - LEFT - 30.0, shown)
    trace = clip_trace(motion.clip, anatomy, motion.supports)
    times = [shown * (index + 0.5) / POSES for index in range(POSES)]
    parents = motion.clip.skeleton.parents
    draw_poses(picture, trace, parents, axis, TOP + 176.0, times, tallest=164.0)
    seconds = np.arange(motion.clip.frames) / motion.clip.fps
    inside = seconds <= shown
    _draw_curves(picture, axis, contacts, (seconds[inside], inside))
    _draw_contacts(picture, axis, contacts, TOP + 608.0)
    found = contact_supports(contacts)
    facts = (
        f"Detected: {found}.",
        f"Limits of the lower point: {100 * contacts.height_limits.min():.1f} cm and "
        f"{contacts.speed_limits.min():.2f} m/s, adapted to the clip.",
    )
    return Figure(5, "detector", title, CLAIM, facts, picture.to_svg())


def _draw_curves(
    picture: Picture, axis: TimeAxis, contacts: Contacts, shown: tuple[Floats, Flags]
) -> None:
    times, inside = shown
    rows = (
        ("height [cm]", 100.0 * contacts.heights[inside], 100.0 * contacts.height_limits),
        ("speed [m/s]", contacts.speeds[inside], contacts.speed_limits),
    )
    for row, (label, values, limits) in enumerate(rows):
        limit = float(limits.mean())
        top = min(float(np.percentile(values, 99.0)), 6.0 * limit) * 1.08
        axes = Axes(
            axis.left,
            TOP + 222.0 + 196.0 * row,
            axis.right - axis.left,
            140.0,
            (0.0, axis.duration),
            (0.0, top),
        )
        ticks = _ticks(top)
        seconds = np.arange(0.0, axis.duration + 1e-9, 0.5).tolist() if row else ()
        axes.draw(picture, x_ticks=seconds, y_ticks=ticks, y_label=label)
        if row:
            picture.words(
                axes.right, axes.bottom + 38, "seconds", size=14, text_anchor="end", class_="soft"
            )
        y = axes.y(limit)
        picture.line(
            axes.left, y, axes.right, y, stroke=SLIP, stroke_width=1.8, stroke_dasharray="7 5"
        )
        picture.words(axes.right - 6, y - 7, "limit", size=13, text_anchor="end", fill=SLIP)
        for foot, _ in FEET:
            curve = np.clip(values[:, foot], 0.0, top)
            axes.curve(picture, times, curve, stroke=FOOT_COLORS[foot], stroke_width=2.8)


def _ticks(top: float) -> list[float]:
    step = next(s for s in (0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0) if top / s <= 4.5)
    return np.arange(0.0, top, step).tolist()


def _draw_contacts(picture: Picture, axis: TimeAxis, contacts: Contacts, top: float) -> None:
    """Draw an area for each foot, filled where it carries."""
    for row, (foot, name) in enumerate(FEET):
        y = top + 50.0 * row
        picture.rectangle(axis.left, y, axis.right - axis.left, 32, rx=4, class_="panel")
        picture.words(LEFT, y + 21, name, size=14, font_weight="600")
        for interval in contacts.intervals[foot]:
            left, right = axis.x(interval.start), axis.x(interval.end)
            if right - left > 0.5:
                picture.rectangle(left, y, right - left, 32, rx=4, fill=FOOT_COLORS[foot])
