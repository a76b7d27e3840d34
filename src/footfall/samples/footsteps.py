"""Where the feet are: fixed and rolling while they carry, on splines between.

A foot is one rigid piece from heel to ball, with toes that bend. While it stands it rolls
without slipping: about the heel while its toes are up, about the ball (the toe joint, the toes
staying flat) while its heel is up. These are the heel, ankle and forefoot rockers of Perry and
Burnfield, *Gait Analysis*, chapter 3. So the point that carries is fixed by construction, and
the first and the last instant of contact are exact.

A foot's pitch is positive where the toes are higher than the heel.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from footfall.arrays import Floats, Positions, Rotations, Seconds
from footfall.geometry import from_euler, rotate
from footfall.samples.body import HEEL_FROM_ANKLE, TOE_FROM_ANKLE
from footfall.samples.curves import keyed, quintic, waypoints

__all__ = ["FootPath", "Stance", "Swing", "foot_path", "foot_rotations"]

_ARM = tuple(toe - heel for toe, heel in zip(TOE_FROM_ANKLE, HEEL_FROM_ANKLE, strict=True))
"""From the heel to the ball, in the foot's frame [m]."""

_ROLL_OFF = 2.5
"""Exponent of the heel's rise: slow at first, fastest as the foot leaves."""

_TOE_RELEASE = 0.45
"""Share of a swing in which the toes straighten."""


@dataclass(frozen=True, slots=True)
class Stance:
    """One stay of a foot on the ground."""

    strike: float
    """When its first point touches [s]."""

    leave: float
    """When its last point leaves [s]."""

    ball: tuple[float, float]
    """Where the ball stands: x and z [m]."""

    heading: float = 0.0
    """Where the toes point: a turn about the vertical [rad]."""

    strike_pitch: float = 0.0
    """The foot's pitch as it touches [rad]: positive lands on the heel."""

    leave_pitch: float = 0.0
    """The foot's pitch as it leaves [rad]: negative leaves from the ball."""

    flat: float = 0.1
    """How long after the strike it has come down flat [s]."""

    rise: float = 0.2
    """How long before leaving it begins to roll off [s]."""

    lifts: tuple[tuple[float, float], ...] = ()
    """(time [s], pitch [rad]) keys of a heel that rises and comes down again while it stands."""

    landing: float = 0.5
    """Speed of rolling at the strike, as a share of the mean speed until flat."""


@dataclass(frozen=True, slots=True)
class Swing:
    """How a foot travels from one stance to the next; times are shares of the swing."""

    clearance: tuple[tuple[float, float], ...]
    """(share, height over the ground of the sole's lower end, ball or heel [m])."""

    pitch: tuple[tuple[float, float], ...] = ()
    """(share, pitch [rad])."""

    path: tuple[tuple[float, float, float], ...] = ()
    """(share, x, z) that the ball passes on the ground plan [m]."""


@dataclass(frozen=True, eq=False)
class FootPath:
    """One foot over time."""

    balls: Positions
    """Where the toe joint is [m], shape (times, 3)."""

    angles: Floats
    """Heading, pitch and bend of the toes (up) [rad], shape (times, 3)."""

    @property
    def ankles(self) -> Positions:
        """Where the ankle is [m], shape (times, 3)."""
        return self.balls - rotate(self.rotations, np.array(TOE_FROM_ANKLE))

    @property
    def rotations(self) -> Rotations:
        """How the foot is turned, shape (times, 4)."""
        return foot_rotations(self.angles)


def foot_rotations(angles: Floats) -> Rotations:
    """Return a foot's rotations, shape (..., 4), from heading and pitch, shape (..., 2 or 3)."""
    return from_euler("YX", np.stack([angles[..., 0], -angles[..., 1]], axis=-1))


def foot_path(times: Seconds, stances: Sequence[Stance], swings: Sequence[Swing]) -> FootPath:
    """Return a foot's path.

    Args:
        times: Where to evaluate [s]; within the first strike and the last leave.
        stances: When and where it stands, in order.
        swings: How it gets from each to the next; repeated where there are too few.
    """
    path = FootPath(np.empty((len(times), 3)), np.empty((len(times), 3)))
    for stance in stances:
        inside = (times >= stance.strike) & (times <= stance.leave)
        path.balls[inside], path.angles[inside] = _standing(times[inside], stance)
    for index, (one, other) in enumerate(pairwise(stances)):
        inside = (times > one.leave) & (times < other.strike)
        if inside.any():
            swing = swings[index % len(swings)]
            path.balls[inside], path.angles[inside] = _swinging(times[inside], one, other, swing)
    return path


