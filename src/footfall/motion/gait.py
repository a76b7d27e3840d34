"""How the feet of a clip move over the ground: their speed, and which of them swings.

Coarser than contact detection, and enough to say whether a stretch of motion is one gait cycle.
"""

from __future__ import annotations

import numpy as np

from footfall.arrays import Flags, Floats, Positions
from footfall.geometry import rotate
from footfall.skeleton import Anatomy, FootPoint

__all__ = ["foot_point_paths", "foot_speeds", "swinging"]

SWING_SHARE = 0.3
"""Share of a foot's own greatest speed (95th percentile) above which it swings. In stance feet
move at 1 to 10 % of it; toes of runs, the worst, at 10 to 25 %."""

RELEASE_SHARE = 0.2
"""Share below which a swing is over: the two thresholds keep noise from cutting a swing."""

LEAST_SWING_SPEED = 0.3
"""Speed [m/s] that a foot must reach, or it never swings: a standing foot trembles at 0.2."""

TREADMILL_SHARE = 0.3
"""A clip is captured in place where its pelvis moves slower than this share of the speed at
which its low foot moves backward."""


def foot_point_paths(
    anatomy: Anatomy, world_rotations: Floats, world_positions: Positions
) -> Positions:
    """Return heels and toes in the world [m], shape (frames, 2, 2, 3), heel before toe."""

    def path(point: FootPoint) -> Positions:
        offset = rotate(world_rotations[:, point.joint], np.array(point.offset))
        return world_positions[:, point.joint] + offset

    feet = [np.stack([path(leg.heel), path(leg.toe)], axis=1) for leg in anatomy.legs]
    return np.stack(feet, axis=1)


def foot_speeds(points: Positions, pelvis: Positions, fps: float) -> Floats:
    """Return the speed of each foot over the ground, that of its slower point.

    Where a clip is captured in place, the ground is the treadmill's belt: it moves with the
    median velocity of the lower foot.

    Args:
        points: Heels and toes in the world [m], shape (frames, 2, 2, 3).
        pelvis: Joint 0 in the world [m], shape (frames, 3).
        fps: Frames per second.

    Returns:
        Speeds [m/s], shape (frames, 2).
    """
    if len(points) < 2:
        return np.zeros(points.shape[:2])
    velocities = np.gradient(points, 1.0 / fps, axis=0)
    lowest = points[..., 1].min(axis=2).argmin(axis=1)
    low = velocities[np.arange(len(points)), lowest].mean(axis=1) * np.array([1.0, 0.0, 1.0])
    belt = np.median(low, axis=0)
    drift = (pelvis[-1] - pelvis[0])[[0, 2]] * fps / (len(pelvis) - 1)
    if float(np.hypot(*drift)) < TREADMILL_SHARE * float(np.linalg.norm(belt)):
        velocities = velocities - belt
    speeds: Floats = np.linalg.norm(velocities, axis=-1).min(axis=-1)
    return speeds


def swinging(speeds: Floats) -> Flags:
    """Return in which frames a foot swings.

    Args:
        speeds: Of one foot over the ground [m/s], shape (frames,).
    """
    fast = max(float(np.percentile(speeds, 95.0)), LEAST_SWING_SPEED)
    state = False
    states: list[bool] = []
    for speed in speeds:
        state = bool(speed > (RELEASE_SHARE if state else SWING_SHARE) * fast)
        states.append(state)
    if max(speeds) < LEAST_SWING_SPEED:
        return np.zeros(len(speeds), dtype=np.bool_)
    return np.array(states)
