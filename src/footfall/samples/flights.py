"""The samples that arrive walking or running and take off: the shot and the walk that hops."""

from __future__ import annotations

import math

from footfall.samples.curves import GRAVITY, ballistic_speeds
from footfall.samples.footsteps import Stance, Swing
from footfall.samples.score import Footwork, Score, rest, swing

__all__ = ["shot", "walk_to_hop"]

_AFTER = 60.0
"""The end of a stance that outlasts the motion [s]."""


def _step(
    strike: float,
    leave: float,
    ball: tuple[float, float],
    strike_pitch: float,
    leave_pitch: float = 0.0,
    *,
    flat: float = 0.09,
    rise: float = 0.24,
) -> Stance:
    """Return a stance; pitches in degrees, toes a little outward."""
    side = 1.0 if ball[0] > 0.0 else -1.0
    return Stance(
        strike,
        leave,
        ball,
        side * math.radians(6.0),
        math.radians(strike_pitch),
        math.radians(leave_pitch),
        flat=flat,
        rise=rise,
    )


def _stride(*, height: float = 0.045) -> Swing:
    """Return a walking foot's swing."""
    degrees = math.radians(1.0)
    return Swing(
        ((0.2, height), (0.5, 0.45 * height), (0.8, height)),
        ((0.17, -70.0 * degrees), (0.5, -18.0 * degrees), (0.78, 15.0 * degrees)),
    )


def shot() -> Score:
    """Return a jump shot of handball, thrown with the left arm.

    Its supports are those of figure 13 of the paper: L D R - L D R D. After two steps the right
    leg takes off; the ball leaves in the air, near the highest point; the left foot lands.
    """
    takeoff, landing = 0.68, 1.04
    up, down = ballistic_speeds(-0.02, landing - takeoff)
    left = Footwork(
        (
            _step(-0.25, 0.38, (0.05, 0.43), 15.0, -62.0, rise=0.3),
            _step(landing, 1.40, (0.04, 2.60), -14.0, -48.0, flat=0.08, rise=0.22),
            _step(1.70, _AFTER, (0.10, 3.56), 6.0, flat=0.1),
        ),
        (
            swing(
                (0.22, 0.07, 0.22, 0.62, -88.0),
                (0.45, 0.09, 0.42, 1.55, -38.0),
                (0.75, 0.07, 0.30, 2.20, -22.0),
                (0.91, 0.05, 0.13, 2.50, -14.0),
            ),
            _stride(height=0.06),
        ),
    )
    right = Footwork(
        (
            _step(-0.6, 0.0, (-0.05, -0.44), 15.0, -60.0),
            _step(0.32, takeoff, (-0.05, 1.215), 16.0, -62.0, flat=0.08, rise=0.2),
            _step(1.32, _AFTER, (-0.09, 3.27), 10.0),
        ),
        (
            _stride(height=0.07),
            swing(
                (0.08, -0.055, 0.10, 1.29, -76.0),
                (0.2, -0.07, 0.25, 1.40, -88.0),
                (0.5, -0.09, 0.36, 1.95, -85.0),
                (0.8, -0.09, 0.12, 2.85, -15.0),
            ),
        ),
    )
    return Score(
        2.3,
        (left, right),
        (
            [
                rest(0.0, 0.01),
                (takeoff, -0.01, 0.04, 0.0),
                (landing, 0.0044, 0.04, 0.0),
                rest(2.1, 0.0),
            ],
            [
                (0.0, 0.895, 0.15, 0.0),
                rest(0.15, 0.92, -2.0),
                rest(0.40, 0.855, 5.0),
                (takeoff, 0.945, up, -GRAVITY),
                (landing, 0.925, down, -GRAVITY),
                rest(1.20, 0.805, 9.0),
                rest(1.48, 0.87, 0.0),
                rest(2.2, 0.925),
            ],
            [
                (0.0, 0.0, 2.3, 0.0),
                (0.34, 0.78, 2.25, 0.0),
                (takeoff, 1.535, 2.2, 0.0),
                (landing, 1.535 + 2.2 * (landing - takeoff), 2.2, 0.0),
                (1.36, 2.88, 1.3, 0.0),
                rest(2.1, 3.32),
            ],
        ),
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
        left_arm=[
            (0.0, 4.0, 18.0, 12.0, -10.0, 60.0),
            (0.3, 15.0, -5.0, 45.0, 10.0, 75.0),
            (0.66, 28.0, 0.0, 92.0, 80.0, 92.0),
            (0.84, 32.0, 0.0, 100.0, 92.0, 82.0),
            (0.96, -62.0, 0.0, 108.0, 55.0, 18.0),
            (1.12, -72.0, 0.0, 62.0, -5.0, 14.0),
            (1.4, -30.0, 0.0, 24.0, -15.0, 25.0),
            (2.1, 4.0, 3.0, 10.0, -15.0, 18.0),
        ],
        right_arm=[
            (0.0, 0.0, -8.0, 12.0, -10.0, 35.0),
            (0.3, 0.0, 30.0, 14.0, -10.0, 50.0),
            (0.66, 28.0, 82.0, 10.0, -10.0, 25.0),
            (0.82, 26.0, 78.0, 12.0, -10.0, 30.0),
            (0.98, 12.0, 10.0, 22.0, -10.0, 75.0),
            (1.2, 20.0, -20.0, 26.0, -10.0, 55.0),
            (2.1, 4.0, 3.0, 10.0, -15.0, 18.0),
        ],
    )


