"""Pops: frames in which a joint jumps, seen as speed and acceleration that no clip has."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import astuple, dataclass

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.report.spreads import rounded
from footfall.report.track import RATE

__all__ = ["Pops", "joint_pops"]

SLOWEST = 0.1
"""A clip that plays slower than this counts as playing at this rate: where it nearly stands, a
tremor divided by its rate would look like a pop."""


@dataclass(frozen=True, slots=True)
class Pops:
    """The fastest that joints move, for the rate at which their clips play (measures, section 1).

    Every number may also be a ratio to the same number of other motions: see `over`.
    """

    speed_p999: float
    """99.9th percentile, over all joints and frames, of speed / clip rate [m/s]."""

    speed_max: float
    """The greatest [m/s]."""

    acceleration_p999: float
    """99.9th percentile of acceleration / clip rate² [m/s²]."""

    acceleration_max: float
    """The greatest [m/s²]."""

    root_acceleration_p99: float
    """99th percentile, over all frames, of the pelvis's acceleration / clip rate² [m/s²]."""

    def over(self, sources: Pops) -> Pops | None:
        """Return the ratio to the figures of the source clips; None where a clip stands still."""
        pairs = list(zip(astuple(self), astuple(sources), strict=True))
        if any(source == 0.0 for _, source in pairs):
            return None
        return Pops(*(own / source for own, source in pairs))

    @classmethod
    def greatest(cls, of: Iterable[Pops]) -> Pops:
        """Return the greatest of each number over several motions: the liveliest clip's."""
        return cls(*(max(values) for values in zip(*map(astuple, of), strict=True)))

    def to_json(self) -> dict[str, float | None]:
        """Return the numbers by name for a report."""
        return {
            "speed_p99_9": rounded(self.speed_p999),
            "speed_max": rounded(self.speed_max),
            "acceleration_p99_9": rounded(self.acceleration_p999),
            "acceleration_max": rounded(self.acceleration_max),
            "root_acceleration_p99": rounded(self.root_acceleration_p99),
        }


def joint_pops(joints: Positions, rates: Floats | None = None) -> Pops | None:
    """Measure how fast joints move and how hard they are accelerated, over every frame.

    Args:
        joints: Joints in the world at 60 Hz [m], shape (frames, joints, 3), the pelvis first.
        rates: Clip time per clock time, shape (frames,); None: 1 throughout.

    Returns:
        The figures, by differences between neighboring frames; None below three frames.
    """
    if len(joints) < 3:
        return None
    rates = np.maximum(np.ones(len(joints)) if rates is None else rates, SLOWEST)
    between = 0.5 * (rates[1:] + rates[:-1])
    speeds = np.linalg.norm(np.diff(joints, axis=0), axis=-1) * RATE
    speeds /= between[:, np.newaxis]
    accelerations = np.linalg.norm(np.diff(joints, n=2, axis=0), axis=-1) * RATE**2
    accelerations /= rates[1:-1, np.newaxis] ** 2
    return Pops(
        speed_p999=float(np.percentile(speeds, 99.9)),
        speed_max=float(speeds.max()),
        acceleration_p999=float(np.percentile(accelerations, 99.9)),
        acceleration_max=float(accelerations.max()),
        root_acceleration_p99=float(np.percentile(accelerations[:, 0], 99.0)),
    )
