"""A film strip of stick figures from the side, as in the paper's figure 17."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from footfall.arrays import Floats, Indices
from footfall.errors import ArgumentError
from footfall.report import RATE, Trace, Track
from footfall.view.palette import SLIP
from footfall.view.stage import Stage
from footfall.view.svg import Picture

__all__ = ["strip_svg"]

WIDTH = 1200.0
MARGIN = 24.0
HEADING = 40.0
TALLEST = 230.0
"""Greatest height of a figure [pixels]."""

SPACING = 32.0
"""Least mean distance between two figures [pixels]."""

_SHORTEST_BONE = 0.02
_HEAD_RADIUS = 0.095


def strip_svg(
    motions: Sequence[tuple[str, Trace]], parents: Indices, *, seconds: float | None = None
) -> str:
    """Draw motions from their right side, a figure every so often, transitions in red.

    Args:
        motions: A title and a motion each; all of one body.
        parents: Index of each joint's parent, -1 for joint 0, shape (joints,).
        seconds: Time between two figures [s], > 0; None: so that they stand apart.

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
        picture.line(MARGIN, base, WIDTH - MARGIN, base, class_="softpen", stroke_width=1.2)
        figures = _Figures(trace, parents, stage, (start, scale, base))
        for frame in range(0, figures.frames, max(1, round(seconds * RATE))):
            figures.draw(picture, frame)
    return picture.to_svg()


def _apart(lasting: float, width: float) -> float:
    """Return the time between two figures [s] that leaves enough room between them."""
    speed = width / lasting
    return next((s for s in (0.1, 0.15, 0.2, 0.25, 0.3, 0.4) if s * speed >= SPACING), 0.5)


def _legend(picture: Picture, seconds: float) -> None:
    text = f"Seen from the right side, a figure every {seconds:g} s"
    picture.words(20, 28, text, size=17, font_weight="600")
    picture.line(560, 23, 584, 23, stroke=SLIP, stroke_width=3, stroke_linecap="round")
    picture.words(592, 27, "in transition: weights move", class_="soft")


class _Figures:
    """Draws the figures of one motion; `frame` is where its row starts, scale, and base."""

    def __init__(
        self, trace: Trace, parents: Indices, stage: Stage, frame: tuple[float, float, float]
    ) -> None:
        start, scale, base = frame
        track = Track.from_trace(trace)
        self.x: Floats = MARGIN + (stage.along(track.joints) - start) * scale
        self.y: Floats = base - track.joints[..., 1] * scale
        self.scale = scale
        self.frames = track.frames
        self.moving = track.moving
        self.head = trace.anatomy.head
        self.left = set(_descendants(parents, trace.anatomy.left.hip))
        lengths = np.linalg.norm(trace.positions[0] - trace.positions[0][parents], axis=-1)
        lengths[0] = 0.0
        hand = {j for arm in trace.anatomy.arms if arm for j in _descendants(parents, arm.wrist)}
        self.bones = [
            (joint, int(parents[joint]))
            for joint in np.flatnonzero(lengths > _SHORTEST_BONE).tolist()
            if joint not in hand or joint in {a.wrist for a in trace.anatomy.arms if a}
        ]

    def draw(self, picture: Picture, frame: int) -> None:
        """Draw the figure of a frame; the far leg lies behind and is paler."""
        color = {"stroke": SLIP} if self.moving[frame] else {"class_": "pen"}
        picture.open("g", stroke_width=2.2, stroke_linecap="round", fill="none", **color)
        for joint, parent in sorted(self.bones, key=lambda bone: bone[0] not in self.left):
            picture.line(
                self.x[frame, parent],
                self.y[frame, parent],
                self.x[frame, joint],
                self.y[frame, joint],
                opacity=0.45 if joint in self.left else None,
            )
        if self.head is not None:
            x, y = self.x[frame, self.head], self.y[frame, self.head]
            radius = _HEAD_RADIUS * self.scale
            picture.add("circle", cx=x, cy=y - radius, r=radius)
        picture.close("g")


def _descendants(parents: Indices, joint: int) -> list[int]:
    found = [joint]
    for child in range(joint + 1, len(parents)):
        if int(parents[child]) in found:
            found.append(child)
    return found
