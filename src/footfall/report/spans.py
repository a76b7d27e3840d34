"""Support spans: the stretches of time in which the schedule says that a foot carries.

Most skate metrics guess the contacts again from the motion they judge, so that a foot that floats
or races escapes them. Here the commanded support is known, and a foot answers for all of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from footfall.arrays import Flags
from footfall.report.track import RATE, Track, carrying

__all__ = ["EDGE", "EDGE_FRAMES", "Group", "Span", "runs", "support_spans"]

EDGE = 0.067
"""What the inner measures leave out at each end of a span [s]: there a real foot already or
still moves at 0.5–1 m/s (measures, section 1)."""

EDGE_FRAMES = round(EDGE * RATE)
"""The same in frames at 60 Hz."""

WHOLE = 1.0 - 1e-6
"""An action with at least this share has all the weight."""


class Group(StrEnum):
    """What the blend did during a span; spans of different groups are never pooled silently."""

    ALONE = "alone"
    """One action had all the weight throughout."""

    TRANSITIONS = "transitions"
    """Weights moved during some of it."""

    MIXES = "mixes"
    """Several actions had lasting weights."""


@dataclass(frozen=True, slots=True)
class Span:
    """A maximal run of frames in which one foot is commanded to carry."""

    foot: int
    """0 for the left foot, 1 for the right."""

    start: int
    """First frame at 60 Hz."""

    stop: int
    """The frame after the last one."""

    group: Group
    """What the blend did meanwhile."""

    @property
    def inner(self) -> tuple[int, int]:
        """First frame, and the one after the last, without 67 ms at each end; may be empty."""
        return self.start + EDGE_FRAMES, self.stop - EDGE_FRAMES


def support_spans(track: Track) -> tuple[Span, ...]:
    """Return every support span of a motion, the left foot's first, each in order of time."""
    feet = carrying(track.supports)
    return tuple(
        Span(foot, start, stop, _group(track, start, stop))
        for foot in range(2)
        for start, stop in runs(feet[:, foot])
    )


def runs(flags: Flags) -> list[tuple[int, int]]:
    """Return first frame, and the one after the last, of each maximal run of true flags."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]])))
    return [(int(start), int(stop)) for start, stop in edges.reshape(-1, 2)]


def _group(track: Track, start: int, stop: int) -> Group:
    shares = track.shares[start:stop]
    if track.moving[start:stop].any():
        return Group.TRANSITIONS
    return Group.ALONE if shares.min(axis=0).max() >= WHOLE else Group.MIXES
