"""The same measures of the source clips: a result can hardly be cleaner than they are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Positions, Rotations, Seconds
from footfall.geometry import conjugate, from_yaw, multiply, rotate
from footfall.motion import Clip, with_soles
from footfall.report.slip import measure_spans
from footfall.report.trace import Trace
from footfall.report.track import RATE, Track
from footfall.skeleton import Anatomy
from footfall.support import SupportSequence

__all__ = ["SourceSlips", "clip_trace", "mean_source_slips"]

CYCLES = 3
"""How often a cyclic clip is played to measure its spans: the middle time they are all whole."""


@dataclass(frozen=True, eq=False)
class SourceSlips:
    """How much the feet of one clip slip in its own supports."""

    by_frame: Floats
    """Inner slip [m] of the span that each 60 Hz frame belongs to, zero where nothing is left of
    it without its edges, NaN where the foot does not carry; shape (frames, 2 feet). A cyclic
    clip is there `CYCLES` times."""

    duration: float
    """Of the clip [s]."""

    cyclic: bool
    """Whether it starts over after its end."""

    @classmethod
    def of(cls, clip: Clip, anatomy: Anatomy, supports: SupportSequence) -> SourceSlips:
        """Measure a clip in its own supports."""
        track = Track.from_trace(clip_trace(clip, anatomy, supports, CYCLES if clip.cyclic else 1))
        by_frame = np.full((track.frames, 2), np.nan)
        for measure in measure_spans(track):
            span = measure.span
            by_frame[span.start : span.stop, span.foot] = measure.inner_slip or 0.0
        return cls(by_frame, clip.duration, clip.cyclic)

    def at(self, clip_times: Seconds) -> Floats:
        """Return the inner slip [m] of the spans at clip times, past the ends too.

        Args:
            clip_times: Times in the clip [s], shape (frames,).

        Returns:
            One number a foot, shape (frames, 2); NaN where it does not carry.
        """
        if self.cyclic:
            clip_times = clip_times % self.duration + (CYCLES // 2) * self.duration
        nearest = np.floor(clip_times * RATE + 0.5).astype(np.int64)
        return self.by_frame[np.clip(nearest, 0, len(self.by_frame) - 1)]


def mean_source_slips(
    sources: Sequence[SourceSlips], clip_times: Seconds, shares: Floats
) -> Floats:
    """Return the weighted mean inner slip of the source clips in the same phases [m].

    Args:
        sources: The clip of each action.
        clip_times: Where each action is in its clip [s], shape (frames, actions).
        shares: Share of each action in the legs, shape (frames, actions).

    Returns:
        The mean over the actions whose clip stands on the foot there, shape (frames, 2 feet);
        NaN where there is none.
    """
    total = np.zeros((len(clip_times), 2))
    weight = np.zeros((len(clip_times), 2))
    for action, source in enumerate(sources):
        slips = source.at(clip_times[:, action])
        share = np.where(np.isfinite(slips), shares[:, action, np.newaxis], 0.0)
        total += share * np.nan_to_num(slips)
        weight += share
    return np.where(weight > 0.0, total / np.where(weight > 0.0, weight, 1.0), np.nan)


def clip_trace(clip: Clip, anatomy: Anatomy, supports: SupportSequence, cycles: int = 1) -> Trace:
    """Return a clip in its own supports as a trace.

    Args:
        clip: The motion.
        anatomy: Which joints are its legs.
        supports: What it stands on.
        cycles: How often a cyclic clip is played, each time where it ended before.
    """
    rotations, positions = clip.world_poses()
    if cycles > 1:
        rotations, positions = _unrolled(rotations, positions, cycles)
    times = np.arange(len(positions)) / clip.fps
    return Trace(
        positions=positions,
        rotations=rotations,
        anatomy=with_soles(anatomy, rotations, positions),
        fps=clip.fps,
        supports=supports.supports_at(times),
    )


def _unrolled(
    rotations: Rotations, positions: Positions, cycles: int
) -> tuple[Rotations, Positions]:
    """Play a cycle several times: its last frame is the first one, one displacement further."""
    turn = multiply(rotations[-1, 0], conjugate(rotations[0, 0]))
    yaw = from_yaw(2.0 * np.arctan2(turn[2], turn[0]))
    level = np.array([1.0, 0.0, 1.0])
    all_rotations, all_positions = [rotations], [positions]
    for _ in range(cycles - 1):
        origin = all_positions[-1][0, 0] * level
        end = all_positions[-1][-1, 0] * level
        all_rotations.append(multiply(yaw, all_rotations[-1]))
        all_positions.append(rotate(yaw, all_positions[-1] - origin) + end)
    return (
        np.concatenate([all_rotations[0], *(part[1:] for part in all_rotations[1:])]),
        np.concatenate([all_positions[0], *(part[1:] for part in all_positions[1:])]),
    )
