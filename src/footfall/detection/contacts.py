"""When each foot is on the ground: low, and slow (section 4.2, figure 5)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Flags, Floats
from footfall.detection.filters import moving_mean, moving_minimum
from footfall.detection.foot_contacts import foot_contacts
from footfall.detection.intervals import Interval, covers, without_short_ones
from footfall.detection.tracks import FootTracks, foot_tracks
from footfall.errors import ArgumentError
from footfall.motion import Clip
from footfall.skeleton import Anatomy, find_anatomy

__all__ = ["MINIMUM_DURATION", "Contacts", "detect_contacts", "track_contacts"]

MINIMUM_DURATION = 0.06
"""Contacts and gaps shorter than this are flicker [s]."""

_LOW = 0.05
"""A foot point is low below this share of the leg length."""

_LIFTED = 0.5
"""It is not low above this share of its own 90th percentile height ..."""

_LEAST_LOW = 0.012
"""... unless that is less than this [m]."""

_SLOW = 0.25
"""A foot point is slow below this share of its own 75th percentile speed ..."""

_SLOW_RANGE = (0.35, 2.5)
"""... but not below the first of these [m/s], and not above the second."""

_STRAY = 0.5
"""The ground is at most this share of the greatest height limit below its usual level."""

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
    height_limits = _height_limits(heights, tracks) if height is None else np.full((2, 2), height)
    speed_limits = _speed_limits(speeds) if speed is None else np.full((2, 2), speed)
    intervals: list[tuple[Interval, ...]] = []
    for foot in range(2):
        limits = height_limits[foot], speed_limits[foot]
        found = foot_contacts(heights[:, foot], tracks.velocities[:, foot], limits, tracks)
        intervals.append(
            without_short_ones(found, min_duration, tracks.duration, cyclic=tracks.cyclic)
        )
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


def _height_limits(heights: Floats, tracks: FootTracks) -> Floats:
    """Return the heights below which points are low [m]: less for feet that are hardly lifted."""
    lifted = _LIFTED * np.percentile(heights, 90.0, axis=0)
    return np.clip(lifted, _LEAST_LOW, _LOW * tracks.leg_length)


def _speed_limits(speeds: Floats) -> Floats:
    return np.clip(_SLOW * np.percentile(speeds, 75.0, axis=0), *_SLOW_RANGE)


def _ground(tracks: FootTracks) -> Floats:
    """Return the height at which each point rests, shape (samples, feet, points).

    Its lowest place within half a window, smoothed, so that floors may tilt or drift; but never
    far from the lowest places of the whole clip, nor far above the other foot's: a foot that is
    held up for long does not stand, and a stray frame does not move the floor.
    """
    heights = tracks.positions[..., 1]
    level = np.percentile(heights, 5.0, axis=0)
    low = _LOW * tracks.leg_length
    radius = min(round(0.5 * _GROUND_WINDOW * tracks.rate), len(heights) - 1)
    lowest = moving_minimum(heights, radius, cyclic=tracks.cyclic)
    smooth = moving_mean(lowest, radius // 2, cyclic=tracks.cyclic)
    return np.clip(smooth, level - _STRAY * low, np.minimum(level, level.min(axis=0)) + low)
