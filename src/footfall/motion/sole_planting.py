"""Keep the soles of a retargeted motion where they are planted: still, and on the ground.

Feet of another length turn about other points: a foot that pivots on its heel must pivot on its
own heel. So while a foot carries, its carrying point (heel or toe) is held, and the swing takes
up the rest. And a span begins before a foot rests and ends after it leaves: what is millimeters
of air under the foot that leads is more under a larger one, so that it is pressed flat there.
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from footfall.arrays import Flags, Floats, Positions
from footfall.geometry import conjugate, from_yaw, rotate

__all__ = ["FootPaths", "cyclic_offsets", "planted_offsets"]

EDGE = 0.06
"""How long a foot still comes at the start of a span, and already goes at its end [s]."""

SHARP = 0.004
"""Difference of height from which the lower of heel and toe is the one that carries [m]."""

SLOWER = 0.02
"""Difference of speed that counts as much [m/s]: a turning foot turns about the slower point."""

SPEED_SPREAD = 0.06
"""Deviation of the filter over those speeds [s]."""

HANDOVER = 0.008
"""Deviation of the filter that smooths the change from one carrying point to the other [s]."""

MOST_AIR = 0.006
"""Air under a carrying foot at most [m]."""

MOST_DEPTH = 0.002
"""How far it may be in the ground at most [m]."""

LIFT_TIME = 0.12
"""Time in which a foot that was pressed to the ground comes to where it would be, and before
which one that will be goes there [s]."""

BELT = 0.2
"""Speed of carrying feet above which they are on a belt, and go with it [m/s]."""


class FootPaths(NamedTuple):
    """Heel and toe of one foot during a motion, or during a few cycles of it."""

    leading: Positions
    """Of the leader, scaled [m], shape (frames, 2, 3)."""

    own: Positions
    """Of the body that follows [m], shape (frames, 2, 3)."""

    carries: Flags
    """Whether the foot carries, shape (frames,)."""


def cyclic_offsets(paths: FootPaths, fps: float, yaw: float, shift: Positions) -> Positions:
    """Return how far to move one foot of a cycle: as `planted_offsets`, ending as it begins.

    Args:
        paths: Of one cycle, its last frame being the first one of the next.
        fps: Frames per second.
        yaw: How far one cycle turns [rad], about the origin.
        shift: How far it then goes, level [m], shape (3,).
    """
    period = len(paths.carries) - 1
    turn = from_yaw(yaw)
    if paths.carries.all():
        offsets = planted_offsets(paths, fps)
        away = offsets[-1] - rotate(turn, offsets[0])
        return offsets - np.linspace(0.0, 1.0, period + 1)[:, np.newaxis] * away
    leading, own = (
        np.concatenate(
            [rotate(conjugate(turn), path - shift)[:-1], path[:-1], rotate(turn, path) + shift]
        )
        for path in (paths.leading, paths.own)
    )
    carries = np.concatenate([paths.carries[:-1], paths.carries[:-1], paths.carries])
    return planted_offsets(FootPaths(leading, own, carries), fps)[period : 2 * period + 1]


def planted_offsets(paths: FootPaths, fps: float) -> Positions:
    """Return how far to move one foot so that it stays where it is planted [m], (frames, 3)."""
    frames = len(paths.carries)
    offsets = np.zeros((frames, 3))
    spans = _runs(paths.carries)
    if not spans:
        return offsets
    heights = paths.leading[..., 1] - np.percentile(paths.leading[..., 1], 5.0, axis=0)
    share = _toe_share(paths.leading, heights, fps)
    moves = _moves(paths.leading, share)
    inner = paths.carries[1:] & paths.carries[:-1]
    belt = np.median(moves[inner], axis=0) if inner.any() else np.zeros(2)
    belt *= float(np.linalg.norm(belt)) * fps > BELT
    slides = _moves(paths.own, share)
    held = np.zeros(frames)
    for start, stop in spans:
        held[start:stop] = _held(start, stop, frames, fps)
    firm = np.minimum(held[1:], held[:-1])[:, np.newaxis]
    offsets[:, [0, 2]] = _level(moves + firm * (belt - moves) - slides, spans)
    own = paths.own[..., 1]
    air = (own - np.percentile(own, 5.0, axis=0)).min(axis=-1)
    offsets[:, 1] = _pressed(air, spans, fps)
    return offsets


def _runs(flags: Flags) -> list[tuple[int, int]]:
    """Return first frame, and the one after the last, of each maximal run of true flags."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]])))
    return [(int(start), int(stop)) for start, stop in edges.reshape(-1, 2)]


def _moves(points: Positions, share: Floats) -> Floats:
    """Return how the carrying point moves over the ground from frame to frame [m]."""
    steps = np.diff(points[..., [0, 2]], axis=0)
    toe = 0.5 * (share[1:] + share[:-1])[:, np.newaxis]
    return (1.0 - toe) * steps[:, 0] + toe * steps[:, 1]


