"""What each planted foot did, ready to be drawn: its print, and the streak where it slid."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.report import SpanMeasure, Track, carried_steps, measure_spans

__all__ = ["Plant", "plants"]


@dataclass(frozen=True, eq=False)
class Plant:
    """A foot in one support span."""

    foot: int
    """0 for the left foot, 1 for the right."""

    start: int
    """First frame of the span's inner part, at 60 Hz."""

    stop: int
    """The frame after its last one."""

    slip: float
    """Inner slip of the span [m]; zero where it is too short to be judged."""

    print: Positions
    """Heel and toe where the foot was set down [m], shape (2, 3)."""

    streak: Positions
    """How far the foot had slid in each inner frame [m], shape (frames, 3); begins with zero."""

    @property
    def slid(self) -> Floats:
        """Length of the streak up to each inner frame [m], shape (frames,)."""
        steps = np.linalg.norm(np.diff(self.streak, axis=0), axis=-1)
        return np.concatenate([[0.0], np.cumsum(steps)])


def plants(track: Track) -> tuple[Plant, ...]:
    """Return every support span of a motion, in the order of time."""
    measures = sorted(measure_spans(track), key=lambda of: (of.span.start, of.span.foot))
    return tuple(_plant(track, of) for of in measures)


def _plant(track: Track, of: SpanMeasure) -> Plant:
    span = of.span
    first, last = span.inner if of.inner_slip is not None else (span.start, span.stop)
    part = slice(first, last), span.foot
    steps: Floats = np.zeros((0, 2))
    if last - first > 1:
        steps = carried_steps(track.places[part], track.clearances[part], track.contacts[part])
    slid = np.zeros((len(steps) + 1, 3))
    slid[1:, [0, 2]] = np.cumsum(steps, axis=0)
    flattest = int(track.clearances[part].max(axis=1).argmin())
    where = track.points[first + flattest, span.foot]
    return Plant(span.foot, first, last, of.inner_slip or 0.0, where - slid[flattest], slid)
