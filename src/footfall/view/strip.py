"""A film strip of stick figures from the side, as in the paper's figure 17."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from footfall.adaptation import AnyGround, ground_heights
from footfall.arrays import Floats, Indices
from footfall.errors import ArgumentError
from footfall.report import RATE, Trace
from footfall.view.palette import BODY, SLIP
from footfall.view.stage import Stage
from footfall.view.stick_figures import StickFigures
from footfall.view.svg import Picture

__all__ = ["strip_svg"]

WIDTH = 1200.0
MARGIN = 24.0
HEADING = 40.0
TALLEST = 230.0
"""Greatest height of a figure [pixels]."""

SPACING = 32.0
"""Least mean distance between two figures [pixels]."""


def strip_svg(
    motions: Sequence[tuple[str, Trace]],
    parents: Indices,
    *,
    seconds: float | None = None,
    ground: AnyGround | None = None,
) -> str:
    """Draw motions from their right side, a figure every so often, transitions in red.

    Args:
        motions: A title and a motion each; all of one body.
        parents: Index of each joint's parent, -1 for joint 0, shape (joints,).
        seconds: Time between two figures [s], > 0; None: so that they stand apart.
        ground: What they go over, drawn as it lies under the middle of each way at time 0; None:
            the level.

    Raises:
        ArgumentError: If `seconds` is not positive.
    """
    if seconds is not None and not seconds > 0.0:
        raise ArgumentError(f"figures every {seconds} s; the time between them must be > 0")
    stage = Stage.of(trace.positions[:, 0] for _, trace in motions)
    along = np.concatenate([stage.along(trace.positions).ravel() for _, trace in motions])
    tallest = max(float(trace.positions[..., 1].max()) for _, trace in motions) + 0.15
    start, end = float(along.min()) - 0.1, float(along.max()) + 0.1
    scale = min((WIDTH - 2 * MARGIN) / (end - start), TALLEST / tallest)
    if seconds is None:
        lasting = max(trace.frames / trace.fps for _, trace in motions)
        seconds = _apart(lasting, (end - start) * scale)
    panel = HEADING + tallest * scale + 26.0
    picture = Picture("strip", "Figures from the side", WIDTH, 40.0 + len(motions) * panel)
    _legend(picture, seconds)
    for index, (title, trace) in enumerate(motions):
        base = 40.0 + (index + 1) * panel - 22.0
        picture.words(20, base - tallest * scale - 12, title, size=15, font_weight="600")
        if ground is None:
            picture.line(MARGIN, base, WIDTH - MARGIN, base, class_="softpen", stroke_width=1.2)
        else:
            _draw_ground(picture, ground, trace, stage, (start, scale, base))
        figures = StickFigures(trace, parents, stage, (start, MARGIN, scale, base))
        for frame in range(0, figures.frames, max(1, round(seconds * RATE))):
            figures.draw(picture, frame)
    return picture.to_svg()


def _draw_ground(
    picture: Picture,
    ground: AnyGround,
    trace: Trace,
    stage: Stage,
    frame: tuple[float, float, float],
) -> None:
    """Draw the ground under the middle of a way.

    `frame` is what lies at the left end [m], pixels per meter, and the y of height 0 [pixels].
    """
    start, scale, base = frame
    x = np.arange(MARGIN, WIDTH - MARGIN + 0.5)
    ahead, leftward = stage.ahead, np.array([stage.ahead[1], -stage.ahead[0]])
    middle = float(stage.leftward(trace.positions[:, 0]).mean())
    places: Floats = np.zeros((len(x), 3))
    places[:, [0, 2]] = (start + (x - MARGIN) / scale)[:, np.newaxis] * ahead + middle * leftward
    y = base - ground_heights(ground, places, np.zeros(len(x))) * scale
    top = [(float(across), float(down)) for across, down in zip(x, y, strict=True)]
    bottom = max(base, float(y.max())) + 14.0
    picture.area([(top[0][0], bottom), *top, (top[-1][0], bottom)], fill=BODY, opacity=0.22)
    picture.path(top, class_="softpen", stroke_width=1.6)


def _apart(lasting: float, width: float) -> float:
    """Return the time between two figures [s] that leaves enough room between them."""
    speed = width / lasting
    return next((s for s in (0.1, 0.15, 0.2, 0.25, 0.3, 0.4) if s * speed >= SPACING), 0.5)


def _legend(picture: Picture, seconds: float) -> None:
    text = f"Seen from the right side, a figure every {seconds:g} s"
    picture.words(20, 28, text, size=17, font_weight="600")
    picture.line(560, 23, 584, 23, stroke=SLIP, stroke_width=3, stroke_linecap="round")
    picture.words(592, 27, "in transition: weights move", class_="soft")
