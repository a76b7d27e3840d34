"""Figure 11: how the spline of one element is built anew when the element's duration changes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats
from footfall.figures.axes import Axes
from footfall.figures.cast import Cast
from footfall.figures.figure import LEFT, TOP, WIDTH, Figure, begin_sheet
from footfall.figures.warp_example import WarpExample
from footfall.support import Support, SupportSequence
from footfall.timing import TimeWarp, end_slope_paper, slot_duration, warp
from footfall.view.palette import BODY, SLIP, SUPPORT_COLORS
from footfall.view.svg import Picture

__all__ = ["Rebuilt", "spline_figure"]

CLAIM = "Monotonic spline construction process."
RUN_SHARE = 0.2
"""Weight of the run once the kick has come in."""

PROGRESS = 0.6
"""How much of the element has been played when its duration changes."""

OLD, NEW, LINE = BODY, SUPPORT_COLORS["L"], SUPPORT_COLORS["R"]


@dataclass(frozen=True, slots=True)
class Rebuilt:
    """An element of the run, and its spline before and after its duration changes."""

    before: TimeWarp
    """Its spline as it was, from 0."""

    now: float
    """When the duration changes [s]."""

    new_end: float
    """When it is to end then [s]."""

    clip_now: float
    """Where the clip is at that moment [s]."""

    rate: float
    """How fast it goes there, v(t)."""

    @classmethod
    def of(cls, cast: Cast) -> Rebuilt:
        """Return an element of figure 12 that speeds up, until a kick comes in."""
        example = WarpExample.of(cast)
        clock, clip = example.clock_times, example.clip_times
        printed = TimeWarp.through(clock, clip, paper=True)
        rising = np.diff(printed.rates) > 0.0
        k = int(np.where(rising, np.diff(clock), 0.0).argmax())
        lasts, plays = float(clock[k + 1] - clock[k]), float(clip[k + 1] - clip[k])
        now = PROGRESS * lasts
        clip_now, rate = (float(found[0]) for found in printed.at(np.array([clock[k] + now])))
        shares = np.array([RUN_SHARE, 1.0 - RUN_SHARE])
        other = _longest_single(cast.motion("kick").supports)
        lasting = slot_duration(shares, np.array([plays, other]), 2)
        knots = clock[k : k + 2] - clock[k], clip[k : k + 2] - clip[k], printed.rates[k : k + 2]
        return cls(
            before=TimeWarp(*knots, use_paper_cubic=True),
            now=now,
            new_end=now + (1.0 - PROGRESS) * lasting,
            clip_now=clip_now - float(clip[k]),
            rate=rate,
        )

    @property
    def own(self) -> float:
        """How much of the clip it plays [s]."""
        return float(self.before.clip_times[-1])

    @property
    def end(self) -> float:
        """When it was to end [s]."""
        return float(self.before.clock_times[-1])

    @property
    def mean(self) -> float:
        """The mean rate from now to the new end."""
        return (self.own - self.clip_now) / (self.new_end - self.now)

    @property
    def mirrored(self) -> float:
        """The mirror image of the present rate about the mean."""
        return 2.0 * self.mean - self.rate

    @property
    def end_rate(self) -> float:
        """The same within its bounds."""
        return end_slope_paper(self.mean, self.rate)

    def at(self, times: Floats) -> Floats:
        """Return the clip times of the new spline [s]."""
        knots = (self.now, self.clip_now, self.rate, self.new_end, self.own, self.end_rate)
        return np.array([warp(float(time), *knots, True)[0] for time in times])


def spline_figure(cast: Cast) -> Figure:
    """Draw the six steps."""
    element = Rebuilt.of(cast)
    title = "Construction of the monotonic spline"
    note = (
        "An element of figure 12 while a kick takes over 80 % of the weight: "
        "clip time over clock time, in the six steps of section 5.3"
    )
    picture = begin_sheet(11, title, note, 806.0)
    told = (
        ("A", "the present spline; v(t) at the present t"),
        ("B", "the element lasts longer: tₙ₊₁ moves"),
        ("C", "the mean slope m to the new end"),
        ("D", f"slope at the end: 2m − v = {_signed(element.mirrored)}"),
        ("E", f"bounded to 0 … 3m: {element.end_rate:.2f}"),
        ("F", "the spline of the rest of the element"),
    )
    for place, (letter, words) in enumerate(told):
        axes = _panel(element, place)
        axes.draw(picture)
        x, y = axes.left, axes.top - 12
        picture.words(x, y, letter, size=17, font_weight="600")
        picture.words(x + 22, y, words, size=14, class_="soft")
        _draw_step(picture, axes, element, place)
    facts = (
        f"v = {element.rate:.2f}, m = {element.mean:.2f}; 2m − v = {_signed(element.mirrored)}, "
        f"bounded to {element.end_rate:.2f}.",
        f"The element ends at {element.new_end:.2f} s instead of {element.end:.2f} s.",
    )
    return Figure(11, "spline", title, CLAIM, facts, picture.to_svg())


def _longest_single(supports: SupportSequence) -> float:
    singles = [p.duration for p in supports.phases if p.support in (Support.LEFT, Support.RIGHT)]
    return max(singles or [phase.duration for phase in supports.phases])


def _signed(value: float) -> str:
    return f"{value:.2f}".replace("-", "−")


def _panel(element: Rebuilt, place: int) -> Axes:
    width = (WIDTH - 2 * LEFT - 2 * 34.0) / 3
    row, column = divmod(place, 3)
    left, top = LEFT + column * (width + 34.0), TOP + 30.0 + row * 352.0
    ends = 1.16 * max(element.new_end, element.end)
    return Axes(left, top, width, 268.0, (0.0, ends), (-0.06 * element.own, 1.3 * element.own))


def _draw_step(picture: Picture, axes: Axes, element: Rebuilt, place: int) -> None:
    now, end = element.now, element.new_end
    past = np.linspace(0.0, now, 61)
    _draw_ends(picture, axes, element, moved=place >= 1)
    axes.curve(picture, past, element.before.at(past)[0], stroke=OLD, stroke_width=3.2)
    if place < 3:
        rest = np.linspace(now, element.end, 61)
        dash = None if place == 0 else "6 5"
        axes.curve(
            picture, rest, element.before.at(rest)[0], stroke=OLD,
            stroke_width=3.2 if place == 0 else 2.0, stroke_dasharray=dash,
        )  # fmt: skip
    if place >= 2:
        chord = np.array([element.clip_now, element.own])
        axes.curve(
            picture, np.array([now, end]), chord, stroke=LINE, stroke_width=2.0,
            stroke_dasharray=None if place == 2 else "3 5",
        )  # fmt: skip
    if place == 0:
        _tangent(picture, axes, (now, element.clip_now), element.rate, LINE, both=True)
    if place == 3:
        _tangent(picture, axes, (end, element.own), element.mirrored, SLIP)
    if place == 4:
        _draw_bounds(picture, axes, element)
        _tangent(picture, axes, (end, element.own), element.end_rate, SLIP)
    if place == 5:
        times = np.linspace(now, end, 121)
        axes.curve(picture, times, element.at(times), stroke=NEW, stroke_width=4.0)
        axes.mark(picture, end, element.own, NEW, 5.5)
    axes.mark(picture, now, element.clip_now, OLD if place < 5 else NEW, 5.5)


def _draw_ends(picture: Picture, axes: Axes, element: Rebuilt, *, moved: bool) -> None:
    """Draw the present moment and the ends of the element, and say what they are."""
    y = axes.y(element.own)
    picture.line(axes.left, y, axes.right, y, class_="rule", stroke_width=1.2)
    marks = [(element.now, "t"), (element.end, "tₙ₊₁")]
    if moved:
        marks.append((element.new_end, "new tₙ₊₁"))
    for time, word in marks:
        x = axes.x(time)
        old = moved and time == element.end
        picture.line(
            x, axes.top, x, axes.bottom, class_="rule" if old else "softpen",
            stroke_width=1.2, stroke_dasharray="4 4",
        )  # fmt: skip
        picture.words(
            x, axes.bottom + 19, word, size=14, text_anchor="middle",
            class_="soft" if old else "ink",
        )  # fmt: skip


def _tangent(
    picture: Picture,
    axes: Axes,
    point: tuple[float, float],
    slope: float,
    color: str,
    *,
    both: bool = False,
) -> None:
    """Draw a slope through a point: a line of a fixed length before it, or on both sides."""
    time, value = point
    reach = 0.17 * axes.x_range[1]
    ends = [
        (time + side * reach, value + side * reach * slope) for side in (-1.0, 1.0 if both else 0.6)
    ]
    picture.path([axes.at(*end) for end in ends], stroke=color, stroke_width=3.2)
    axes.mark(picture, time, value, color, 5.5)


def _draw_bounds(picture: Picture, axes: Axes, element: Rebuilt) -> None:
    """Draw between which slopes the end must stay: 0 and 3m."""
    reach = 0.17 * axes.x_range[1]
    time, value = element.new_end, element.own
    wedge = [(time, value), (time - reach, value), (time - reach, value - 3 * element.mean * reach)]
    picture.area([axes.at(*corner) for corner in wedge], fill=SUPPORT_COLORS["D"], fill_opacity=0.3)
