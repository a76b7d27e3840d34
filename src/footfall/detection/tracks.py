"""The tracks of the feet: where heel and toe go, at a rate at which boundaries can be found.

A track is resampled to about 120 Hz whatever the clip's rate, so that thresholds, filters and
sub-frame boundaries mean the same at 24 and at 120 frames per second.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Positions, Rotations
from footfall.motion import Clip, cycle_displacement, with_soles
from footfall.skeleton import Anatomy, leg_length

__all__ = [
    "LOW_PASS_DEVIATION",
    "FootTracks",
    "PlanarStep",
    "foot_tracks",
    "points_of_pose",
    "smooth_tracks",
]

_TRACK_RATE = 100.0
"""Tracks have the first multiple of the clip's rate that is not below this [Hz]."""

LOW_PASS_DEVIATION = math.sqrt(math.log(2.0)) / (2.0 * math.pi * 8.0)
"""Of the Gaussian that halves the power at 8 Hz [s]."""


@dataclass(frozen=True, slots=True)
class PlanarStep:
    """What one cycle adds: a turn about the vertical through the origin, then a translation."""

    yaw: float = 0.0
    """[rad]"""

    x: float = 0.0
    """[m]"""

    z: float = 0.0
    """[m]"""

    @classmethod
    def of(cls, clip: Clip) -> PlanarStep:
        """Return what one cycle of a cyclic clip adds."""
        shift, yaw = cycle_displacement(clip)
        return cls(yaw, float(shift[0]), float(shift[2]))

    def apply(self, positions: Positions, times: int = 1) -> Positions:
        """Return positions, shape (..., 3), moved `times` cycles on; back where negative."""
        moved = positions
        for _ in range(abs(times)):
            moved = self._once(moved) if times > 0 else self._once_back(moved)
        return moved

    def _once(self, positions: Positions) -> Positions:
        return _turned(positions, self.yaw) + np.array([self.x, 0.0, self.z])

    def _once_back(self, positions: Positions) -> Positions:
        return _turned(positions - np.array([self.x, 0.0, self.z]), -self.yaw)


def _turned(positions: Positions, yaw: float) -> Positions:
    if yaw == 0.0:
        return positions
    cosine, sine = math.cos(yaw), math.sin(yaw)
    turn = np.array([[cosine, 0.0, sine], [0.0, 1.0, 0.0], [-sine, 0.0, cosine]])
    return positions @ turn.T


@dataclass(frozen=True, eq=False)
class FootTracks:
    """Low-passed tracks of the foot points, and how fast they go."""

    positions: Positions
    """Where they are relative to the surface they tread on [m], shape (samples, feet, points,
    3): feet left and right, points heel and toe. Of a cyclic clip one whole cycle, the sample
    after the last one being the first one again, one cycle on."""

    velocities: Positions
    """Their velocities [m/s], the shape of `positions`."""

    rate: float
    """Samples per second."""

    duration: float
    """Of the clip [s]."""

    cyclic: bool
    """Whether the last sample is followed by the first."""

    leg_length: float
    """Thigh and shank, the mean of both legs [m]."""

    belt_velocity: tuple[float, float]
    """How fast the surface runs (x, z) [m/s]: a treadmill's; zero where the body itself goes."""


def points_of_pose(rotations: Rotations, positions: Positions, anatomy: Anatomy) -> Positions:
    """Return where heel and toe are, frame by frame.

    Args:
        rotations: All joints in the world, shape (frames, joints, 4).
        positions: All joints in the world [m], shape (frames, joints, 3).
        anatomy: The skeleton's.

    Returns:
        Positions [m], shape (frames, feet, points, 3).
    """
    points = np.empty((len(positions), 2, 2, 3))
    for foot, leg in enumerate(anatomy.legs):
        for index, point in enumerate((leg.heel, leg.toe)):
            offset = _rotated(rotations[:, point.joint], np.array(point.offset))
            points[:, foot, index] = positions[:, point.joint] + offset
    return points


def _rotated(rotations: Rotations, vector: Floats) -> Positions:
    axis = rotations[:, 1:]
    turn = 2.0 * np.cross(axis, vector)
    return vector + rotations[:, :1] * turn + np.cross(axis, turn)


def foot_tracks(clip: Clip, anatomy: Anatomy) -> FootTracks:
    """Return the tracks of a clip's feet, relative to the surface they tread on."""
    poses = clip.world_poses()
    points = points_of_pose(*poses, with_soles(anatomy, *poses))
    smooth, velocities, rate = smooth_tracks(points, clip)
    length = _leg_length(clip, anatomy)
    travel = (clip.pelvis_positions[-1] - clip.pelvis_positions[0]) / max(clip.duration, 1e-9)
    belt = _belt_velocity(smooth, velocities, math.hypot(travel[0], travel[2]), length)
    drift = np.array([belt[0], 0.0, belt[1]])
    times = np.arange(len(smooth)) / rate
    return FootTracks(
        positions=smooth - times[:, np.newaxis, np.newaxis, np.newaxis] * drift,
        velocities=velocities - drift,
        rate=rate,
        duration=clip.duration,
        cyclic=clip.cyclic,
        leg_length=length,
        belt_velocity=belt,
    )


