"""A motion that happens once, written as keys: like a choreographer's score."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from footfall.arrays import Floats, Seconds
from footfall.motion import Clip
from footfall.samples.curves import Knot, keyed, quintic
from footfall.samples.footsteps import FootPath, Stance, Swing, foot_path
from footfall.samples.performance import Performance
from footfall.support import Support, SupportPhase, SupportSequence

__all__ = ["ArmKey", "Footwork", "Score", "TrunkKey", "play", "rest", "swing"]

TrunkKey = tuple[float, float, float, float]
"""A time [s], and there heading, lean and tilt [degrees]."""

ArmKey = tuple[float, float, float, float, float, float]
"""A time [s], and there the angles of `arm_rotations` [degrees]."""


@dataclass(frozen=True, slots=True)
class Footwork:
    """What one foot does."""

    stances: tuple[Stance, ...]
    swings: tuple[Swing, ...] = ()


@dataclass(frozen=True, slots=True)
class Score:
    """A motion that happens once. The supports follow from the stances of the feet."""

    duration: float
    """[s]"""

    feet: tuple[Footwork, Footwork]
    """Left and right foot."""

    pelvis_path: tuple[Sequence[Knot], Sequence[Knot], Sequence[Knot]]
    """x, y and z of the pelvis [m, s]."""

    pelvis: Sequence[TrunkKey]
    chest: Sequence[TrunkKey]
    head: Sequence[TrunkKey]
    left_arm: Sequence[ArmKey]
    right_arm: Sequence[ArmKey]


def rest(time: float, value: float, acceleration: float = 0.0) -> Knot:
    """Return the knot of a curve that stops or turns there."""
    return (time, value, 0.0, acceleration)


def swing(*points: tuple[float, float, float, float, float]) -> Swing:
    """Return a swing through points: share of it, x, clearance and z [m], pitch [degrees]."""
    return Swing(
        tuple((share, clearance) for share, _, clearance, _, _ in points),
        tuple((share, math.radians(pitch)) for share, _, _, _, pitch in points),
        tuple((share, x, z) for share, x, _, z, _ in points),
    )


def play(score: Score, name: str, fps: float) -> tuple[Clip, SupportSequence]:
    """Return a score's clip and its exact supports, up to the last frame that fits."""
    times = np.arange(math.floor(score.duration * fps + 1e-6) + 1) / fps
    left, right = (foot_path(times, foot.stances, foot.swings) for foot in score.feet)
    clip = _performance(score, times, (left, right)).clip(times, fps, name=name, cyclic=False)
    return clip, _supports(score, float(times[-1]))


def _angles(times: Seconds, keys: Sequence[Sequence[float]]) -> Floats:
    table = np.array(keys)
    return np.radians(keyed(times, [float(node) for node in table[:, 0]], table[:, 1:]))


def _performance(score: Score, times: Seconds, feet: tuple[FootPath, FootPath]) -> Performance:
    return Performance(
        np.stack([quintic(times, knots) for knots in score.pelvis_path], axis=-1),
        _angles(times, score.pelvis),
        _angles(times, score.chest),
        _angles(times, score.head),
        np.stack([_angles(times, score.left_arm), _angles(times, score.right_arm)], axis=1),
        feet,
    )


def _supports(score: Score, end: float) -> SupportSequence:
    def carries(foot: Footwork, time: float) -> bool:
        return any(stance.strike <= time < stance.leave for stance in foot.stances)

    edges = {
        edge
        for foot in score.feet
        for stance in foot.stances
        for edge in (stance.strike, stance.leave)
        if 0.0 < edge < end
    }
    bounds = [0.0, *sorted(edges), end]
    left, right = score.feet
    return SupportSequence(
        tuple(
            SupportPhase(
                Support.from_feet(
                    carries(left, 0.5 * (begin + stop)), carries(right, 0.5 * (begin + stop))
                ),
                stop - begin,
            )
            for begin, stop in pairwise(bounds)
        )
    )
