"""Close a cycle: make its last pose the first one, moved on over the ground.

Captured motion misses its own beginning by 10 to 50 mm. The body takes that up evenly over the
whole cycle; each foot takes it up while it swings, so that planted feet stay where they were.
"""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Positions, Rotations
from footfall.errors import ClipError
from footfall.geometry import conjugate, from_yaw, multiply, rotate, slerp
from footfall.motion.clip import Clip
from footfall.motion.cycle_search import find_cycle, main_joints
from footfall.motion.editing import crop_frames
from footfall.motion.gait import foot_point_paths, foot_speeds, swinging
from footfall.motion.ground_alignment import align_on_ground
from footfall.motion.leg_placement import place_feet
from footfall.motion.pelvis_drop import pelvis_drops
from footfall.skeleton import Anatomy

__all__ = ["close_cycle", "cut_cycle"]

_IDENTITY = np.array([1.0, 0.0, 0.0, 0.0])


def cut_cycle(clip: Clip, anatomy: Anatomy) -> Clip:
    """Return one clean cycle of a long clip, closed.

    Args:
        clip: The motion.
        anatomy: Which joints its legs are.

    Raises:
        ClipError: If there is no stretch that could be repeated.
    """
    start, end, mismatch = find_cycle(clip, anatomy)
    cropped = crop_frames(clip, start, end)
    found = cropped.evolve(
        because=f"frames {start} to {end} were found to be one cycle of "
        f"{(end - start) / clip.fps:.3f} s, its ends {1000 * mismatch:.0f} mm apart (root mean "
        "square over the joints)"
    )
    return close_cycle(found, anatomy)


def close_cycle(clip: Clip, anatomy: Anatomy) -> Clip:
    """Return a clip as a cycle that starts over without a jump.

    Its last pose becomes the first one, moved over the ground by what fits the two best. What is
    missing is spread: over all frames for the body, over the frames in which it swings for each
    foot, and the legs are solved again.

    Args:
        clip: About one cycle, from its first pose to the next one like it.
        anatomy: Which joints its legs are.

    Raises:
        ClipError: If the clip has fewer than three frames.
    """
    if clip.frames < 3:
        raise ClipError(
            f"clip {clip.name!r} has {clip.frames} frames; a cycle needs at least three"
        )
    rotations, positions = clip.world_poses()
    points = foot_point_paths(anatomy, rotations, positions)
    joints = main_joints(anatomy)
    yaw, shift, _ = align_on_ground(positions[0, joints], positions[-1, joints])
    turn = from_yaw(yaw)
    ramp = np.arange(clip.frames, dtype=np.float64) / (clip.frames - 1)
    missing = rotate(turn, positions[0, 0]) + shift - positions[-1, 0]
    pelvis = positions[:, 0] + ramp[:, np.newaxis] * missing
    local = _spread_rotations(clip.local_rotations, turn, ramp)

    shares = _foot_shares(points, positions[:, 0], clip.fps)
    toes_missing = rotate(turn, points[0, :, 1]) + shift - points[-1, :, 1]
    ankle_joints = [leg.ankle for leg in anatomy.legs]
    feet = rotations[:, ankle_joints]
    turns = _foot_turns(feet, turn, shares)
    toes = points[:, :, 1] + shares[..., np.newaxis] * toes_missing
    ankles = toes + rotate(turns, positions[:, ankle_joints] - points[:, :, 1])
    drops = pelvis_drops(clip.skeleton, anatomy, pelvis, local, ankles, clip.fps, cyclic=True)
    pelvis[:, 1] -= drops
    local = place_feet(clip.skeleton, anatomy, pelvis, local, ankles, multiply(turns, feet))
    local[-1] = local[0]
    local[-1, 0] = multiply(turn, local[0, 0])

    body, foot = np.linalg.norm(missing), np.linalg.norm(toes_missing, axis=-1).max()
    return clip.evolve(
        pelvis_positions=pelvis,
        local_rotations=local / np.linalg.norm(local, axis=-1, keepdims=True),
        cyclic=True,
        because=f"closed to a cycle: its end was moved by {1000 * body:.0f} mm at the pelvis, "
        f"spread over the cycle, and up to {1000 * foot:.0f} mm at the toes, spread over their "
        "swings",
    )


def _foot_shares(points: Positions, pelvis: Positions, fps: float) -> Floats:
    """Return how much of what is missing each foot has taken up, 0 to 1, (frames, 2).

    It grows with the way that the foot makes while it swings, and not while it is planted.
    """
    speeds = foot_speeds(points, pelvis, fps)
    shares = np.empty(speeds.shape)
    for foot in range(2):
        pace = np.where(swinging(speeds[:, foot]), speeds[:, foot], 0.0)
        if not pace.any():
            pace = np.ones(len(pace))
        way = np.concatenate([[0.0], np.cumsum(0.5 * (pace[1:] + pace[:-1]))])
        shares[:, foot] = way / way[-1]
    return shares


def _spread_rotations(local_rotations: Rotations, turn: Rotations, ramp: Floats) -> Rotations:
    """Return the rotations with what the last lacks to the first taken up along the ramp."""
    goals = local_rotations[0].copy()
    goals[0] = multiply(turn, goals[0])
    missing = multiply(conjugate(local_rotations[-1]), goals)
    part = slerp(_IDENTITY, missing, ramp[:, np.newaxis])
    return multiply(local_rotations, part)


def _foot_turns(feet: Rotations, turn: Rotations, shares: Floats) -> Rotations:
    """Return the world rotations to be added to the feet's, about their toes, (frames, 2, 4).

    About the toes, since a planted foot rolls on them while its ankle already rises.
    """
    missing = multiply(multiply(turn, feet[0]), conjugate(feet[-1]))
    return slerp(_IDENTITY, missing, shares)
