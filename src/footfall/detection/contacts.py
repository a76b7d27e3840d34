"""When each foot is on the ground: low, and slow (section 4.2, figure 5)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Flags, Floats
from footfall.detection.intervals import Interval, covers, held_runs, without_short_ones
from footfall.detection.tracks import FootTracks, foot_tracks
from footfall.errors import ArgumentError
from footfall.motion import Clip
from footfall.skeleton import Anatomy, find_anatomy

__all__ = ["MINIMUM_DURATION", "Contacts", "detect_contacts", "track_contacts"]

MINIMUM_DURATION = 0.06
"""Contacts and gaps shorter than this are flicker [s]."""

_LOW = 0.05
"""A foot point is low below this share of the leg length."""

_SLOW = 0.25
"""A foot point is slow below this share of its own 75th percentile speed ..."""

_SLOW_RANGE = (0.35, 2.5)
"""... but not below the first of these [m/s], and not above the second."""

_RELEASE = (1.4, 1.6)
"""A point in contact stays so up to these multiples of its height and speed limit."""

_GROUND_WINDOW = 1.2
"""Over which the ground is the lowest place of a point where the floor tilts or drifts [s]."""


@dataclass(frozen=True, eq=False)
class Contacts:
    """When the feet of a clip are on the ground, and from what that was concluded."""

    intervals: tuple[tuple[Interval, ...], tuple[Interval, ...]]
    """Contacts of the left and of the right foot, in order."""

    flags: Flags
    """Whether each foot is in contact, shape (frames, feet)."""

    heights: Floats
    """Of the lowest point of each foot over its ground [m], shape (frames, feet)."""

    speeds: Floats
    """Of that point [m/s], shape (frames, feet)."""

    ground: Floats
    """Height at which each foot point rests [m], shape (frames, feet, points)."""

    height_limits: Floats
    """Height over its ground below which a point is low [m], shape (feet, points)."""

    speed_limits: Floats
    """Speed below which a point is slow [m/s], shape (feet, points)."""

    belt_velocity: tuple[float, float]
    """How fast the surface runs (x, z) [m/s], where the clip was captured in place."""

    duration: float
    """Of the clip [s]."""

    cyclic: bool
    """Whether the clip is."""


def detect_contacts(
    clip: Clip,
    anatomy: Anatomy | None = None,
    *,
    height: float | None = None,
    speed: float | None = None,
    min_duration: float = MINIMUM_DURATION,
) -> Contacts:
    """Find when each foot of a clip is on the ground.

    Args:
        clip: The motion.
        anatomy: Its skeleton's; found where not given.
        height: The paper's maximum height of the lowest extremity of the foot [m], > 0;
            a share of the leg length where not given.
        speed: The paper's maximum speed below that height [m/s], > 0; adapted to each foot
            point where not given.
        min_duration: Contacts and gaps shorter than this are ignored [s], >= 0.

    Returns:
        The contacts.

    Raises:
        ArgumentError: If a limit is out of its range.
    """
    for label, value in (("height", height), ("speed", speed)):
        if value is not None and not 0.0 < value < np.inf:
            raise ArgumentError(f"{label} is {value}; a limit must be finite and > 0")
    if not 0.0 <= min_duration < np.inf:
        raise ArgumentError(f"min_duration is {min_duration} s; it must be finite and >= 0")
    anatomy = find_anatomy(clip.skeleton) if anatomy is None else anatomy
    tracks = foot_tracks(clip, anatomy)
    return track_contacts(
        tracks,
        np.arange(clip.frames) / clip.fps,
        height=height,
        speed=speed,
        min_duration=min_duration,
    )


def track_contacts(
    tracks: FootTracks,
    frame_times: Floats,
    *,
    height: float | None = None,
    speed: float | None = None,
    min_duration: float = MINIMUM_DURATION,
) -> Contacts:
    """Find when each foot of some tracks is on the ground; arguments as in `detect_contacts`."""
    ground = _ground(tracks)
    heights = tracks.positions[..., 1] - ground
    speeds = np.linalg.norm(tracks.velocities, axis=-1)
    height_limits = np.full((2, 2), _LOW * tracks.leg_length if height is None else height)
    speed_limits = _speed_limits(speeds) if speed is None else np.full((2, 2), speed)
    excess = np.maximum(heights / height_limits, speeds / speed_limits)
    release = np.maximum(
        heights / (height_limits * (_RELEASE[0] if height is None else 1.0)),
        speeds / (speed_limits * (_RELEASE[1] if speed is None else 1.0)),
    )
    intervals = [
        without_short_ones(
            _foot_intervals(excess[:, foot], release[:, foot], tracks),
            min_duration,
            tracks.duration,
            cyclic=tracks.cyclic,
        )
        for foot in range(2)
    ]
    rows = np.rint(frame_times * tracks.rate).astype(np.int64) % len(heights)
    lowest = heights[rows].argmin(axis=-1)[..., np.newaxis]
    return Contacts(
        intervals=(intervals[0], intervals[1]),
        flags=np.stack(
            [covers(i, frame_times, tracks.duration, cyclic=tracks.cyclic) for i in intervals],
            axis=-1,
        ),
        heights=np.take_along_axis(heights[rows], lowest, axis=-1)[..., 0],
        speeds=np.take_along_axis(speeds[rows], lowest, axis=-1)[..., 0],
        ground=ground[rows],
        height_limits=height_limits,
        speed_limits=speed_limits,
        belt_velocity=tracks.belt_velocity,
        duration=tracks.duration,
        cyclic=tracks.cyclic,
    )


def _speed_limits(speeds: Floats) -> Floats:
    return np.clip(_SLOW * np.percentile(speeds, 75.0, axis=0), *_SLOW_RANGE)


def _ground(tracks: FootTracks) -> Floats:
    """Return the height at which each point rests, shape (samples, feet, points)."""
    heights = tracks.positions[..., 1]
    level = np.percentile(heights, 5.0, axis=0)
    # A foot that is never down has the other one's floor.
    level = np.minimum(level, level.min(axis=0) + _LOW * tracks.leg_length)
    return np.broadcast_to(level, heights.shape)


def _foot_intervals(excess: Floats, release: Floats, tracks: FootTracks) -> list[Interval]:
    """Return when any point of one foot is in contact.

    Args:
        excess: By how much each point misses contact, shape (samples, points); < 1 in contact.
        release: The same for a point that is in contact.
        tracks: Whose tracks.
    """
    samples = len(excess)
    turns = 3 if tracks.cyclic else 1
    held = np.zeros(turns * samples, dtype=np.bool_)
    for point in range(2):
        caught, kept = (np.tile(s[:, point], turns) < 1.0 for s in (excess, release))
        for first, end in held_runs(caught, caught | kept):
            held[first:end] = True
    runs = held_runs(held, held)
    period = samples if tracks.cyclic else 0
    if tracks.cyclic:
        if held.all():
            return [Interval(0.0, tracks.duration)]
        runs = [run for run in runs if samples <= run[0] < 2 * samples]
    return [
        Interval(
            max((first - period - 0.5) / tracks.rate, 0.0),
            (end - period - 0.5) / tracks.rate
            if tracks.cyclic
            else min((end - 0.5) / tracks.rate, tracks.duration),
        )
        for first, end in runs
    ]
