"""Stretches of time during which something holds: found in samples, cleaned of flicker."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from footfall.arrays import Flags, Floats

__all__ = ["Interval", "covers", "runs", "united", "without_short_ones"]


@dataclass(frozen=True, slots=True)
class Interval:
    """A stretch of clip time; on a cycle it begins in [0, duration) and may end beyond it."""

    start: float
    """[s]"""

    end: float
    """[s]"""

    start_confidence: float = 1.0
    """How sharply it begins, 0 to 1; 1 also where the clip itself begins."""

    end_confidence: float = 1.0
    """How sharply it ends, 0 to 1; 1 also where the clip itself ends."""

    @property
    def duration(self) -> float:
        """[s]."""
        return self.end - self.start

    def later(self, seconds: float) -> Interval:
        """Return the same stretch so much later [s]."""
        sure = (self.start_confidence, self.end_confidence)
        return Interval(self.start + seconds, self.end + seconds, *sure)

    def joined(self, other: Interval) -> Interval:
        """Return the stretch from the start of this to the end of the other."""
        return Interval(self.start, other.end, self.start_confidence, other.end_confidence)


def runs(flags: Flags) -> list[tuple[int, int]]:
    """Return first sample, and the one after the last, of each run of set flags, in order."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(np.int8)))
    return [(int(first), int(end)) for first, end in edges.reshape(-1, 2)]


def united(intervals: Iterable[Interval]) -> list[Interval]:
    """Return when any of some intervals holds: in order, those that overlap as one."""
    joined: list[Interval] = []
    for interval in sorted(intervals, key=lambda one: one.start):
        if joined and interval.start <= joined[-1].end:
            if interval.end > joined[-1].end:
                joined[-1] = joined[-1].joined(interval)
        else:
            joined.append(interval)
    return joined


def without_short_ones(
    intervals: list[Interval], minimum: float, duration: float, *, cyclic: bool
) -> tuple[Interval, ...]:
    """Return intervals with no gap and then no interval shorter than the minimum.

    What is cut off by the clip's first or last frame may be shorter: nobody knows how long it
    would last, unless the clip is cyclic.

    Args:
        intervals: In order, not overlapping; on a cycle they start in [0, duration).
        minimum: [s].
        duration: Of the clip [s].
        cyclic: Whether the last interval is followed by the first.
    """
    joined: list[Interval] = []
    for interval in intervals:
        if joined and interval.start - joined[-1].end < minimum:
            joined[-1] = joined[-1].joined(interval)
        else:
            joined.append(interval)
    if cyclic and joined:
        first, last = joined[0], joined[-1]
        gap = first.start + duration - last.end
        if gap < minimum:
            if len(joined) == 1:
                return (Interval(0.0, duration),)
            joined = [*joined[1:-1], last.joined(first.later(duration))]
    return tuple(i for i in joined if i.duration >= minimum - 1e-9)


def covers(
    intervals: tuple[Interval, ...], times: Floats, duration: float, *, cyclic: bool
) -> Flags:
    """Return whether any of the intervals holds at each clip time [s], shape of `times`."""
    result = np.zeros(times.shape, dtype=np.bool_)
    for interval in intervals:
        for shift in (0.0, duration) if cyclic else (0.0,):
            result |= (times + shift >= interval.start) & (times + shift < interval.end)
        if not cyclic and interval.end >= duration - 1e-9:
            result |= times >= interval.end - 1e-9
    return result
