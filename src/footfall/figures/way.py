"""Motions from the side, each figure where it is, at one scale: the rows of figures 16 to 18."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from footfall.arrays import Indices
from footfall.figures.figure import LEFT, WIDTH
from footfall.report import RATE, Trace, Track
from footfall.view.palette import SLIP
from footfall.view.plants import Plant, plants
from footfall.view.stage import Stage
from footfall.view.stick_figures import StickFigures
from footfall.view.svg import Picture

__all__ = ["Way", "apart", "draw_figures", "draw_slides", "every"]

MARGIN = 0.12
"""How much ground is shown before the first and behind the last place of any joint [m]."""

TALLEST = 190.0
"""Greatest height of a figure [pixels]."""


@dataclass(frozen=True, eq=False)
class Way:
    """From where, and at which scale, motions are looked at."""

    stage: Stage
    """The direction in which they go."""

    start: float
    """Farthest back that is shown [m]."""

    scale: float
    """Pixels per meter."""

    tallest: float
    """How high the highest joint comes [m]."""

    @classmethod
    def of(cls, traces: Sequence[Trace], *, tallest: float = TALLEST) -> Way:
        """Return a way that shows all of some motions, figures at most `tallest` pixels high."""
        stage = Stage.of([trace.positions[:, 0] for trace in traces])
        along = np.concatenate([stage.along(trace.positions).ravel() for trace in traces])
        start, end = float(along.min()) - MARGIN, float(along.max()) + MARGIN
        highest = max(float(trace.positions[..., 1].max()) for trace in traces) + 0.12
        scale = min((WIDTH - 2 * LEFT) / (end - start), tallest / highest)
        return cls(stage, start, scale, highest)

    @property
    def height(self) -> float:
        """Of the highest figure [pixels]."""
        return self.tallest * self.scale

    def x(self, along: float) -> float:
        """Return the x of a distance along the way [pixels]."""
        return LEFT + (along - self.start) * self.scale


def draw_figures(
    picture: Picture, way: Way, trace: Trace, parents: Indices, base: float, frames: Sequence[int]
) -> None:
    """Draw the stick figures of some frames at 60 Hz over a line at y = `base`."""
    picture.line(LEFT, base, WIDTH - LEFT, base, class_="softpen", stroke_width=1.2)
    figures = StickFigures(trace, parents, way.stage, (way.start, LEFT, way.scale, base))
    for frame in frames:
        if frame < figures.frames:
            figures.draw(picture, frame)


def draw_slides(picture: Picture, way: Way, trace: Trace, base: float, most: int) -> list[Plant]:
    """Stress where planted feet slide farthest: an ellipse each, with the millimeters.

    Returns:
        What is stressed, the worst first; slides under 30 mm are not, nor two at one place.
    """
    found = sorted(plants(Track.from_trace(trace)), key=lambda plant: -plant.slip)
    shown: list[tuple[float, float]] = []
    stressed: list[Plant] = []
    for plant in found:
        ways = way.stage.along(plant.print.mean(axis=0) + plant.streak)
        left, right = way.x(float(ways.min())), way.x(float(ways.max()))
        half = (right - left) / 2 + 0.24 * way.scale
        middle = (left + right) / 2
        apart = all(abs(middle - other) > max(half + reach + 4, 80.0) for other, reach in shown)
        if plant.slip < 0.03 or len(shown) == most or not apart:
            continue
        shown.append((middle, half))
        stressed.append(plant)
        picture.add(
            "ellipse", cx=middle, cy=base - 10, rx=half, ry=21, fill="none", stroke=SLIP,
            stroke_width=2.4,
        )  # fmt: skip
        told = f"{1000.0 * plant.slip:.0f} mm"
        picture.words(
            middle, base + 30, told, size=14, text_anchor="middle", fill=SLIP, font_weight="600"
        )
    return stressed


def every(seconds: float, frames: int) -> list[int]:
    """Return the frames at 60 Hz that are so far apart [s]."""
    return list(range(0, frames, max(1, round(seconds * RATE))))


def apart(way: Way, trace: Trace, meters: float, seconds: float) -> list[int]:
    """Return frames at 60 Hz that are so far apart [m], or, on the spot, so long [s]."""
    along = way.stage.along(Track.from_trace(trace).joints[:, 0])
    frames = [0]
    for frame in range(1, len(along)):
        moved = abs(float(along[frame] - along[frames[-1]]))
        if moved >= meters or frame - frames[-1] >= seconds * RATE:
            frames.append(frame)
    return frames