def _toe_share(points: Positions, heights: Floats, fps: float) -> Floats:
    """Return where between heel (0) and toe (1) a foot carries, shape (frames,)."""
    if len(points) < 2:
        return np.zeros(len(points))
    steps = np.linalg.norm(np.diff(points[..., [0, 2]], axis=0), axis=-1) * fps
    speeds = _smoothed(steps, SPEED_SPREAD * fps)
    speeds = 0.5 * (np.concatenate([speeds[:1], speeds]) + np.concatenate([speeds, speeds[-1:]]))
    lead = (heights[:, 0] - heights[:, 1]) / SHARP + (speeds[:, 0] - speeds[:, 1]) / SLOWER
    clear = np.abs(lead) > 1.0
    first = int(clear.argmax())
    latest = np.maximum.accumulate(np.where(clear, np.arange(len(lead)), first))
    return _smoothed(np.where(lead[latest] > 0.0, 1.0, 0.0), HANDOVER * fps)


def _smoothed(values: Floats, deviation: float) -> Floats:
    """Return values through a Gaussian low-pass along the first axis, its ends going on."""
    radius = int(np.ceil(3.0 * deviation))
    if deviation < 0.05:
        return values
    weights = np.exp(-0.5 * (np.arange(-radius, radius + 1) / deviation) ** 2)
    padded = np.pad(values, [(radius, radius)] + [(0, 0)] * (values.ndim - 1), mode="edge")
    windows = np.lib.stride_tricks.sliding_window_view(padded, 2 * radius + 1, axis=0)
    return windows @ (weights / weights.sum())


def _held(start: int, stop: int, frames: int, fps: float) -> Floats:
    """Return how firmly a foot is held during a span: 0 at its ends, 1 in between.

    Where the motion itself begins or ends nothing comes or goes.
    """
    edge = min(EDGE * fps, 0.35 * (stop - start))
    places = np.arange(start, stop)
    before = places - start + (np.inf if start == 0 else 0.0)
    after = stop - 1 - places + (np.inf if stop == frames else 0.0)
    return _eased(np.clip(np.minimum(before, after) / max(edge, 1e-9), 0.0, 1.0))


def _eased(shares: Floats) -> Floats:
    """Return the minimum-jerk way from 0 to 1."""
    return shares**3 * (10.0 + shares * (6.0 * shares - 15.0))


def _level(steps: Floats, spans: list[tuple[int, int]]) -> Floats:
    """Return level offsets [m], shape (frames, 2): by these steps in spans, eased between."""
    offsets = np.zeros((len(steps) + 1, 2))
    for start, stop in spans:
        way = np.concatenate([np.zeros((1, 2)), np.cumsum(steps[start : stop - 1], axis=0)])
        offsets[start:stop] = way - way.mean(axis=0)
    offsets[: spans[0][0]] = offsets[spans[0][0]]
    offsets[spans[-1][1] :] = offsets[spans[-1][1] - 1]
    for (_, gone), (come, _) in pairwise(spans):
        share = _eased(np.arange(1, come - gone + 1) / (come - gone + 1))[:, np.newaxis]
        offsets[gone:come] = (1.0 - share) * offsets[gone - 1] + share * offsets[come]
    return offsets


def _pressed(air: Floats, spans: list[tuple[int, int]], fps: float) -> Floats:
    """Return how far to raise a foot [m], shape (frames,), given the air under it."""
    most = np.where(air > 0.0, MOST_AIR, MOST_DEPTH)
    pressed = most * np.tanh(air / most)
    rises = np.zeros(len(air))
    # A frame more at each end: between two frames the foot is down until the span ends.
    spans = _runs(_widened(spans, len(air)))
    for start, stop in spans:
        rises[start:stop] = (pressed - air)[start:stop]
    reach = LIFT_TIME * fps
    stops = [0, *(stop for _, stop in spans)]
    starts = [*(start for start, _ in spans), len(air)]
    for gone, come in zip(stops, starts, strict=True):
        places = np.arange(gone, come)
        if gone > 0:
            fading = 1.0 - _eased(np.clip((places - gone + 1) / reach, 0.0, 1.0))
            rises[gone:come] += rises[gone - 1] * fading
        if come < len(air):
            coming = 1.0 - _eased(np.clip((come - places) / reach, 0.0, 1.0))
            rises[gone:come] += rises[come] * coming
    return np.maximum(rises, pressed - air)


def _widened(spans: list[tuple[int, int]], frames: int) -> Flags:
    """Return the frames of spans and those next to them, shape (frames,)."""
    flags = np.zeros(frames, dtype=np.bool_)
    for start, stop in spans:
        flags[max(start - 1, 0) : stop + 1] = True
    return flags
