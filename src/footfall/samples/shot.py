"""The shot: a run-up, a take-off from one leg, a throw in the air, a landing on the other."""

from __future__ import annotations

from footfall.samples.curves import GRAVITY, ballistic_speeds
from footfall.samples.score import Footwork, Score, Trunk
from footfall.samples.steps import FOR_LONG, rest, step, stride, swing

__all__ = ["SHOT"]

_TAKEOFF, _LANDING = 0.68, 1.04
_UP, _DOWN = ballistic_speeds(-0.02, _LANDING - _TAKEOFF)
_LEFT = Footwork(
    (
        step(-0.25, 0.38, (0.05, 0.43), 15.0, -62.0, rise=0.3),
        step(_LANDING, 1.40, (0.04, 2.60), -14.0, -48.0, flat=0.08, rise=0.22),
        step(1.70, FOR_LONG, (0.10, 3.56), 6.0, flat=0.1),
    ),
    (
        swing(
            (0.22, 0.07, 0.22, 0.62, -88.0),
            (0.45, 0.09, 0.42, 1.55, -38.0),
            (0.75, 0.07, 0.30, 2.20, -22.0),
            (0.91, 0.05, 0.13, 2.50, -14.0),
        ),
        stride(height=0.06),
    ),
)
_RIGHT = Footwork(
    (
        step(-0.6, 0.0, (-0.05, -0.44), 15.0, -60.0),
        step(0.32, _TAKEOFF, (-0.05, 1.215), 16.0, -62.0, flat=0.08, rise=0.2),
        step(1.32, FOR_LONG, (-0.09, 3.27), 10.0),
    ),
    (
        stride(height=0.07),
        swing(
            (0.08, -0.055, 0.10, 1.29, -76.0),
            (0.2, -0.07, 0.25, 1.40, -88.0),
            (0.5, -0.09, 0.36, 1.95, -85.0),
            (0.8, -0.09, 0.12, 2.85, -15.0),
        ),
    ),
)

_FEET = (_LEFT, _RIGHT)

_PATH = (
    [
        rest(0.0, 0.01),
        (_TAKEOFF, -0.01, 0.04, 0.0),
        (_LANDING, 0.0044, 0.04, 0.0),
        rest(2.1, 0.0),
    ],
    [
        (0.0, 0.895, 0.15, 0.0),
        rest(0.15, 0.92, -2.0),
        rest(0.40, 0.855, 5.0),
        (_TAKEOFF, 0.945, _UP, -GRAVITY),
        (_LANDING, 0.925, _DOWN, -GRAVITY),
        rest(1.20, 0.805, 9.0),
        rest(1.48, 0.87, 0.0),
        rest(2.2, 0.925),
    ],
    [
        (0.0, 0.0, 2.3, 0.0),
        (0.34, 0.78, 2.25, 0.0),
        (_TAKEOFF, 1.535, 2.2, 0.0),
        (_LANDING, 1.535 + 2.2 * (_LANDING - _TAKEOFF), 2.2, 0.0),
        (1.36, 2.88, 1.3, 0.0),
        rest(2.1, 3.32),
    ],
)

_TRUNK = Trunk(
    pelvis=[
        (0.0, 5.0, 5.0, 0.0),
        (0.34, -6.0, 5.0, 0.0),
        (0.66, 14.0, 2.0, -2.0),
        (0.84, 12.0, 0.0, -2.0),
        (0.98, -12.0, 8.0, 0.0),
        (1.2, -10.0, 14.0, 2.0),
        (1.55, 4.0, 8.0, 0.0),
        (2.0, 0.0, 1.0, 0.0),
    ],
    chest=[
        (0.0, -6.0, 5.0, 0.0),
        (0.32, 16.0, 4.0, 0.0),
        (0.68, 42.0, -4.0, -6.0),
        (0.82, 36.0, -6.0, -8.0),
        (0.96, -34.0, 16.0, -4.0),
        (1.14, -40.0, 26.0, 0.0),
        (1.5, -10.0, 12.0, 0.0),
        (2.1, 0.0, 2.0, 0.0),
    ],
    head=[
        (0.0, 0.0, 2.0, 0.0),
        (0.8, 0.0, 0.0, 0.0),
        (1.15, 0.0, 12.0, 0.0),
        (1.9, 0.0, 2.0, 0.0),
    ],
)

_ARMS = (
    [
        (0.0, 4.0, 18.0, 12.0, -10.0, 60.0),
        (0.3, 15.0, -5.0, 45.0, 10.0, 75.0),
        (0.66, 28.0, 0.0, 92.0, 80.0, 92.0),
        (0.84, 32.0, 0.0, 100.0, 92.0, 82.0),
        (0.96, -62.0, 0.0, 108.0, 55.0, 18.0),
        (1.12, -72.0, 0.0, 62.0, -5.0, 14.0),
        (1.4, -30.0, 0.0, 24.0, -15.0, 25.0),
        (2.1, 4.0, 3.0, 10.0, -15.0, 18.0),
    ],
    [
        (0.0, 0.0, -8.0, 12.0, -10.0, 35.0),
        (0.3, 0.0, 30.0, 14.0, -10.0, 50.0),
        (0.66, 28.0, 82.0, 10.0, -10.0, 25.0),
        (0.82, 26.0, 78.0, 12.0, -10.0, 30.0),
        (0.98, 12.0, 10.0, 22.0, -10.0, 75.0),
        (1.2, 20.0, -20.0, 26.0, -10.0, 55.0),
        (2.1, 4.0, 3.0, 10.0, -15.0, 18.0),
    ],
)

SHOT = Score(2.3, _FEET, _PATH, _TRUNK, _ARMS)
"""A jump shot of handball, thrown with the left arm.

Its supports are those of figure 13 of the paper: L D R - L D R D. After two steps the right
leg takes off; the ball leaves in the air, near the highest point; the left foot lands.
"""
