"""How far each planted foot has to be moved so that the point that carries it stays in place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.detection.filters import gaussian
from footfall.detection.tracks import PlanarStep
from footfall.support import SupportSequence

__all__ = ["FootSpan", "foot_spans", "pinned_offsets", "resting_levels"]

_EDGE = 0.06
"""How long a foot still comes at the start of a span, and already goes at its end [s]."""

_SHARP = 0.004
"""Difference of height from which the lower of two points is the one that carries [m]."""

_SLOWER = 0.02
"""Difference of speed that counts as much [m/s]: a turning foot turns about the slower point."""

_SPEED_SPREAD = 0.06
"""Deviation of the filter over those speeds [s]."""

_HANDOVER = 0.008
"""Deviation of the filter that smooths the change from one carrying point to the other [s]."""

_UNEVEN = 0.015
"""Most of what a carrying point's height varies by within a span that is taken out [m]."""


@dataclass(frozen=True, slots=True)
class FootSpan:
    """A stretch of time for which one foot carries."""

    start: float
    """[s]; on a cycle it may lie before zero."""

    end: float
    """[s]; on a cycle it may lie beyond the duration."""


def foot_spans(supports: SupportSequence, foot: int) -> tuple[FootSpan, ...]:
    """Return when the left (0) or right (1) foot carries, in order, on a cycle each span once."""
    bounds = supports.boundaries
    carries = [p.support.right if foot else p.support.left for p in supports.phases]
    if all(carries):
        return (FootSpan(bounds[0], bounds[-1]),)
    # A cycle is read from a phase on in which the foot is up: no span is cut in two.
    first = carries.index(False) if supports.cyclic else 0
    spans: list[FootSpan] = []
    open_span = False
    for place in range(first, first + len(carries)):
        turn, index = divmod(place, len(carries))
        start, end = (bounds[i] + turn * supports.duration for i in (index, index + 1))
        if carries[index]:
            spans.append(FootSpan(spans.pop().start if open_span else start, end))
        open_span = carries[index]
    return tuple(spans)


def resting_levels(points: Positions, spans: Sequence[FootSpan], fps: float) -> Floats:
    """Return the heights at which heel and toe of one foot rest [m], shape (points,).

    The median of a point's height while its foot carries, the point is near its lowest places,
    and the edges of the span are away; its 5th percentile where that never is.
    """
    times = np.arange(len(points)) / fps
    heights = points[..., 1]
    levels = np.percentile(heights, 5.0, axis=0)
    inner = np.zeros(len(points), dtype=np.bool_)
    for span in spans:
        for shift in (0.0, (len(points) - 1) / fps):
            inner |= (times + shift > span.start + _EDGE) & (times + shift < span.end - _EDGE)
    for point in range(2):
        resting = inner & (heights[:, point] < levels[point] + 0.03)
        if resting.any():
            levels[point] = np.median(heights[resting, point])
    return levels


def pinned_offsets(
    points: Positions, spans: Sequence[FootSpan], fps: float, step: PlanarStep, *, cyclic: bool
) -> Positions:
    """Return how far one foot is moved in each frame [m], shape (frames, 3).

    In a span it is moved against every movement of the point that carries it (heel or toe,
    whichever is lower over the level at which it rests), beginning and ending gently; as far to
    one side of where it was as to the other, and to the height at which it rests. From span to
    span the offset goes over smoothly, so that the swing takes up the rest.

    Args:
        points: Heel and toe relative to their surface [m], shape (frames, points, 3).
        spans: When the foot carries, in order.
        fps: Frames per second.
        step: What one cycle adds.
        cyclic: Whether the last frame is the first one, one cycle on.
    """
    frames = len(points)
    if not spans:
        return np.zeros((frames, 3))
    levels = resting_levels(points, spans, fps)
    period = frames - 1
    duration = period / fps
    if not cyclic:
        spans = [_open_ended(span, duration) for span in spans]
        return _spread(*_fitted(points, levels, spans, fps, 0.0), spans, fps, 0.0)
    if spans[0].end - spans[0].start >= duration - 1e-9:
        return _closed(points, levels, fps)
    # One cycle before, so that the first span is whole, and two after, for the last one.
    laid_out = np.concatenate([*(step.apply(points[:-1], k) for k in (-1, 0, 1, 2))])
    repeated = [
        FootSpan(span.start + k * duration, span.end + k * duration)
        for k in (-1, 0, 1)
        for span in spans
    ]
    fitted = _fitted(laid_out, levels, repeated, fps, -duration)
    return _spread(*fitted, repeated, fps, -duration)[period : 2 * period + 1]


def _open_ended(span: FootSpan, duration: float) -> FootSpan:
    """Return a span without edges where the clip itself begins or ends: there nothing comes."""
    return FootSpan(
        span.start - _EDGE if span.start <= 1e-6 else span.start,
        span.end + _EDGE if span.end >= duration - 1e-6 else span.end,
    )


