"""The punch: both feet stand, the trunk winds up and turns through."""

from __future__ import annotations

from footfall.samples.score import Footwork, Score, Trunk
from footfall.samples.steps import RELAXED, rest, standing

__all__ = ["PUNCH"]

_REAR = standing((-0.13, -0.03), 22.0, lifts=((0.62, 0.0), (0.86, -28.0), (1.0, -28.0), (1.3, 0.0)))
_GUARD_LEFT = (-6.0, 52.0, 12.0, 0.0, 112.0)
_GUARD_RIGHT = (0.0, 40.0, 14.0, 0.0, 128.0)

_FEET = (Footwork((standing((0.11, 0.25), 8.0),)), Footwork((_REAR,)))

_PATH = (
    [rest(0.0, 0.0), rest(0.62, -0.02), rest(0.86, 0.03), rest(1.3, 0.0), rest(1.9, 0.0)],
    [rest(0.0, 0.943), rest(0.5, 0.915), rest(0.86, 0.905), rest(1.9, 0.943)],
    [rest(0.0, 0.0), rest(0.62, -0.03), rest(0.86, 0.07), rest(1.0, 0.07), rest(1.5, 0.0)],
)

_TRUNK = Trunk(
    pelvis=[
        (0.1, -6.0, 1.0, 0.0),
        (0.45, -14.0, 4.0, 0.0),
        (0.64, -24.0, 4.0, 0.0),
        (0.86, 26.0, 8.0, 0.0),
        (1.0, 26.0, 8.0, 0.0),
        (1.35, -12.0, 4.0, 0.0),
        (1.85, -6.0, 1.0, 0.0),
    ],
    chest=[
        (0.1, -4.0, 2.0, 0.0),
        (0.45, -20.0, 9.0, 0.0),
        (0.64, -38.0, 9.0, 3.0),
        (0.86, 46.0, 14.0, -3.0),
        (1.0, 46.0, 14.0, -3.0),
        (1.35, -18.0, 9.0, 0.0),
        (1.85, -4.0, 2.0, 0.0),
    ],
    head=[
        (0.1, 0.0, 2.0, 0.0),
        (0.5, 0.0, 8.0, 0.0),
        (1.35, 0.0, 8.0, 0.0),
        (1.8, 0.0, 2.0, 0.0),
    ],
)

_ARMS = (
    [
        (0.08, *RELAXED),
        (0.42, *_GUARD_LEFT),
        (0.86, -2.0, 38.0, 12.0, 0.0, 128.0),
        (1.35, *_GUARD_LEFT),
        (1.9, *RELAXED),
    ],
    [
        (0.08, *RELAXED),
        (0.42, *_GUARD_RIGHT),
        (0.64, 10.0, 26.0, 16.0, 0.0, 130.0),
        (0.86, 38.0, 84.0, 4.0, -25.0, 6.0),
        (0.98, 38.0, 84.0, 4.0, -25.0, 8.0),
        (1.35, *_GUARD_RIGHT),
        (1.9, *RELAXED),
    ],
)

PUNCH = Score(2.0, _FEET, _PATH, _TRUNK, _ARMS)
"""A straight right (a cross) from a guard; both feet stay, the rear heel turns up."""
