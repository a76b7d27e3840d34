"""Gaits in a curve: straight ones laid along an arc, the body leaning into it.

Who goes round a curve leans until gravity and the turn balance, as the tangent of the lean is
v ω / g (R. McNeill Alexander, *Principles of Animal Locomotion*, 2003, on turning); walkers and
runners lean the trunk less than that, and put their feet further out instead.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.samples.curves import GRAVITY
from footfall.samples.gait import Gait, Harmonic

__all__ = ["along_arc", "bent", "headings_at"]

LEANING = 0.6
"""How much of the balancing lean the trunk takes."""

PELVIS_HEIGHT = 0.9
"""By which a lean moves the pelvis sideways [m]."""


def bent(gait: Gait, turn: float) -> Gait:
    """Return a straight gait that turns to the left by so much in a cycle [rad]."""
    speed, rate = gait.travel[1] / gait.duration, turn / gait.duration
    lean = LEANING * math.atan(speed * rate / GRAVITY)
    pelvis, (*chest, roll) = gait.pelvis, gait.upper.chest
    sway = replace(pelvis.sway, mean=pelvis.sway.mean + PELVIS_HEIGHT * math.sin(lean))
    return replace(
        gait,
        turn=turn,
        pelvis=replace(pelvis, sway=sway, tilt=_leaning(pelvis.tilt, lean)),
        # The head stays upright.
        upper=replace(gait.upper, chest=(chest[0], chest[1], _leaning(roll, lean))),
    )


def _leaning(roll: Harmonic, lean: float) -> Harmonic:
    return replace(roll, mean=roll.mean - math.degrees(lean))


def headings_at(gait: Gait, ahead: Floats) -> Floats:
    """Return how far a gait has turned after a way ahead [m]."""
    return gait.turn * ahead / gait.travel[1] if gait.turn else np.zeros_like(ahead)


def along_arc(gait: Gait, places: Positions) -> Positions:
    """Return places beside a straight way, beside the arc that a gait goes, shape (..., 3)."""
    if not gait.turn:
        return places
    radius = gait.travel[1] / gait.turn
    angles = headings_at(gait, places[..., 2])
    aside = radius - places[..., 0]
    return np.stack(
        [radius - aside * np.cos(angles), places[..., 1], aside * np.sin(angles)], axis=-1
    )
