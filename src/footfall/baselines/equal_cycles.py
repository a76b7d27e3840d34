"""A cross-fade whose cycles are scaled to one length: what most engines and libraries offer.

It imitates the blend trees and one-dimensional blend spaces of game engines with normalized time,
and the blending sample of ozz-animation (``loop_duration = Σ weight × duration``): all cycles that
play share one normalized time and last their weighted mean duration. As users of those are told
to, cycles are counted from the landing of the same foot, and a clip of several strides counts as
several cycles. What is played once is not scaled.
"""

from __future__ import annotations

from collections.abc import Sequence

from footfall.baselines.landings import landings
from footfall.baselines.pacing import Playing
from footfall.support import SupportSequence

__all__ = ["EqualCycles"]


class EqualCycles:
    """All cycles at one normalized time; see `Pacing`."""

    def clip_times(self, playing: Sequence[Playing], dt: float) -> list[float]:
        """Return where each clip is `dt` seconds later [s]; see `Pacing.clip_times`."""
        cycles = [one for one in playing if one.supports.cyclic]
        settled = next((one for one in cycles if not one.entering), None)
        leading = settled or (cycles[0] if cycles else None)
        common = 0.0 if leading is None else _phase(leading.supports, leading.clip_time)
        share = dt / _mean_duration(cycles) if cycles else 0.0
        times: list[float] = []
        for one in playing:
            if not one.supports.cyclic:
                times.append(one.clip_time + dt)
                continue
            begin = one.clip_time
            origin, stride = _stride(one.supports)
            if one.entering:
                begin = (origin + common * stride) % one.supports.duration
            times.append(begin + share * stride)
        return times


def _stride(supports: SupportSequence) -> tuple[float, float]:
    """Return when the first stride of a cycle begins and how long each one lasts [s]."""
    found = landings(supports)
    for foot in (0, 1):
        own = [landing.time for landing in found if landing.foot == foot]
        if own:
            return own[0], supports.duration / len(own)
    return 0.0, supports.duration


def _phase(supports: SupportSequence, clip_time: float) -> float:
    origin, stride = _stride(supports)
    return ((clip_time - origin) / stride) % 1.0


def _mean_duration(cycles: Sequence[Playing]) -> float:
    total = sum(one.weight for one in cycles)
    strides = [_stride(one.supports)[1] for one in cycles]
    if total <= 0.0:
        return sum(strides) / len(strides)
    return sum(one.weight * s for one, s in zip(cycles, strides, strict=True)) / total
