"""The kick: one foot stands, the other swings back and through."""

from __future__ import annotations

from footfall.samples.score import Footwork, Score, Trunk
from footfall.samples.steps import FOR_LONG, RELAXED, SINCE_LONG, rest, standing, step, swing

__all__ = ["KICK"]

_RIGHT = (
    step(SINCE_LONG, 0.45, (-0.11, 0.11), 0.0, -40.0, rise=0.25, toe_out=8.0),
    step(1.65, FOR_LONG, (-0.11, 0.11), -12.0, flat=0.14, toe_out=8.0),
)
_THROUGH = swing(
    (0.16, -0.09, 0.20, -0.36, -85.0),
    (0.28, -0.08, 0.33, -0.56, -112.0),
    (0.41, -0.03, 0.035, 0.40, -32.0),
    (0.51, 0.0, 0.42, 0.84, 8.0),
    (0.60, -0.02, 0.40, 0.72, 2.0),
    (0.83, -0.1, 0.135, 0.19, -20.0),
)

_FEET = (Footwork((standing((0.11, 0.11), 8.0),)), Footwork(_RIGHT, (_THROUGH,)))

_PATH = (
    [rest(0.0, 0.0), rest(0.5, 0.075), rest(1.35, 0.075), rest(2.0, 0.0)],
    [rest(0.0, 0.953), rest(0.6, 0.925), rest(1.05, 0.945), rest(2.05, 0.953)],
    [rest(0.0, 0.0), rest(0.7, 0.02), rest(1.05, 0.05), rest(1.6, 0.0)],
)

_TRUNK = Trunk(
    pelvis=[
        (0.1, 0.0, 1.0, 0.0),
        (0.78, -18.0, 10.0, 2.0),
        (1.04, 20.0, -10.0, 5.0),
        (1.25, 14.0, -6.0, 2.0),
        (1.8, 0.0, 1.0, 0.0),
    ],
    chest=[
        (0.1, 0.0, 2.0, 0.0),
        (0.75, 14.0, 6.0, -4.0),
        (1.02, -14.0, 10.0, -4.0),
        (1.3, -8.0, 4.0, -2.0),
        (1.85, 0.0, 2.0, 0.0),
    ],
    head=[
        (0.1, 0.0, 2.0, 0.0),
        (0.75, 0.0, 12.0, 0.0),
        (1.1, 0.0, 8.0, 0.0),
        (1.8, 0.0, 2.0, 0.0),
    ],
)

_ARMS = (
    [
        (0.1, *RELAXED),
        (0.72, 35.0, 15.0, 62.0, 0.0, 25.0),
        (1.05, -25.0, 45.0, 30.0, 0.0, 40.0),
        (1.35, 0.0, 25.0, 22.0, -5.0, 35.0),
        (1.9, *RELAXED),
    ],
    [
        (0.1, *RELAXED),
        (0.75, 0.0, 18.0, 22.0, -10.0, 40.0),
        (1.05, 20.0, -28.0, 38.0, -5.0, 28.0),
        (1.4, 8.0, -6.0, 20.0, -10.0, 25.0),
        (1.9, *RELAXED),
    ],
)

KICK = Score(2.1, _FEET, _PATH, _TRUNK, _ARMS)
"""A kick with the right instep at what lies ahead: weight over, back, through, down.

The order of its parts (backswing, leg cocking, swing to contact, follow-through) is that of
the soccer kick in Lees et al., "The biomechanics of soccer: a review", J. Sports Sci. 28,
2010.
"""