def _carrying_moves(points: Positions, levels: Floats, fps: float) -> tuple[Floats, Floats]:
    """Return how the carrying point moves on the ground, and how high it is over its level.

    Returns:
        Displacements x and z from each frame to the next [m], shape (frames - 1, 2), and heights
        [m], shape (frames,).
    """
    heights = points[..., 1] - levels
    steps = np.diff(points[..., [0, 2]], axis=0)
    speeds = gaussian(np.linalg.norm(steps, axis=-1) * fps, _SPEED_SPREAD * fps)
    speeds = 0.5 * (np.concatenate([speeds[:1], speeds]) + np.concatenate([speeds, speeds[-1:]]))
    lead = (heights[:, 0] - heights[:, 1]) / _SHARP + (speeds[:, 0] - speeds[:, 1]) / _SLOWER
    toe = gaussian(_decided(lead), _HANDOVER * fps)
    share = 0.5 * (toe[1:] + toe[:-1])[:, np.newaxis]
    moves = (1.0 - share) * steps[:, 0] + share * steps[:, 1]
    return moves, (1.0 - toe) * heights[:, 0] + toe * heights[:, 1]


def _decided(lead: Floats) -> Floats:
    """Return 1 where the second of two points leads and 0 where the first does.

    What is undecided stays as it was: a foot that turns must not turn about its middle, where
    both points move.
    """
    clear = np.abs(lead) > 1.0
    if not clear.any():
        return np.where(lead > 0.0, 1.0, 0.0)
    latest = np.maximum.accumulate(np.where(clear, np.arange(len(lead)), int(clear.argmax())))
    return np.where(lead[latest] > 0.0, 1.0, 0.0)


def _fitted(
    points: Positions, levels: Floats, spans: Sequence[FootSpan], fps: float, origin: float
) -> tuple[Positions, list[slice]]:
    """Return the offsets within the spans [m], shape (frames, 3), and the frames of each span."""
    moves, heights = _carrying_moves(points, levels, fps)
    offsets = np.zeros((len(points), 3))
    parts: list[slice] = []
    for span in spans:
        first = max(int(np.ceil((span.start - origin) * fps - 1e-9)), 0)
        end = min(int(np.floor((span.end - origin) * fps + 1e-9)) + 1, len(points))
        part = slice(first, max(end, first))
        parts.append(part)
        if end <= first:
            continue
        times = np.arange(first, end) / fps + origin
        held = _held(0.5 * (times[1:] + times[:-1]), span)
        way = np.zeros((end - first, 2))
        way[1:] = -np.cumsum(moves[first : end - 1] * held[:, np.newaxis], axis=0)
        offsets[part, 0], offsets[part, 2] = (way - way.mean(axis=0)).T
        height = heights[part]
        inner = _held(times, span) > 0.5
        middle = float(np.median(height[inner])) if inner.any() else float(height.min())
        uneven = gaussian(_UNEVEN * np.tanh((height - middle) / _UNEVEN), 0.03 * fps)
        offsets[part, 1] = -middle - uneven * _held(times, span)
    return offsets, parts


def _held(times: Floats, span: FootSpan) -> Floats:
    """Return how firmly a foot is held, 0 at both ends of its span and 1 in between."""
    edge = min(_EDGE, 0.35 * (span.end - span.start))
    return _eased(np.clip(np.minimum(times - span.start, span.end - times) / edge, 0.0, 1.0))


def _eased(shares: Floats) -> Floats:
    """Return the minimum-jerk way from 0 to 1."""
    return shares**3 * (10.0 + shares * (6.0 * shares - 15.0))


def _spread(
    offsets: Positions, parts: list[slice], spans: Sequence[FootSpan], fps: float, origin: float
) -> Positions:
    """Return the offsets with the swings filled in: from the end of a span to the next start."""
    filled = offsets.copy()
    known = [(p, s) for p, s in zip(parts, spans, strict=True) if p.stop > p.start]
    if not known:
        return np.zeros_like(offsets)
    filled[: known[0][0].start] = offsets[known[0][0].start]
    filled[known[-1][0].stop :] = offsets[known[-1][0].stop - 1]
    for (part, span), (later_part, later) in pairwise(known):
        times: Floats = np.arange(part.stop, later_part.start, dtype=np.float64) / fps + origin
        share = _eased((times - span.end) / max(later.start - span.end, 1e-9))[:, np.newaxis]
        gone, come = offsets[part.stop - 1], offsets[later_part.start]
        filled[part.stop : later_part.start] = (1.0 - share) * gone + share * come
    return filled


def _closed(points: Positions, levels: Floats, fps: float) -> Positions:
    """Return the offsets of a foot that stands for a whole cycle, ending as they begin."""
    moves, heights = _carrying_moves(points, levels, fps)
    way = np.zeros((len(points), 2))
    way[1:] = -np.cumsum(moves, axis=0)
    way -= np.linspace(0.0, 1.0, len(points))[:, np.newaxis] * way[-1]
    way -= way[:-1].mean(axis=0)
    return np.stack([way[:, 0], -heights, way[:, 1]], -1)
