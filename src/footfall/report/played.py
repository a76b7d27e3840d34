"""The phases of an action as they were played, seen from where its clip was in each frame."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Indices, Seconds
from footfall.report.stretch import PlayedPhase
from footfall.support import SupportSequence

__all__ = ["played_phases"]


def played_phases(
    clip_times: Seconds, supports: SupportSequence, fps: float
) -> tuple[PlayedPhase, ...]:
    """Return the phases that one action played from their beginning to their end.

    Whatever kept it in step with others: what counts is how much of the clip went by meanwhile.
    Phases cut by a start, a stop or the end of the recording are left out, and so are those in
    which the clip stood still.

    Args:
        clip_times: Where its clip was [s], cycles counted on, NaN while it did not play, shape
            (frames,).
        supports: What it stands on.
        fps: Frames per second.
    """
    phases: list[PlayedPhase] = []
    played = np.concatenate([[False], np.isfinite(clip_times), [False]])
    edges = np.flatnonzero(np.diff(played.astype(np.int8))).reshape(-1, 2)
    for start, stop in edges.tolist():
        times = clip_times[start:stop]
        indices = _absolute_indices(times, supports)
        changes = np.flatnonzero(np.diff(indices)) + 1
        for first, after in zip(changes[:-1].tolist(), changes[1:].tolist(), strict=True):
            seconds = float(times[after] - times[first])
            if seconds > 0.0:
                support = supports.at(int(indices[first])).support
                phases.append(PlayedPhase((after - first) / fps, seconds, support))
    return tuple(phases)


def _absolute_indices(times: Seconds, supports: SupportSequence) -> Indices:
    """Return the phase of each clip time, those of a cycle counted on, shape (frames,)."""
    bounds: Floats = np.array(supports.boundaries)
    turns = np.zeros(len(times), dtype=np.int64)
    if supports.cyclic:
        turns = np.floor((times - bounds[0]) / supports.duration).astype(np.int64)
        times = times - turns * supports.duration
    within = np.searchsorted(bounds[1:], times, side="right")
    count = len(supports.phases)
    return turns * count + np.minimum(within, count - 1)
