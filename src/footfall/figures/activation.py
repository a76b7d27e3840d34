"""Figure 2: when an action begins, is complete, is told to end, and is gone."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats
from footfall.engine import Character, Recorder
from footfall.engine.recording import Recording
from footfall.figures.arrows import draw_legend
from footfall.figures.axes import Axes
from footfall.figures.cast import Cast
from footfall.figures.cells import ON_COLOR, color_of
from footfall.figures.figure import LEFT, TOP, WIDTH, Figure, begin_sheet
from footfall.support import Support
from footfall.timing import level
from footfall.view.palette import SUPPORT_COLORS
from footfall.view.svg import Picture
from footfall.view.timeline import runs

__all__ = ["Moments", "activation_figure"]

CLAIM = (
    "Activation and deactivation of actions. t1 is the starting time of the action and t3 its "
    "ending time. t2 (resp. t4) is the complete activation (resp. deactivation) of the action."
)
FPS = 60.0
START, STOP, END = 0.6, 3.0, 4.4
"""Times of the commands, and of the end of the picture [s]."""

FADE_IN, FADE_OUT = 0.7, 0.5
"""[s]"""

COLOR, ASKED = SUPPORT_COLORS["L"], SUPPORT_COLORS["R"]


class Moments:
    """t1 to t4 of an action, as its weight tells them."""

    def __init__(self, times: Floats, weights: Floats, start: float, stop: float) -> None:
        """Find when the weight is complete, and when it is gone after the stop."""
        self.t1, self.t3 = start, stop
        complete = np.flatnonzero((times >= start) & (weights >= 1.0))
        self.t2 = float(times[complete[0]]) if len(complete) else float("inf")
        gone = np.flatnonzero((times > stop) & (weights <= 0.0))
        self.t4 = float(times[gone[0]]) if len(gone) else float("inf")


def activation_figure(cast: Cast) -> Figure:
    """Draw the weight of a walk that starts and stops beside the neutral motion."""
    title = "Activation and deactivation of an action"
    note = (
        "The weight of a walk on the legs while a standing character starts and stops it; "
        "weights wait while both feet carry, for as long as the fade at most"
    )
    recording, actual = _record(cast)
    times = np.arange(recording.frames) / FPS
    weights = recording.shares[:, 0]
    moments = Moments(times, weights, actual, STOP)
    picture = begin_sheet(2, title, note, 504.0)
    axes = Axes(72.0, TOP + 44.0, WIDTH - 72.0 - LEFT - 8.0, 274.0, (0.0, END), (0.0, 1.12))
    axes.draw(picture, y_ticks=(0.0, 0.5, 1.0), y_label="weight on the legs")
    axes.curve(picture, times, _asked(times, actual), stroke=ASKED, stroke_dasharray="7 5")
    axes.curve(picture, times, weights, stroke=COLOR, stroke_width=4)
    draw_legend(picture, 620.0, TOP + 34.0, COLOR, "as it was played")
    draw_legend(picture, 800.0, TOP + 34.0, ASKED, "without waiting", dashed=True)
    _draw_moments(picture, axes, moments)
    _draw_supports(picture, axes, recording)
    facts = (
        f"t1 = {moments.t1:.2f} s, t2 = {moments.t2:.2f} s, t3 = {moments.t3:.2f} s, "
        f"t4 = {moments.t4:.2f} s.",
        f"Fades of {FADE_IN:g} s and {FADE_OUT:g} s took {moments.t2 - moments.t1:.2f} s and "
        f"{moments.t4 - moments.t3:.2f} s.",
    )
    return Figure(2, "activation", title, CLAIM, facts, picture.to_svg())


def _record(cast: Cast) -> tuple[Recording, float]:
    """Return what a standing character does, and when the walk really started."""
    walk = cast.motion("walk")
    hero = Character(walk.clip.skeleton)
    hero.add("walk", walk.clip, walk.supports, fade_in=FADE_IN, fade_out=FADE_OUT)
    hero.advance(0.0)
    # The first action of all has nothing to fade from: let it come and go before the picture.
    hero.start("walk")
    hero.stop("walk")
    hero.advance(2.0 * FADE_OUT + 0.1)
    recorder = Recorder(hero, FPS)
    started = float("inf")
    for frame in range(int(END * FPS) + 1):
        if frame > 0:
            hero.advance(1.0 / FPS)
        if frame == round(START * FPS):
            hero.start("walk")
        if frame == round(STOP * FPS):
            hero.stop("walk")
        if started == float("inf") and hero.is_active("walk") and not hero.is_waiting("walk"):
            started = frame / FPS
        recorder.keep()
    return recorder.finish(), started


def _asked(times: Floats, start: float) -> Floats:
    """Return the level of the action if nothing waited, shape (times,)."""
    rising = [level((float(time) - start) / FADE_IN) for time in times]
    falling = [level((float(time) - STOP) / FADE_OUT) for time in times]
    return np.array(rising) - np.array(falling)


def _draw_moments(picture: Picture, axes: Axes, moments: Moments) -> None:
    told = (
        ("t1", moments.t1, "start", 0.0),
        ("t2", moments.t2, "active", 1.0),
        ("t3", moments.t3, "stop", 1.0),
        ("t4", moments.t4, "gone", 0.0),
    )
    for name, time, word, value in told:
        if time > END:
            continue
        x = axes.x(time)
        picture.line(x, axes.top, x, axes.bottom + 30, class_="softpen", stroke_dasharray="3 4")
        axes.mark(picture, time, value, COLOR, 6.5)
        picture.words(
            x, axes.bottom + 48, f"t{'₁₂₃₄'[int(name[1]) - 1]}", size=18, text_anchor="middle",
            font_weight="600",
        )  # fmt: skip
        picture.words(
            x,
            axes.bottom + 68,
            f"{word}, {time:.2f} s",
            size=14,
            text_anchor="middle",
            class_="soft",
        )


def _draw_supports(picture: Picture, axes: Axes, recording: Recording) -> None:
    """Draw what carries the body, as a band under the curve."""
    top = axes.bottom + 6
    for symbol, first, last in runs(recording.support_text):
        support = Support.from_symbol(symbol)
        left, right = axes.x(first / FPS), axes.x(min(last / FPS, END))
        picture.rectangle(left, top, right - left, 18, fill=color_of(support))
        if right - left > 14:
            picture.words(
                (left + right) / 2,
                top + 14,
                support.symbol,
                size=13,
                text_anchor="middle",
                font_weight="600",
                fill=ON_COLOR,
            )
