"""A clip at any time, past its ends too.

Offline sampling, for editing, files and reports: between two frames positions are mixed
linearly and rotations by slerp.
"""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Indices, Positions, Rotations, Seconds
from footfall.errors import ArgumentError
from footfall.geometry import conjugate, from_yaw, multiply, quaternions, rotate, slerp
from footfall.motion.clip import Clip

__all__ = ["cycle_displacement", "sample"]


def cycle_displacement(clip: Clip) -> tuple[Positions, float]:
    """Return the motion of the world that takes a clip's first pose onto its last one.

    Args:
        clip: A cyclic clip.

    Returns:
        A translation [m], shape (3,), level, and the yaw [rad] about the origin before it.
    """
    turn = multiply(clip.local_rotations[-1, 0], conjugate(clip.local_rotations[0, 0]))
    yaw = float(quaternions.yaw_of(float(turn[0]), float(turn[2])))
    yaw = float(np.remainder(yaw + np.pi, 2.0 * np.pi) - np.pi)
    first = rotate(from_yaw(yaw), clip.pelvis_positions[0])
    return (clip.pelvis_positions[-1] - first) * np.array([1.0, 0.0, 1.0]), yaw


def sample(clip: Clip, times: Seconds) -> tuple[Positions, Rotations]:
    """Return the poses of a clip at any times.

    Before its start and after its end a clip stays on its first or last pose; a cyclic one goes
    on, each cycle displaced from the one before as its last frame is from its first.

    Args:
        clip: The motion.
        times: Times [s], the first frame being at 0, shape (times,).

    Returns:
        Positions of joint 0 [m], shape (times, 3), and local rotations, shape
        (times, joints, 4).

    Raises:
        ArgumentError: If a time is not finite.
    """
    times = np.asarray(times, dtype=np.float64)
    if not np.isfinite(times).all():
        raise ArgumentError(f"time {int(np.argmin(np.isfinite(times)))} is not finite")
    last = clip.frames - 1
    where = times * clip.fps
    cycles = np.zeros(len(times), dtype=np.int64)
    if clip.cyclic:
        cycles = np.floor(where / last + 1e-12).astype(np.int64)
        where = where - cycles * last
    where = np.clip(where, 0.0, last)
    before = np.minimum(where.astype(np.int64), max(last - 1, 0))
    after = np.minimum(before + 1, last)
    fraction = where - before
    share = fraction[:, np.newaxis]
    positions = (1.0 - share) * clip.pelvis_positions[before]
    positions += share * clip.pelvis_positions[after]
    rotations = slerp(clip.local_rotations[before], clip.local_rotations[after], share)
    if cycles.any():
        positions, rotations[:, 0] = _displace(clip, cycles, positions, rotations[:, 0])
    return positions, rotations


def _displace(
    clip: Clip, cycles: Indices, positions: Positions, rotations: Rotations
) -> tuple[Positions, Rotations]:
    """Return poses of joint 0 moved on by so many cycles each."""
    shift, yaw = cycle_displacement(clip)
    turns: Floats = yaw * np.arange(int(np.abs(cycles).max()) + 1, dtype=np.float64)
    ahead = np.cumsum(rotate(from_yaw(turns), shift), axis=0)
    ahead = np.concatenate([np.zeros((1, 3)), ahead])
    # Going back k cycles undoes going ahead: p = R⁻ᵏ (q - s).
    count = np.abs(cycles)
    angles: Floats = yaw * cycles.astype(np.float64)
    forward = from_yaw(angles)
    moved = np.where(
        (cycles >= 0)[:, np.newaxis],
        rotate(forward, positions) + ahead[count],
        rotate(forward, positions - ahead[count]),
    )
    return moved, multiply(forward, rotations)
