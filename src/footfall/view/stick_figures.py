"""Stick figures of one motion, seen from its right side."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Flags, Floats, Indices
from footfall.report import Trace, Track
from footfall.view.palette import SLIP
from footfall.view.stage import Stage
from footfall.view.svg import Picture

__all__ = ["StickFigures"]

_SHORTEST_BONE = 0.02
_HEAD_RADIUS = 0.095


class StickFigures:
    """Draws figures of a motion at 60 Hz; those in transition are red."""

    moving: Flags
    """Whether weights move, shape (60 Hz frames,)."""

    def __init__(
        self,
        trace: Trace,
        parents: Indices,
        stage: Stage,
        frame: tuple[float, float, float, float],
    ) -> None:
        """Map a motion to a row of a picture.

        Args:
            trace: The motion.
            parents: Index of each joint's parent, -1 for joint 0, shape (joints,).
            stage: Where it is looked at from.
            frame: What lies at the row's left end [m] and the x of that end [pixels], pixels
                per meter, and the y of the ground [pixels].
        """
        start, left, scale, base = frame
        track = Track.from_trace(trace)
        self.x: Floats = left + (stage.along(track.joints) - start) * scale
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

    def draw(self, picture: Picture, frame: int, *, along: float = 0.0) -> None:
        """Draw the figure of a frame; the far leg lies behind and is paler.

        Args:
            picture: Where to.
            frame: Which frame at 60 Hz.
            along: How far to the right of its own place [pixels].
        """
        color = {"stroke": SLIP} if self.moving[frame] else {"class_": "pen"}
        picture.open("g", stroke_width=2.2, stroke_linecap="round", fill="none", **color)
        for joint, parent in sorted(self.bones, key=lambda bone: bone[0] not in self.left):
            picture.line(
                along + self.x[frame, parent],
                self.y[frame, parent],
                along + self.x[frame, joint],
                self.y[frame, joint],
                opacity=0.45 if joint in self.left else None,
            )
        if self.head is not None:
            x, y = along + self.x[frame, self.head], self.y[frame, self.head]
            radius = _HEAD_RADIUS * self.scale
            picture.add("circle", cx=x, cy=y - radius, r=radius)
        picture.close("g")


def _descendants(parents: Indices, joint: int) -> list[int]:
    found = [joint]
    for child in range(joint + 1, len(parents)):
        if int(parents[child]) in found:
            found.append(child)
    return found
