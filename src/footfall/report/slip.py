"""How far a carrying foot moves over the surface: the primary measure of a finished motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Flags, Floats, Indices
from footfall.report.spans import Span, support_spans
from footfall.report.track import Track

__all__ = ["SpanMeasure", "measure_spans", "planted_distances", "step_lengths"]


@dataclass(frozen=True, eq=False)
class SpanMeasure:
    """What one foot did during one support span (measures, section 1)."""

    span: Span
    """Which foot, when, and what the blend did meanwhile."""

    slip: float
    """Way of the carrying point over the surface, edges included [m]: see `step_lengths`."""

    inner_slip: float | None
    """The same without 67 ms at each end [m]; None where no two frames are left."""

    drift: float
    """Greatest distance of the carrying point from where it was planted [m], edges included:
    see `planted_distances`."""

    inner_drift: float | None
    """The same without 67 ms at each end [m]; a point that was in contact before is planted
    where the inner part begins. None where no frame is left."""

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


def step_lengths(places: Floats, clearances: Floats, contacts: Flags) -> Floats:
    """Return how far the carrying point of one foot moves from each frame to the next [m].

    The least horizontal displacement among the points in contact in both frames: a foot rolls
    from heel to toe, and the point that carries it must not move. If no point is in contact the
    lowest one counts: a floating foot must not score zero (measures, section 1).

    Args:
        places: Foot points on their surface, x and z [m], shape (frames, points, 2).
        clearances: Their heights over their resting levels [m], shape (frames, points).
        contacts: Whether they are in contact, shape (frames, points).

    Returns:
        Displacements, shape (frames - 1,).
    """
    steps = np.linalg.norm(np.diff(places, axis=0), axis=-1)
    return _least_of_contacts(steps, contacts[1:] & contacts[:-1], clearances[1:] + clearances[:-1])


def planted_distances(places: Floats, clearances: Floats, contacts: Flags) -> Floats:
    """Return how far the carrying point of one foot is from where it was planted [m].

    A point is planted in the first frame, and again whenever it comes into contact; which points
    count is decided as in `step_lengths`.

    Args:
        places: Foot points on their surface, x and z [m], shape (frames, points, 2).
        clearances: Their heights over their resting levels [m], shape (frames, points).
        contacts: Whether they are in contact, shape (frames, points).

    Returns:
        Distances, shape (frames,).
    """
    landed = np.zeros_like(contacts)
    landed[1:] = contacts[1:] & ~contacts[:-1]
    frames = np.arange(len(places))[:, np.newaxis]
    planted: Indices = np.maximum.accumulate(np.where(landed, frames, 0), axis=0)
    distances = np.linalg.norm(places - places[planted, np.arange(places.shape[1])], axis=-1)
    return _least_of_contacts(distances, contacts, clearances)


def _least_of_contacts(values: Floats, contacts: Flags, clearances: Floats) -> Floats:
    lowest = clearances.argmin(axis=1)[:, np.newaxis]
    of_lowest = np.take_along_axis(values, lowest, axis=1)[:, 0]
    least = np.where(contacts, values, np.inf).min(axis=1)
    return np.where(contacts.any(axis=1), least, of_lowest)


def _measure(track: Track, span: Span, sources: Floats | None) -> SpanMeasure:
    first, last = span.inner
    source = None if sources is None else _mean_of_known(sources[first : max(first, last)])
    return SpanMeasure(
        span=span,
        slip=_total(_steps(track, span.foot, span.start, span.stop)),
        inner_slip=_total(_steps(track, span.foot, first, last)) if last - first > 1 else None,
        drift=_greatest(track, span.foot, span.start, span.stop),
        inner_drift=_greatest(track, span.foot, first, last) if last > first else None,
        clearances=track.clearances[span.start : span.stop, span.foot].min(axis=1),
        source_slip=source,
    )


def _steps(track: Track, foot: int, start: int, stop: int) -> Floats:
    part = slice(start, stop), foot
    return step_lengths(track.places[part], track.clearances[part], track.contacts[part])


def _greatest(track: Track, foot: int, start: int, stop: int) -> float:
    part = slice(start, stop), foot
    distances = planted_distances(track.places[part], track.clearances[part], track.contacts[part])
    return float(distances.max())


def _total(steps: Floats) -> float:
    return float(steps.sum())


def _mean_of_known(values: Floats) -> float:
    known = values[np.isfinite(values)]
    return float(known.mean()) if known.size else 0.0
