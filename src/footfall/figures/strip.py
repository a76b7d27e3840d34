"""A motion as a row of stick figures over a time axis, and its phases as a band."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from footfall.figures.cells import ON_COLOR, color_of, notation
from footfall.report import RATE, Trace
from footfall.support import Support, SupportSequence
from footfall.view.stage import Stage
from footfall.view.stick_figures import StickFigures
from footfall.view.svg import Picture

__all__ = ["TimeAxis", "draw_band", "draw_poses", "timed_phases"]

TALLEST = 150.0
"""Greatest height of a figure [pixels]."""


@dataclass(frozen=True, slots=True)
class TimeAxis:
    """Where times lie, from left to right."""

    left: float
    """The x of the first time [pixels]."""

    right: float
    """The x of the end [pixels]."""

    duration: float
    """What lies between them [s]."""

    start: float = 0.0
    """The first time [s]."""

    def x(self, seconds: float) -> float:
        """Return where a time lies [pixels]."""
        share = (seconds - self.start) / self.duration
        return self.left + (self.right - self.left) * min(max(share, 0.0), 1.0)

    @property
    def end(self) -> float:
        """The last time [s]."""
        return self.start + self.duration


def draw_poses(
    picture: Picture,
    trace: Trace,
    parents: np.ndarray[tuple[int], np.dtype[np.int64]],
    axis: TimeAxis,
    base: float,
    times: Sequence[float],
    *,
    tallest: float = TALLEST,
) -> None:
    """Draw the figures of some times [s], each with its pelvis over its time.

    Args:
        picture: Where to.
        trace: The motion.
        parents: Of its skeleton.
        axis: Where the times lie.
        base: The y of the ground [pixels].
        times: Which, within the motion.
        tallest: Height of the highest joint [pixels].
    """
    stage = Stage.of([trace.positions[:, 0]])
    height = float(trace.positions[..., 1].max()) + 0.1
    figures = StickFigures(trace, parents, stage, (0.0, 0.0, tallest / height, base))
    picture.line(axis.left - 20, base, axis.right + 20, base, class_="softpen", stroke_width=1.2)
    for time in times:
        frame = min(round(time * RATE), figures.frames - 1)
        figures.draw(picture, frame, along=axis.x(time) - float(figures.x[frame, 0]))


def draw_band(
    picture: Picture,
    axis: TimeAxis,
    phases: Sequence[tuple[Support, float, float]],
    top: float,
    height: float = 34.0,
) -> None:
    """Draw phases, each with its start and end [s], as a band with their names."""
    for support, start, end in phases:
        left, right = axis.x(start), axis.x(end)
        if right - left < 0.5:
            continue
        picture.rectangle(left, top, right - left, height, fill=color_of(support))
        picture.line(left, top, left, top + height, class_="rule", stroke_width=1.5)
        if right - left > 30:
            picture.words(
                (left + right) / 2,
                top + height / 2 + 6,
                notation(support),
                size=16,
                text_anchor="middle",
                font_weight="600",
                fill=ON_COLOR,
            )


def timed_phases(supports: SupportSequence, until: float) -> list[tuple[Support, float, float]]:
    """Return the phases of a sequence up to a time [s]: support, start and end."""
    found: list[tuple[Support, float, float]] = []
    start, k = supports.start, 0
    while start < until - 1e-9:
        phase = supports.at(k)
        found.append((phase.support, start, start + phase.duration))
        start, k = start + phase.duration, k + 1
        if not supports.cyclic and k == len(supports.phases):
            break
    return found