@dataclass(frozen=True, slots=True)
class _Edge:
    """The foot at the first or last instant of a stance."""

    ball: Positions
    velocity: Positions
    pitch: float
    rate: float = field(default=0.0)


def _lowest_on_ground(pitch: Floats) -> Floats:
    """Return how high the ball is when the foot stands pitched on its heel or its ball [m]."""
    lifted = np.maximum(pitch, 0.0)
    return _ARM[1] * np.cos(lifted) + _ARM[2] * np.sin(lifted)


def _rolled(pitch: Floats, stance: Stance) -> Positions:
    """Return where the ball is when the foot is pitched on its heel; fixed if it is not."""
    lifted = np.maximum(pitch, 0.0)
    ahead = _ARM[2] * (np.cos(lifted) - 1.0) - _ARM[1] * np.sin(lifted)
    return np.stack(
        [
            stance.ball[0] + ahead * np.sin(stance.heading),
            _lowest_on_ground(pitch),
            stance.ball[1] + ahead * np.cos(stance.heading),
        ],
        axis=-1,
    )


def _pitch(times: Seconds, stance: Stance) -> Floats:
    touch = stance.strike_pitch
    rate = -stance.landing * touch / stance.flat
    down = quintic(
        times, [(stance.strike, touch, rate, 0.0), (stance.strike + stance.flat, 0.0, 0.0, 0.0)]
    )
    off = np.clip((times - stance.leave + stance.rise) / stance.rise, 0.0, None)
    pitch = down + stance.leave_pitch * off**_ROLL_OFF
    if stance.lifts:
        nodes, lifted = zip(*stance.lifts, strict=True)
        pitch = pitch + keyed(times, nodes, np.array(lifted))
    return pitch


def _standing(times: Seconds, stance: Stance) -> tuple[Positions, Floats]:
    pitch = _pitch(times, stance)
    heading = np.full_like(pitch, stance.heading)
    return _rolled(pitch, stance), np.stack([heading, pitch, np.maximum(-pitch, 0.0)], axis=-1)


def _edge(stance: Stance, *, leaving: bool) -> _Edge:
    if leaving:
        pitch, rate = stance.leave_pitch, _ROLL_OFF * stance.leave_pitch / stance.rise
    else:
        pitch = stance.strike_pitch
        rate = -stance.landing * pitch / stance.flat
    near = np.array([pitch - 1e-6, pitch + 1e-6])
    below, above = _rolled(near, stance)
    velocity = (above - below) / 2e-6 * rate
    return _Edge(_rolled(np.array([pitch]), stance)[0], velocity, pitch, rate)


def _swinging(times: Seconds, one: Stance, other: Stance, swing: Swing) -> tuple[Positions, Floats]:
    start, end = one.leave, other.strike
    off, on = _edge(one, leaving=True), _edge(other, leaving=False)

    def through(
        first: float,
        inner: Sequence[tuple[float, float]],
        last: float,
        slopes: tuple[float, float],
        at: Seconds,
    ) -> Floats:
        within = [(start + share * (end - start), value) for share, value in inner]
        return waypoints(at, [(start, first), *within, (end, last)], slopes)

    pitch = through(off.pitch, swing.pitch, on.pitch, (off.rate, on.rate), times)
    nodes = np.array([start + share * (end - start) for share, _ in swing.clearance])
    pitched = through(off.pitch, swing.pitch, on.pitch, (off.rate, on.rate), nodes)
    heights = _lowest_on_ground(pitched) + np.array([height for _, height in swing.clearance])
    columns = (
        [(share, x) for share, x, _ in swing.path],
        [(share, height) for (share, _), height in zip(swing.clearance, heights, strict=True)],
        [(share, z) for share, _, z in swing.path],
    )
    balls = [
        through(off.ball[i], columns[i], on.ball[i], (off.velocity[i], on.velocity[i]), times)
        for i in range(3)
    ]
    heading = through(one.heading, (), other.heading, (0.0, 0.0), times)
    bent = (max(-off.pitch, 0.0), max(-on.pitch, 0.0))
    rates = (-off.rate if off.pitch < 0.0 else 0.0, -on.rate if on.pitch < 0.0 else 0.0)
    bend = through(bent[0], ((_TOE_RELEASE, 0.15 * bent[0]),), bent[1], rates, times)
    return np.stack(balls, axis=-1), np.stack([heading, pitch, bend], axis=-1)
