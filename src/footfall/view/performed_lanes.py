"""A performance as the timeline draws it."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from footfall.scenario.performance import Performance, support_text
from footfall.view.lanes import ActionLane, CueMark, LanePhase, Timeline

__all__ = ["performance_timeline"]


def performance_timeline(performance: Performance) -> Timeline:
    """Return the schedule of a performance, its actions in the order of the cue sheet.

    Actions that played without any part in the legs have no lane: they stand on nothing.
    """
    recording = performance.recording
    lanes = tuple(
        ActionLane(
            name,
            _phases(performance, index),
            np.clip(recording.shares[:, index], 0.0, 1.0),
            _marks(performance, name),
        )
        for index, name in enumerate(recording.actions)
        if recording.shares[:, index].any() or np.isnan(recording.clip_times[:, index]).all()
    )
    return Timeline(recording.fps, support_text(performance.supports), lanes)


def _phases(performance: Performance, action: int) -> tuple[LanePhase, ...]:
    """Return the phases that an action played: maximal runs of one index."""
    recording = performance.recording
    indices = recording.phases[:, action]
    same = (indices[1:] == indices[:-1]) | (np.isnan(indices[1:]) & np.isnan(indices[:-1]))
    bounds = [0, *(np.flatnonzero(~same) + 1).tolist(), len(indices)]
    found: list[LanePhase] = []
    for first, last in pairwise(bounds):
        if np.isnan(indices[first]):
            continue
        phase = performance.motions[action].supports.at(int(indices[first]))
        start, end = first / recording.fps, last / recording.fps
        found.append(LanePhase(phase.support.symbol, start, end, (end - start) / phase.duration))
    return tuple(found)


def _marks(performance: Performance, name: str) -> tuple[CueMark, ...]:
    starts = [
        CueMark("start", start.commanded, start.actual)
        for start in performance.starts
        if start.action == name
    ]
    stops = [
        CueMark("stop", cue.at, cue.at)
        for cue in performance.scenario.cues
        if cue.kind == "stop" and cue.action == name
    ]
    return (*starts, *stops)
