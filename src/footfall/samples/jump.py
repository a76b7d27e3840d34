"""The jump: both feet leave and land together."""

from __future__ import annotations

from footfall.samples.curves import GRAVITY, ballistic_speeds
from footfall.samples.score import Footwork, Score, Trunk
from footfall.samples.steps import FOR_LONG, RELAXED, SINCE_LONG, rest, step, swing

__all__ = ["JUMP"]

_OFF, _ON = 0.70, 1.12
_OFF_HEIGHT, _ON_HEIGHT = 1.0, 0.965
_UP, _DOWN = ballistic_speeds(_ON_HEIGHT - _OFF_HEIGHT, _ON - _OFF)


def _foot(side: float) -> Footwork:
    x = side * 0.12
    return Footwork(
        (
            step(SINCE_LONG, _OFF, (x, 0.11), 0.0, -58.0, toe_out=8.0),
            step(_ON, FOR_LONG, (x, 0.48), -26.0, flat=0.1, toe_out=8.0),
        ),
        (
            swing(
                (0.1, x, 0.06, 0.12, -68.0),
                (0.25, x, 0.19, 0.16, -60.0),
                (0.5, x, 0.31, 0.26, -42.0),
                (0.8, x, 0.17, 0.43, -22.0),
            ),
        ),
    )


_FEET = (_foot(1.0), _foot(-1.0))

_PATH = (
    [rest(0.0, 0.0), rest(2.0, 0.0)],
    [
        rest(0.0, 0.953),
        rest(0.42, 0.68, 9.0),
        (_OFF, _OFF_HEIGHT, _UP, -GRAVITY),
        (_ON, _ON_HEIGHT, _DOWN, -GRAVITY),
        rest(1.36, 0.73, 9.0),
        rest(1.95, 0.953),
    ],
    [
        rest(0.0, 0.0),
        rest(0.40, -0.03),
        (_OFF, 0.10, 0.72, 0.0),
        (_ON, 0.10 + 0.72 * (_ON - _OFF), 0.72, 0.0),
        rest(1.75, 0.37),
    ],
)

_TRUNK = Trunk(
    pelvis=[
        (0.05, 0.0, 1.0, 0.0),
        (0.42, 0.0, 34.0, 0.0),
        (0.72, 0.0, 2.0, 0.0),
        (0.95, 0.0, 6.0, 0.0),
        (1.12, 0.0, 10.0, 0.0),
        (1.36, 0.0, 30.0, 0.0),
        (1.9, 0.0, 1.0, 0.0),
    ],
    chest=[
        (0.05, 0.0, 2.0, 0.0),
        (0.42, 0.0, 48.0, 0.0),
        (0.72, 0.0, 0.0, 0.0),
        (0.95, 0.0, 8.0, 0.0),
        (1.12, 0.0, 14.0, 0.0),
        (1.36, 0.0, 40.0, 0.0),
        (1.9, 0.0, 2.0, 0.0),
    ],
    head=[
        (0.05, 0.0, 2.0, 0.0),
        (0.42, 0.0, 10.0, 0.0),
        (0.75, 0.0, -8.0, 0.0),
        (1.36, 0.0, 14.0, 0.0),
        (1.8, 0.0, 2.0, 0.0),
    ],
)

_ARM = [
    (0.05, *RELAXED),
    (0.40, 6.0, -52.0, 14.0, -10.0, 12.0),
    (0.74, 6.0, 140.0, 16.0, 0.0, 22.0),
    (0.92, 8.0, 125.0, 22.0, 0.0, 25.0),
    (1.14, 10.0, 70.0, 28.0, 0.0, 25.0),
    (1.40, 6.0, 5.0, 20.0, -5.0, 25.0),
    (1.9, *RELAXED),
]

JUMP = Score(2.0, _FEET, _PATH, _TRUNK, (_ARM, _ARM))
"""A jump with both feet: crouch with the arms back, throw them up, fly, absorb.

The parabola of the pelvis is that of free fall: 0.42 s in the air.
"""
