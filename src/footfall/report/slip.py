"""How far a carrying foot moves over the surface: the primary measure of a finished motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Flags, Floats, Indices
from footfall.report.spans import Span, support_spans
from footfall.report.track import Track

__all__ = ["SpanMeasure", "carried_steps", "measure_spans"]


@dataclass(frozen=True, eq=False)
class SpanMeasure:
    """What one foot did during one support span (measures, section 1)."""

    span: Span
    """Which foot, when, and what the blend did meanwhile."""

    slip: float
    """Way of the carrying point over the surface, edges included [m]: see `carried_steps`."""

    inner_slip: float | None
    """The same without 67 ms at each end [m]; None where no two frames are left."""

    drift: float
    """Greatest distance of the carrying point from where it was planted [m], edges included:
    see `carried_steps`."""

    inner_drift: float | None
    """The same without 67 ms at each end [m], from where the foot is when the inner part begins.
    None where no two frames are left."""

    clearances: Floats
    """Height of the lowest foot point over its resting level [m], shape (frames of the span,):
    below zero it penetrates, above it floats."""

    source_slip: float | None = None
    """Weighted mean inner slip of the source clips in the same phases [m]; None if unknown."""

    @property
    def excess(self) -> float | None:
        """Inner slip minus that of the source clips [m]; None where either is unknown."""
        if self.inner_slip is None or self.source_slip is None:
            return None
        return self.inner_slip - self.source_slip


def measure_spans(track: Track, source_slips: Floats | None = None) -> tuple[SpanMeasure, ...]:
    """Measure every support span of a motion.

    Args:
        track: The motion at 60 Hz.
        source_slips: The source clips' inner slip per span [m] in each frame and for each foot,
            shape (60 Hz frames, 2), NaN where no source carries there; None if unknown.

    Returns:
        One measure a span, in the order of `support_spans`.
    """
    return tuple(
        _measure(track, span, None if source_slips is None else source_slips[:, span.foot])
        for span in support_spans(track)
    )


def carried_steps(places: Floats, clearances: Floats, contacts: Flags) -> Floats:
    """Return how the carrying point of one foot moves from each frame to the next [m].

    The carrying point is the one that moves least among those in contact in both frames: a foot
    rolls from heel to toe, and the point that carries it must not move. If no point is in
    contact it is the lowest one: a floating foot must not score zero (measures, section 1).

    The slip of a span is the sum of the lengths of these steps. Its drift is the greatest length
    of the sum of the steps so far: the distance from where the carrying point was planted, taken
    over where one point hands over to the next. (Distances of each point from where it came into
    contact would count some millimeters for a perfect roll, since a point counts as in contact
    up to 4 cm before it rests.)

    Args:
        places: Foot points on their surface, x and z [m], shape (frames, points, 2).
        clearances: Their heights over their resting levels [m], shape (frames, points).
        contacts: Whether they are in contact, shape (frames, points).

    Returns:
        Displacements, x and z, shape (frames - 1, 2).
    """
    steps = np.diff(places, axis=0)
    touching = contacts[1:] & contacts[:-1]
    lengths: Floats = np.where(touching, np.linalg.norm(steps, axis=-1), np.inf)
    lowest: Indices = (clearances[1:] + clearances[:-1]).argmin(axis=1)
    least: Indices = lengths.argmin(axis=1)
    carrying = np.where(touching.any(axis=1), least, lowest)
    return np.take_along_axis(steps, carrying[:, np.newaxis, np.newaxis], axis=1)[:, 0]


def _measure(track: Track, span: Span, sources: Floats | None) -> SpanMeasure:
    first, last = span.inner
    source = None if sources is None else _mean_of_known(sources[first : max(first, last)])
    slip, drift = _ways(track, span.foot, span.start, span.stop)
    inner_slip, inner_drift = _ways(track, span.foot, first, last)
    judged = last - first > 1
    return SpanMeasure(
        span=span,
        slip=slip,
        inner_slip=inner_slip if judged else None,
        drift=drift,
        inner_drift=inner_drift if judged else None,
        clearances=track.clearances[span.start : span.stop, span.foot].min(axis=1),
        source_slip=source,
    )


def _ways(track: Track, foot: int, start: int, stop: int) -> tuple[float, float]:
    """Return slip and drift [m] from frame `start` to the one before `stop`."""
    if stop - start < 2:
        return 0.0, 0.0
    part = slice(start, stop), foot
    steps = carried_steps(track.places[part], track.clearances[part], track.contacts[part])
    lengths = np.linalg.norm(steps, axis=1)
    distances = np.linalg.norm(steps.cumsum(axis=0), axis=1)
    return float(lengths.sum()), float(distances.max())


def _mean_of_known(values: Floats) -> float:
    known = values[np.isfinite(values)]
    return float(known.mean()) if known.size else 0.0
