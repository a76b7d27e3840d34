"""When one foot is in contact: from heights and speeds of its points to stretches of time."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.detection.intervals import Interval, runs, united
from footfall.detection.tracks import LOW_PASS_DEVIATION, FootTracks

__all__ = ["foot_contacts"]

_NEARLY = (1.4, 1.6)
"""Nearly low and nearly slow: multiples of the height and the speed limit."""

_SEEMS_EARLY, _SEEMS_LATE = 0.008, 0.003
"""A low-passed track comes to rest before the foot does, and stays after it [s]."""

_ABOVE = (0.01, 0.022)
"""Height over where it then rests from which a point has yet to land, and surely so [m]: soles
are soft, and a heel joint is no corner."""

_LANDING = 2.4
"""What a point still takes to come down gently, as a multiple of height over speed: 2 where it
slows evenly, 3 where it eases out as the cube of the time left."""

_FALLING = (0.3, 0.5)
"""Share of the vertical in a point's speed from which it counts as falling, and fully so."""

_LONGEST_LANDING = 0.15
"""[s]"""

_DRAGGED = (0.2, 5.0, 0.1, 0.05)
"""A foot steps without being lifted: faster than this [m/s], and than this multiple of its usual
speed in the contact, for so long [s], and so far [m]."""


def foot_contacts(
    heights: Floats, velocities: Positions, limits: tuple[Floats, Floats], tracks: FootTracks
) -> list[Interval]:
    """Return when any point of one foot is in contact, in order.

    Args:
        heights: Of its points over their ground [m], shape (samples, points).
        velocities: Of its points [m/s], shape (samples, points, 3).
        limits: Height [m] and speed [m/s] below which they are low and slow, shape (points,).
        tracks: Whose tracks; of a cyclic clip the contacts that begin in [0, duration).
    """
    samples, rate = len(heights), tracks.rate
    turns = 3 if tracks.cyclic else 1
    heights = np.tile(heights, (turns, 1))
    velocities = np.tile(velocities, (turns, 1, 1))
    found: list[Interval] = []
    for point in range(heights.shape[1]):
        reach = (float(limits[0][point]), float(limits[1][point]))
        found += _point_contacts(heights[:, point], velocities[:, point], reach, rate)
    speeds = np.linalg.norm(velocities, axis=-1).min(axis=1)
    contacts = [part for whole in united(found) for part in _undragged(whole, speeds, rate)]
    if not tracks.cyclic:
        return [_within(contact, tracks.duration) for contact in contacts]
    if any(contact.duration >= 2.0 * tracks.duration for contact in contacts):
        return [Interval(0.0, tracks.duration)]
    middle = [contact.later(-samples / rate) for contact in contacts]
    return [contact for contact in middle if 0.0 <= contact.start < tracks.duration]


def _within(contact: Interval, duration: float) -> Interval:
    """Return the contact cut off at the ends of the clip."""
    starts, ends = contact.start <= 0.0, contact.end >= duration
    return Interval(
        0.0 if starts else contact.start,
        duration if ends else contact.end,
        1.0 if starts else contact.start_confidence,
        1.0 if ends else contact.end_confidence,
    )


def _point_contacts(
    height: Floats, velocity: Positions, limits: tuple[float, float], rate: float
) -> list[Interval]:
    """Return when one point is in contact.

    A contact needs samples that are low and slow; those that are nearly so bridge them. It
    begins once the point is low and nearly slow, and ends once it is no longer slow: a foot
    stops abruptly, and departs gradually.
    """
    speed = np.linalg.norm(velocity, axis=-1)
    low, slow = height / limits[0], speed / limits[1]
    caught = (low < 1.0) & (slow < 1.0)
    kept = (low < _NEARLY[0]) & (slow < _NEARLY[1])
    arrived = (low < 1.0) & kept
    staying = (slow < 1.0) & kept
    found: list[Interval] = []
    for first, end in runs(kept):
        if not caught[first:end].any():
            continue
        start = first + int(arrived[first:end].argmax())
        stop = end - int(staying[first:end][::-1].argmax())
        resting = np.flatnonzero(slow[start:stop] < 0.5)
        settled, leaving = (resting[0], resting[-1] + 1) if resting.size else (0, stop - start)
        # A track that begins in contact has no landing, and one that ends in it no departure.
        begin, leave = 0.0, len(speed) / rate
        if start > 0:
            landing = _landing(height[start:stop], velocity[start], rate)
            begin = (start - 0.5) / rate + _SEEMS_EARLY + landing
        if stop < len(speed):
            leave = (stop - 0.5) / rate - _SEEMS_LATE
        if leave > begin:
            sharpness = (_sharpness(settled / rate), _sharpness((stop - start - leaving) / rate))
            found.append(Interval(begin, leave, *sharpness))
    return found


def _sharpness(seconds: float) -> float:
    """Return the confidence in a boundary that the speed takes so long to cross."""
    return math.exp(-seconds / 0.1)


def _landing(height: Floats, velocity: Positions, rate: float) -> float:
    """Return how long a point that is low still takes to come down [s].

    Zero for a heel that strikes: it is as low as it gets, and only stops going forward.

    Args:
        height: From when it is low on [m], shape (samples,).
        velocity: At the first of these samples [m/s], shape (3,).
        rate: Samples per second.
    """
    fall, speed = abs(float(velocity[1])), float(np.linalg.norm(velocity))
    if speed == 0.0:
        return 0.0
    rest = float(np.median(height[: max(round(0.25 * rate), 1)]))
    # The low-pass lifts a sharp corner by 0.4 deviations times the speed before it, which is
    # twice the speed at it.
    lifted = 0.8 * LOW_PASS_DEVIATION * fall
    above = float(height[0]) - rest - lifted
    falling = _ramp(fall / speed, _FALLING) * _ramp(above, _ABOVE)
    return min(falling * _LANDING * max(above, 0.0) / speed, _LONGEST_LANDING)


def _ramp(value: float, bounds: tuple[float, float]) -> float:
    return min(max((value - bounds[0]) / (bounds[1] - bounds[0]), 0.0), 1.0)


def _undragged(contact: Interval, speeds: Floats, rate: float) -> list[Interval]:
    """Return the parts of a contact between the steps in which the foot is hardly lifted.

    Args:
        contact: Of one foot.
        speeds: Of its slower point [m/s], shape (samples,).
        rate: Samples per second.
    """
    slowest, multiple, shortest, least_way = _DRAGGED
    first = max(math.ceil(contact.start * rate), 0)
    end = int(min(contact.end * rate, len(speeds)))
    part = speeds[first:end]
    if end - first < 4.0 * shortest * rate:
        return [contact]
    fast = part > max(slowest, multiple * float(np.median(part)))
    steps = [
        (a, b)
        for a, b in runs(fast)
        if b - a >= shortest * rate
        and part[a:b].sum() / rate >= least_way
        and min(a, end - first - b) >= shortest * rate
    ]
    cuts = [((first + a) / rate, (first + b) / rate) for a, b in steps]
    bounds = [contact.start, *(time for cut in cuts for time in cut), contact.end]
    sure = [contact.start_confidence, *([0.5] * (2 * len(cuts))), contact.end_confidence]
    edges = list(zip(bounds, sure, strict=True))
    return [
        Interval(one[0], other[0], one[1], other[1])
        for index, (one, other) in enumerate(pairwise(edges))
        if index % 2 == 0
    ]
