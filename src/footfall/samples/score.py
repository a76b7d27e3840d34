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

__all__ = ["ArmKey", "Footwork", "Score", "Trunk", "TrunkKey", "play"]

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
class Trunk:
    """How the trunk turns and leans, each part in the world."""

    pelvis: Sequence[TrunkKey]
    chest: Sequence[TrunkKey]
    head: Sequence[TrunkKey]


@dataclass(frozen=True, slots=True)
class Score:
    """A motion that happens once. The supports follow from the stances of the feet."""

    duration: float
    """[s]"""

    feet: tuple[Footwork, Footwork]
    """Left and right foot."""

    path: tuple[Sequence[Knot], Sequence[Knot], Sequence[Knot]]
    """x, y and z of the pelvis [m, s]."""

    trunk: Trunk
    """How it turns and leans."""

    arms: tuple[Sequence[ArmKey], Sequence[ArmKey]]
    """Left and right arm."""


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
        np.stack([quintic(times, knots) for knots in score.path], axis=-1),
        _angles(times, score.trunk.pelvis),
        _angles(times, score.trunk.chest),
        _angles(times, score.trunk.head),
        np.stack([_angles(times, keys) for keys in score.arms], axis=1),
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
