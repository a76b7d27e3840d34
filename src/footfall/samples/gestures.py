"""The samples that happen in one place: kick, punch and jump."""

from __future__ import annotations

import math

from footfall.samples.curves import GRAVITY, ballistic_speeds
from footfall.samples.footsteps import Stance
from footfall.samples.score import Footwork, Score, rest, swing

__all__ = ["jump", "kick", "punch"]

_BEFORE, _AFTER = -10.0, 60.0
"""A foot that stands when a motion begins has stood since long; likewise after its end [s]."""

_STANDING = 0.953
"""Height of the pelvis in an easy stance [m]."""

_RELAXED = (4.0, 3.0, 9.0, -15.0, 17.0)
"""A hanging arm [degrees]."""


def _stand(ball: tuple[float, float], side: float, *, since: float = _BEFORE) -> Stance:
    return Stance(since, _AFTER, ball, heading=side * math.radians(8.0), rise=0.1)


def kick() -> Score:
    """Return a kick with the right instep at what lies ahead: weight over, back, through, down.

    The order of its parts (backswing, leg cocking, swing to contact, follow-through) is that of
    the soccer kick in Lees et al., "The biomechanics of soccer: a review", J. Sports Sci. 28,
    2010.
    """
    off, on = 0.45, 1.65
    right = (
        Stance(
            _BEFORE,
            off,
            (-0.11, 0.11),
            heading=math.radians(-8.0),
            leave_pitch=math.radians(-40.0),
            rise=0.25,
        ),
        Stance(
            on,
            _AFTER,
            (-0.11, 0.11),
            heading=math.radians(-8.0),
            strike_pitch=math.radians(-12.0),
            flat=0.14,
        ),
    )
    through = swing(
        (0.16, -0.09, 0.20, -0.36, -85.0),
        (0.28, -0.08, 0.33, -0.56, -112.0),
        (0.41, -0.03, 0.035, 0.40, -32.0),
        (0.51, 0.0, 0.42, 0.84, 8.0),
        (0.60, -0.02, 0.40, 0.72, 2.0),
        (0.78, -0.08, 0.13, 0.22, -22.0),
    )
    return Score(
        2.1,
        (Footwork((_stand((0.11, 0.11), 1.0),)), Footwork(right, (through,))),
        (
            [rest(0.0, 0.0), rest(0.5, 0.075), rest(1.35, 0.075), rest(2.0, 0.0)],
            [rest(0.0, _STANDING), rest(0.6, 0.925), rest(1.05, 0.945), rest(2.05, _STANDING)],
            [rest(0.0, 0.0), rest(0.7, 0.02), rest(1.05, 0.05), rest(1.6, 0.0)],
        ),
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
        left_arm=[
            (0.1, *_RELAXED),
            (0.72, 35.0, 15.0, 62.0, 0.0, 25.0),
            (1.05, -25.0, 45.0, 30.0, 0.0, 40.0),
            (1.35, 0.0, 25.0, 22.0, -5.0, 35.0),
            (1.9, *_RELAXED),
        ],
        right_arm=[
            (0.1, *_RELAXED),
            (0.75, 0.0, 18.0, 22.0, -10.0, 40.0),
            (1.05, 20.0, -28.0, 38.0, -5.0, 28.0),
            (1.4, 8.0, -6.0, 20.0, -10.0, 25.0),
            (1.9, *_RELAXED),
        ],
    )


def punch() -> Score:
    """Return a straight right (a cross) from a guard; both feet stay, the rear heel turns up."""
    lifts = ((0.62, 0.0), (0.86, math.radians(-28.0)), (1.0, math.radians(-28.0)), (1.3, 0.0))
    rear = Stance(
        _BEFORE, _AFTER, (-0.13, -0.03), heading=math.radians(-22.0), rise=0.1, lifts=lifts
    )
    guard_left = (-6.0, 52.0, 12.0, 0.0, 112.0)
    guard_right = (0.0, 40.0, 14.0, 0.0, 128.0)
    return Score(
        2.0,
        (Footwork((_stand((0.11, 0.25), 1.0),)), Footwork((rear,))),
        (
            [rest(0.0, 0.0), rest(0.62, -0.02), rest(0.86, 0.03), rest(1.3, 0.0), rest(1.9, 0.0)],
            [rest(0.0, 0.943), rest(0.5, 0.915), rest(0.86, 0.905), rest(1.9, 0.943)],
            [rest(0.0, 0.0), rest(0.62, -0.03), rest(0.86, 0.07), rest(1.0, 0.07), rest(1.5, 0.0)],
        ),
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
        left_arm=[
            (0.08, *_RELAXED),
            (0.42, *guard_left),
            (0.86, -2.0, 38.0, 12.0, 0.0, 128.0),
            (1.35, *guard_left),
            (1.9, *_RELAXED),
        ],
        right_arm=[
            (0.08, *_RELAXED),
            (0.42, *guard_right),
            (0.64, 10.0, 26.0, 16.0, 0.0, 130.0),
            (0.86, 38.0, 84.0, 4.0, -25.0, 6.0),
            (0.98, 38.0, 84.0, 4.0, -25.0, 8.0),
            (1.35, *guard_right),
            (1.9, *_RELAXED),
        ],
    )


def jump() -> Score:
    """Return a jump with both feet: crouch with the arms back, throw them up, fly, absorb.

    The parabola of the pelvis is that of free fall: 0.42 s in the air.
    """
    off, on = 0.70, 1.12
    off_height, on_height = 1.0, 0.965
    up, down = ballistic_speeds(on_height - off_height, on - off)

    def foot(side: float) -> Footwork:
        x, heading = side * 0.12, side * math.radians(8.0)
        return Footwork(
            (
                Stance(
                    _BEFORE,
                    off,
                    (x, 0.11),
                    heading,
                    leave_pitch=math.radians(-58.0),
                    rise=0.24,
                ),
                Stance(on, _AFTER, (x, 0.48), heading, math.radians(-26.0), flat=0.1),
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

    return Score(
        2.0,
        (foot(1.0), foot(-1.0)),
        (
            [rest(0.0, 0.0), rest(2.0, 0.0)],
            [
                rest(0.0, _STANDING),
                rest(0.42, 0.68, 9.0),
                (off, off_height, up, -GRAVITY),
                (on, on_height, down, -GRAVITY),
                rest(1.36, 0.73, 9.0),
                rest(1.95, _STANDING),
            ],
            [
                rest(0.0, 0.0),
                rest(0.40, -0.03),
                (off, 0.10, 0.72, 0.0),
                (on, 0.10 + 0.72 * (on - off), 0.72, 0.0),
                rest(1.75, 0.37),
            ],
        ),
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
        left_arm=_JUMPING_ARM,
        right_arm=_JUMPING_ARM,
    )


_JUMPING_ARM = [
    (0.05, *_RELAXED),
    (0.40, 6.0, -52.0, 14.0, -10.0, 12.0),
    (0.74, 6.0, 140.0, 16.0, 0.0, 22.0),
    (0.92, 8.0, 125.0, 22.0, 0.0, 25.0),
    (1.14, 10.0, 70.0, 28.0, 0.0, 25.0),
    (1.40, 6.0, 5.0, 20.0, -5.0, 25.0),
    (1.9, *_RELAXED),
]
