"""One cycle of a gait, rolled out so that cycles of several clips can be laid over each other."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from footfall.actions.cycle_poses import root_way, root_ways
from footfall.arrays import Floats, Seconds, SmallFloats
from footfall.errors import ArgumentError
from footfall.support import Support, SupportSequence

__all__ = ["ONE_FOOT", "GaitCycle", "aligned_to", "check_distinct"]

ONE_FOOT = (Support.LEFT, Support.RIGHT)
"""What a step stands on."""


@dataclass(frozen=True, eq=False)
class GaitCycle:
    """A cyclic clip as normalized poses, three times in a row, beginning with one of its phases."""

    name: str
    """What messages call it."""

    keys: SmallFloats
    """Normalized poses, shape (3 frames - 2, channels)."""

    roots: Floats
    """Root of each: x and z in leg lengths, heading [rad], shape (3 frames - 2, 3)."""

    fps: float
    """Frames per second."""

    supports: tuple[Support, ...]
    """What its phases stand on."""

    starts: Seconds
    """When they begin in `keys`, in the second of the three cycles, and when the last one ends
    [s], shape (phases + 1,)."""

    @classmethod
    def of(
        cls, name: str, keys: SmallFloats, roots: Floats, fps: float, supports: SupportSequence
    ) -> GaitCycle:
        """Roll out a packed clip, beginning with its first phase on one foot.

        Args:
            name: What messages call it.
            keys: Normalized poses of one cycle, its last frame the first again, (frames, ...).
            roots: As in `GaitCycle`, shape (frames, 3).
            fps: Frames per second.
            supports: Of the clip.

        Raises:
            ArgumentError: If the clip is not cyclic, or never stands on one foot.
        """
        if not supports.cyclic:
            raise ArgumentError(f"{name} is not cyclic; a locomotion is made of cycles")
        kinds = tuple(phase.support for phase in supports.phases)
        first = next((index for index, kind in enumerate(kinds) if kind in ONE_FOOT), None)
        if first is None:
            raise ArgumentError(
                f"{name} stands on {supports}; a locomotion is made of steps, on one foot and "
                "then on the other"
            )
        rest = np.array([phase.duration for phase in supports.phases])
        lengths = np.roll(rest, -first)
        return cls(
            name,
            np.concatenate([keys, keys[1:], keys[1:]]),
            _thrice(roots),
            fps,
            kinds[first:] + kinds[:first],
            _in_second_cycle(float(supports.boundaries[first]), supports.duration, lengths),
        )

    @property
    def duration(self) -> float:
        """Of one cycle [s]."""
        return float(self.starts[-1] - self.starts[0])

    @property
    def stride(self) -> tuple[float, float]:
        """How far the root goes forward in a cycle, in leg lengths, and how far it turns [rad]."""
        once = self.roots[: (len(self.roots) + 2) // 3]
        _, along, turn = root_ways(once).sum(axis=0).tolist()
        return along, turn

    def beginning_with(self, phase: int) -> GaitCycle:
        """Return the same cycle, beginning with another of its phases."""
        count = len(self.supports)
        lengths = np.roll(np.diff(self.starts), -phase)
        return GaitCycle(
            self.name,
            self.keys,
            self.roots,
            self.fps,
            tuple(self.supports[(phase + index) % count] for index in range(count)),
            _in_second_cycle(float(self.starts[phase]), self.duration, lengths),
        )


def _in_second_cycle(begin: float, period: float, lengths: Seconds) -> Seconds:
    """Return the boundaries of phases of these lengths, the first one in [period, 2 periods)."""
    begin += (1 - math.floor(begin / period + 1e-9)) * period
    return begin + np.concatenate([[0.0], np.cumsum(lengths)])


def _thrice(roots: Floats) -> Floats:
    """Return a root's way over three cycles, each from where the one before ends."""
    steps = root_ways(roots)
    rows = [roots]
    for _ in range(2):
        rows.append(root_way(steps, rows[-1][-1])[1:])
    return np.concatenate(rows)


def aligned_to(reference: GaitCycle, other: GaitCycle) -> GaitCycle:
    """Return a cycle that begins with the phase that answers the first one of another.

    Each phase on one foot answers one on the same foot; between them a double support may answer
    a flight, which is how a walk becomes a run.

    Raises:
        ArgumentError: If the two have other feet, or another number of phases.
    """
    count = len(reference.supports)
    best, most = -1, -1
    if len(other.supports) == count:
        for shift in range(count):
            turned = other.supports[shift:] + other.supports[:shift]
            pairs = list(zip(reference.supports, turned, strict=True))
            if not all(one is two for one, two in pairs if one in ONE_FOOT or two in ONE_FOOT):
                continue
            equal = sum(one is two for one, two in pairs)
            if equal > most:
                best, most = shift, equal
    if best < 0:
        symbols = [" ".join(s.symbol for s in cycle.supports) for cycle in (reference, other)]
        raise ArgumentError(
            f"{other.name} steps {symbols[1]}, {reference.name} {symbols[0]}; the clips of a "
            "locomotion must step on the same feet in the same order"
        )
    return other.beginning_with(best)


def check_distinct(cycles: list[tuple[str, float, float]]) -> None:
    """Refuse two cycles of one speed and turn: nothing says which of them is meant.

    Args:
        cycles: Name, speed [m/s] and turn [rad/s] of each, in order of speed.

    Raises:
        ArgumentError: If there are two.
    """
    for (one, speed, turn), (other, faster, farther) in pairwise(cycles):
        if faster - speed < 0.05 and abs(farther - turn) < 0.05:
            raise ArgumentError(
                f"{one} and {other} both go at {speed:.2f} m/s and turn by {turn:.2f} rad/s; the "
                "clips of a locomotion must differ in one of them"
            )
