"""A walk seen from above: prints of the feet, the way of the body, and where it faces."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable

import numpy as np

from footfall.arrays import Floats
from footfall.figures.arrows import draw_arrow
from footfall.figures.path_walk import PathWalk
from footfall.report import Track
from footfall.view.foot_traces import shoe_outline
from footfall.view.palette import BODY, FOOT_COLORS
from footfall.view.plants import plants
from footfall.view.svg import Picture

__all__ = ["draw_seen_from_above"]

_TURN = np.linspace(0.0, 2.0 * np.pi, 25)[:-1]
_CIRCLE = np.column_stack([np.cos(_TURN), np.sin(_TURN)])


def draw_seen_from_above(
    picture: Picture,
    at: Callable[[Floats], list[tuple[float, float]]],
    walked: PathWalk,
    frames: Iterable[int],
) -> None:
    """Draw prints, way and bodies.

    Args:
        picture: Drawn on.
        at: Where points of the world, shape (points, 3), are in the picture.
        walked: The walk.
        frames: In which of its frames the body is drawn.
    """
    for plant in plants(Track.from_trace(walked.trace)):
        picture.area(at(shoe_outline(plant.print)), fill=FOOT_COLORS[plant.foot], fill_opacity=0.75)
    ground = np.array([1.0, 0.0, 1.0])
    picture.path(at(walked.trace.positions[::2, 0] * ground), stroke=BODY, stroke_width=1.8)
    for frame in frames:
        place = walked.trace.positions[frame, 0] * ground
        heading = float(walked.headings[frame])
        ahead = np.array([math.sin(heading), 0.0, math.cos(heading)])
        aside = np.array([ahead[2], 0.0, -ahead[0]])
        picture.area(at(place + 0.2 * _CIRCLE @ np.array([aside, 0.4 * ahead])), fill=BODY)
        picture.area(at(place + 0.08 * _CIRCLE @ np.array([aside, ahead])), class_="ink")
        start, end = at(place + np.array([0.08, 0.36])[:, np.newaxis] * ahead)
        draw_arrow(picture, start, end, width=2.2)