def walk_to_hop() -> Score:
    """Return two steps of the walk and two hops on the right leg: R D L D R - R - R D.

    Figure 14 of the paper: a normal motion coupled with a critical one, so that synchronization
    finds more solutions.
    """
    air = 0.22
    up, down = ballistic_speeds(0.0, air)
    hips = 0.955
    left = Footwork(
        (
            _step(-0.65, 0.0, (0.055, -0.36), 20.0, -60.0, rise=0.28),
            _step(0.40, 1.04, (0.055, 0.985), 20.0, -56.0, rise=0.28),
            _step(2.52, _AFTER, (0.10, 3.05), 5.0),
        ),
        (
            _stride(),
            swing(
                (0.12, 0.08, 0.16, 1.25, -60.0),
                (0.24, 0.10, 0.30, 1.80, -50.0),
                (0.39, 0.11, 0.32, 1.95, -60.0),
                (0.58, 0.11, 0.30, 2.30, -52.0),
                (0.73, 0.11, 0.30, 2.46, -58.0),
                (0.88, 0.11, 0.10, 2.85, -15.0),
            ),
        ),
    )
    hopping = swing((0.3, -0.05, 0.06, 1.78, -45.0), (0.65, -0.04, 0.08, 2.08, -14.0))
    again = swing((0.3, -0.05, 0.06, 2.40, -45.0), (0.65, -0.06, 0.08, 2.66, -14.0))
    right = Footwork(
        (
            _step(-0.12, 0.52, (-0.055, 0.31), 20.0, -58.0, rise=0.28),
            _step(0.92, 1.40, (-0.05, 1.63), 18.0, -52.0, rise=0.2),
            _step(1.62, 1.90, (-0.045, 2.24), -14.0, -50.0, flat=0.08, rise=0.13),
            _step(2.12, _AFTER, (-0.08, 2.83), -14.0),
        ),
        (_stride(), hopping, again),
    )
    return Score(
        3.1,
        (left, right),
        (
            [
                rest(0.0, -0.012),
                rest(0.2, -0.02),
                rest(0.72, 0.02),
                rest(1.2, -0.02),
                rest(1.40, -0.025),
                rest(2.3, -0.035),
                rest(3.0, 0.0),
            ],
            [
                (0.0, 0.915, 0.15, 0.0),
                rest(0.18, 0.936, -2.0),
                rest(0.43, 0.893, 2.0),
                rest(0.70, 0.93, -2.0),
                rest(0.98, 0.9, 2.0),
                rest(1.18, 0.885, 3.0),
                (1.40, hips, up, -GRAVITY),
                (1.62, hips, down, -GRAVITY),
                (1.90, hips, up, -GRAVITY),
                (2.12, hips, down, -GRAVITY),
                rest(2.30, 0.855, 5.0),
                rest(2.9, 0.935),
            ],
            [
                (0.0, 0.0, 1.3, 0.0),
                (1.18, 1.54, 1.25, 0.0),
                (1.40, 1.80, 1.15, 0.0),
                (1.62, 1.80 + 1.15 * air, 1.15, 0.0),
                (1.90, 2.345, 1.0, 0.0),
                (2.12, 2.345 + 1.0 * air, 1.0, 0.0),
                rest(2.85, 2.84),
            ],
        ),
        pelvis=[
            (0.0, 4.0, 3.0, -2.0),
            (0.42, 4.5, 3.0, -3.0),
            (0.94, -4.5, 3.0, 3.0),
            (1.4, 3.0, 5.0, -2.0),
            (2.3, 2.0, 8.0, -2.0),
            (2.9, 0.0, 1.0, 0.0),
        ],
        chest=[
            (0.0, -4.0, 3.0, 0.0),
            (0.42, -5.5, 3.0, 1.5),
            (0.94, 5.5, 4.0, -1.5),
            (1.4, -4.0, 5.0, 4.0),
            (1.75, 0.0, 9.0, 4.0),
            (2.0, -3.0, 6.0, 4.0),
            (2.3, 0.0, 11.0, 3.0),
            (2.95, 0.0, 2.0, 0.0),
        ],
        head=[(0.0, 0.0, 2.0, 0.0), (2.3, 0.0, 4.0, 0.0), (2.9, 0.0, 2.0, 0.0)],
        left_arm=[
            (-0.1, 4.0, 22.0, 9.0, -15.0, 38.0),
            (0.42, 4.0, -18.0, 9.0, -15.0, 18.0),
            (0.94, 4.0, 22.0, 10.0, -15.0, 38.0),
            (1.2, 4.0, -14.0, 20.0, -10.0, 45.0),
            (1.45, 6.0, 28.0, 26.0, -10.0, 65.0),
            (1.72, 6.0, -6.0, 24.0, -10.0, 55.0),
            (1.96, 6.0, 26.0, 26.0, -10.0, 65.0),
            (2.3, 6.0, 2.0, 26.0, -10.0, 45.0),
            (2.95, 4.0, 3.0, 9.0, -15.0, 17.0),
        ],
        right_arm=[
            (-0.1, 4.0, -18.0, 9.0, -15.0, 18.0),
            (0.42, 4.0, 22.0, 9.0, -15.0, 38.0),
            (0.94, 4.0, -18.0, 10.0, -15.0, 20.0),
            (1.2, 4.0, -18.0, 20.0, -10.0, 40.0),
            (1.45, 6.0, 28.0, 26.0, -10.0, 65.0),
            (1.72, 6.0, -6.0, 24.0, -10.0, 55.0),
            (1.96, 6.0, 26.0, 26.0, -10.0, 65.0),
            (2.3, 6.0, 2.0, 26.0, -10.0, 45.0),
            (2.95, 4.0, 3.0, 9.0, -15.0, 17.0),
        ],
    )