def smooth_tracks(points: Positions, clip: Clip) -> tuple[Positions, Positions, float]:
    """Return the tracks of some points of a clip, low-passed at a higher rate.

    Args:
        points: Where they are in the world, frame by frame [m], shape (frames, ..., 3).
        clip: Whose points.

    Returns:
        Positions [m] and velocities [m/s], shape (samples, ..., 3), and the samples per second;
        of a cyclic clip one whole cycle, as in `FootTracks`.
    """
    step = PlanarStep.of(clip) if clip.cyclic else PlanarStep()
    dense, rate = _resampled(points, step, clip)
    smooth = _low_passed(dense, step, rate, cyclic=clip.cyclic)
    velocities = _velocities(smooth, step, rate, cyclic=clip.cyclic)
    if clip.cyclic:
        smooth, velocities = smooth[:-1], velocities[:-1]
    return smooth, velocities, rate


def _leg_length(clip: Clip, anatomy: Anatomy) -> float:
    return 0.5 * sum(leg_length(clip.skeleton, leg) for leg in anatomy.legs)


def _padded(points: Positions, step: PlanarStep, count: int, *, cyclic: bool) -> Positions:
    """Return the points with `count` more at both ends: the cycle's, or mirrored in the end."""
    count = min(count, len(points) - 1)
    before, after = points[-count - 1 : -1], points[1 : count + 1]
    if cyclic:
        return np.concatenate([step.apply(before, -1), points, step.apply(after)])
    return np.concatenate([2.0 * points[0] - after[::-1], points, 2.0 * points[-1] - before[::-1]])


def _resampled(points: Positions, step: PlanarStep, clip: Clip) -> tuple[Positions, float]:
    """Return the points at a multiple of the clip's rate, on cubics with Catmull-Rom slopes."""
    factor = max(1, math.ceil(_TRACK_RATE / clip.fps - 1e-9))
    if factor == 1 or len(points) < 3:
        return points, clip.fps
    padded = _padded(points, step, 1, cyclic=clip.cyclic)
    slopes = 0.5 * (padded[2:] - padded[:-2])
    dense = np.empty(((len(points) - 1) * factor + 1, *points.shape[1:]))
    dense[::factor] = points
    start, end, leave, arrive = points[:-1], points[1:], slopes[:-1], slopes[1:]
    for index in range(1, factor):
        u = index / factor
        dense[index::factor] = (
            (1.0 + 2.0 * u) * (1.0 - u) ** 2 * start
            + u * u * (3.0 - 2.0 * u) * end
            + u * (1.0 - u) ** 2 * leave
            + u * u * (u - 1.0) * arrive
        )
    return dense, clip.fps * factor


def _low_passed(points: Positions, step: PlanarStep, rate: float, *, cyclic: bool) -> Positions:
    """Return the points through a zero-phase Gaussian low-pass."""
    deviation = LOW_PASS_DEVIATION * rate
    radius = min(math.ceil(3.5 * deviation), len(points) - 1)
    if radius < 1:
        return points
    weights = np.exp(-0.5 * (np.arange(-radius, radius + 1) / deviation) ** 2)
    weights /= weights.sum()
    padded = _padded(points, step, radius, cyclic=cyclic)
    smooth = np.zeros_like(points)
    for index, weight in enumerate(weights):
        smooth += weight * padded[index : index + len(points)]
    return smooth


def _velocities(points: Positions, step: PlanarStep, rate: float, *, cyclic: bool) -> Positions:
    if len(points) < 2:
        return np.zeros_like(points)
    padded = _padded(points, step, 1, cyclic=cyclic)
    return 0.5 * rate * (padded[2:] - padded[:-2])


def _belt_velocity(
    points: Positions, velocities: Positions, travel_speed: float, leg_length: float
) -> tuple[float, float]:
    """Return the velocity of a treadmill, or zero: the median of the foot that is low.

    A clip counts as captured in place where its low foot runs, and faster than the pelvis
    travels.
    """
    heights = points[..., 1] - np.percentile(points[..., 1], 5.0, axis=0)
    flat = heights.reshape(len(points), 4)
    lowest = flat.argmin(axis=1)
    rows = np.arange(len(points))
    low = flat[rows, lowest] < 0.05 * leg_length
    if not low.any():
        return (0.0, 0.0)
    carried = velocities.reshape(len(points), 4, 3)[rows, lowest][low]
    x, z = float(np.median(carried[:, 0])), float(np.median(carried[:, 2]))
    speed = math.hypot(x, z)
    return (x, z) if speed > 0.25 and speed > 1.5 * travel_speed else (0.0, 0.0)
