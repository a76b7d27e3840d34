"""A skinned character from the side: every limb of its mannequin as a filled outline."""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from footfall.arrays import Floats, Indices
from footfall.figures.way import Way
from footfall.io.flat_toes import flat_toe_turns
from footfall.io.mannequin import Mannequin, Tone, mannequin
from footfall.report import RATE, Trace
from footfall.skeleton import Skeleton
from footfall.view.svg import Picture

__all__ = ["Silhouettes"]

_FILLS = {
    Tone.BODY: "#d4cfc7",
    Tone.FACE: "#333840",
    Tone.LEFT: "#8cb0cc",
    Tone.RIGHT: "#deb082",
    Tone.LEFT_FOOT: "#3b8fd0",
    Tone.RIGHT_FOOT: "#e6912a",
}
"""As in the player: the sides differ, so that the feet are told apart."""

_EDGE = "#4b525c"


@dataclass(frozen=True, eq=False)
class _Limb:
    """What moves most with one joint and has one color."""

    tone: Tone
    vertices: Indices
    """Of the mannequin; where a surface bends, with those that the next joint moves first."""


class Silhouettes:
    """Draws the mannequin of one motion, limb by limb, the far ones first."""

    def __init__(self, trace: Trace, skeleton: Skeleton, way: Way, base: float) -> None:
        """Prepare the limbs.

        Args:
            trace: The motion.
            skeleton: Its body.
            way: From where it is looked at.
            base: The y of the ground [pixels].
        """
        turns = flat_toe_turns(trace.anatomy, trace.rotations, trace.positions)
        body = mannequin(skeleton, trace.anatomy, turns)
        self._body = body
        self._limbs = _limbs(body)
        self._trace, self._way, self._base = trace, way, base

    def draw(self, picture: Picture, frame: int) -> None:
        """Draw the character of a frame at 60 Hz."""
        trace, way = self._trace, self._way
        index = min(round(frame / RATE * trace.fps), trace.frames - 1)
        shapes: list[tuple[float, Tone, list[tuple[float, float]]]] = []
        vertices = self._body.placed(trace.rotations[index], trace.positions[index])
        for limb in self._limbs:
            places = vertices[limb.vertices]
            flat = np.column_stack(
                [
                    way.x(0.0) + way.stage.along(places) * way.scale,
                    self._base - places[:, 1] * way.scale,
                ]
            )
            # What shows of the face is what stands out beyond the head.
            depth = float(way.stage.leftward(places).mean()) + (limb.tone is Tone.FACE)
            shapes.append((depth, limb.tone, _outline(flat)))
        picture.open("g", stroke=_EDGE, stroke_width=0.7, stroke_linejoin="round")
        for _, tone, outline in sorted(shapes, key=lambda shape: -shape[0]):
            picture.area(outline, fill=_FILLS[tone])
        picture.close("g")


def _limbs(body: Mannequin) -> list[_Limb]:
    """Return the limbs in the order of their joints."""
    joints = body.joints[body.triangles]
    limbs: list[_Limb] = []
    for joint in np.unique(joints).tolist():
        moved = (joints == joint).any(axis=1)
        limbs += [
            _Limb(Tone(tone), np.unique(body.triangles[moved & (body.tones == tone)]))
            for tone in np.unique(body.tones[moved]).tolist()
        ]
    return limbs


def _outline(points: Floats) -> list[tuple[float, float]]:
    """Return the corners of the smallest convex outline around points; three where in line."""
    # Late: SciPy takes longer to load than all the rest.
    spatial: Any = import_module("scipy.spatial")
    try:
        corners: Floats = points[spatial.ConvexHull(points).vertices]
    except spatial.QhullError:
        corners = points[:3]
    return [(float(x), float(y)) for x, y in corners]
