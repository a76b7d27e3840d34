"""Clean a clip once, at import: every planted foot is pinned, and the swing takes up the rest.

Recorded feet slide by some centimeters while they carry. Here each foot is moved so that the
point that carries it stays where it is, at the height at which it rests, and its leg is solved
again; how the foot is turned in the world, and where the knee points, stay as they were.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Positions, Rotations
from footfall.compilation import kernel
from footfall.detection.filters import gaussian, moving_maximum
from footfall.detection.pinning import foot_spans, pinned_offsets
from footfall.detection.tracks import PlanarStep, foot_tracks, points_of_pose
from footfall.geometry import conjugate, multiply
from footfall.motion import Clip
from footfall.skeleton import Anatomy, find_anatomy, leg_length
from footfall.skeleton.two_bone_ik import LONGEST_REACH, SOFT_REACH, reach_point
from footfall.support import SupportSequence

__all__ = ["CleanedClip", "clean", "clean_and_tell"]

_DROP_SPREAD = 0.08
"""How gently the pelvis goes down where a leg would not reach, and up again: the deviation of
the filter over it [s]."""

_FLOOR_SPREAD = 0.3
"""How slowly the pelvis follows a floor that is leveled: the deviation of the filter [s]."""


@dataclass(frozen=True, eq=False)
class CleanedClip:
    """A cleaned clip, and how far it was moved for that."""

    clip: Clip
    """The clip with its planted feet pinned."""

    foot_offsets: Positions
    """How far each foot was moved [m], shape (frames, feet, 3)."""

    pelvis_offsets: Floats
    """How far the pelvis was raised [m], negative where it was lowered, shape (frames,)."""

    def __str__(self) -> str:
        """Return a sentence with the numbers."""
        moved = 1000.0 * np.linalg.norm(self.foot_offsets, axis=-1)
        return (
            f"planted feet pinned: feet moved by up to {moved.max():.0f} mm "
            f"(95 % of frames within {np.percentile(moved, 95.0):.0f} mm), "
            f"pelvis by up to {1000.0 * np.abs(self.pelvis_offsets).max():.0f} mm"
        )


def clean(clip: Clip, supports: SupportSequence, anatomy: Anatomy | None = None) -> Clip:
    """Return the clip with every planted foot pinned; see `clean_and_tell`."""
    return clean_and_tell(clip, supports, anatomy).clip


def clean_and_tell(
    clip: Clip, supports: SupportSequence, anatomy: Anatomy | None = None
) -> CleanedClip:
    """Pin every planted foot of a clip, and say how far it was moved for that.

    Args:
        clip: The motion.
        supports: Its support phases: which foot carries when.
        anatomy: Its skeleton's; found where not given.

    Returns:
        The clip, its provenance telling of it, with the offsets.
    """
    anatomy = find_anatomy(clip.skeleton) if anatomy is None else anatomy
    rotations, positions = clip.world_poses()
    points = points_of_pose(rotations, positions, anatomy)
    belt = np.array(foot_tracks(clip, anatomy).belt_velocity)
    times = np.arange(clip.frames) / clip.fps
    points[..., [0, 2]] -= (times[:, np.newaxis] * belt)[:, np.newaxis, np.newaxis]
    step = PlanarStep.of(clip) if clip.cyclic else PlanarStep()
    step = PlanarStep(step.yaw, step.x - belt[0] * clip.duration, step.z - belt[1] * clip.duration)
    offsets = np.stack(
        [
            pinned_offsets(
                points[:, foot], foot_spans(supports, foot), clip.fps, step, cyclic=clip.cyclic
            )
            for foot in range(2)
        ],
        axis=1,
    )
    rise = _pelvis_rise(clip, anatomy, positions, offsets)
    cleaned = _with_moved_feet(clip, anatomy, (rotations, positions), offsets, rise)
    told = CleanedClip(clip, offsets, rise)
    return CleanedClip(cleaned.evolve(because=str(told)), offsets, rise)


def _pelvis_rise(clip: Clip, anatomy: Anatomy, positions: Positions, offsets: Positions) -> Floats:
    """Return how far the pelvis is raised in each frame [m], shape (frames,).

    It follows the mean of both feet slowly, so that legs keep their bend where a floor is
    leveled, and goes down before a leg is stretched further than it was.
    """
    mean = offsets[..., 1].mean(axis=1)
    rise = _smoothed(mean, _FLOOR_SPREAD * clip.fps, cyclic=clip.cyclic)
    drop = np.zeros(clip.frames)
    for foot, leg in enumerate(anatomy.legs):
        length = leg_length(clip.skeleton, leg)
        hip, ankle = positions[:, leg.hip], positions[:, leg.ankle]
        reach = np.linalg.norm(ankle - hip, axis=1)
        longest = np.clip(reach, SOFT_REACH * length, LONGEST_REACH * length)
        wanted = ankle + offsets[:, foot] - hip
        level = np.hypot(wanted[:, 0], wanted[:, 2])
        depth = np.sqrt(np.maximum(longest**2 - level**2, 0.0))
        drop = np.maximum(drop, rise - wanted[:, 1] - depth)
    if drop.max() <= 0.0:
        return rise
    spread = _DROP_SPREAD * clip.fps
    widest = _widest(drop, round(2.0 * spread), cyclic=clip.cyclic)
    return rise - _smoothed(widest, spread, cyclic=clip.cyclic)


def _smoothed(values: Floats, deviation: float, *, cyclic: bool) -> Floats:
    """Return one value a frame through a low-pass; on a cycle the last frame is the first."""
    if not cyclic:
        return gaussian(values, deviation)
    smooth = gaussian(values[:-1], deviation, cyclic=True)
    return np.concatenate([smooth, smooth[:1]])


def _widest(values: Floats, radius: int, *, cyclic: bool) -> Floats:
    """Return the greatest of the values up to `radius` frames away."""
    if not cyclic:
        return moving_maximum(values, radius, cyclic=False)
    widest = moving_maximum(values[:-1], radius, cyclic=True)
    return np.concatenate([widest, widest[:1]])


def _with_moved_feet(
    clip: Clip,
    anatomy: Anatomy,
    pose: tuple[Rotations, Positions],
    offsets: Positions,
    rise: Floats,
) -> Clip:
    """Return the clip with feet and pelvis moved, and both legs solved again.

    Only the rotations of hips, knees and ankles relative to their parents change.
    """
    rotations, positions = pose
    parents = clip.skeleton.parents
    up = np.zeros((clip.frames, 3))
    up[:, 1] = rise
    local = np.array(clip.local_rotations)
    for foot, leg in enumerate(anatomy.legs):
        hip, knee, ankle = (positions[:, j] + up for j in (leg.hip, leg.knee, leg.ankle))
        toe = points_of_pose(rotations, positions, anatomy)[:, foot, 1]
        hints = (toe - positions[:, leg.ankle]) * np.array([1.0, 0.0, 1.0])
        hints /= np.maximum(np.linalg.norm(hints, axis=1, keepdims=True), 1e-9)
        upper, lower = np.empty((clip.frames, 4)), np.empty((clip.frames, 4))
        target = positions[:, leg.ankle] + offsets[:, foot]
        _turn_limbs((hip, knee, ankle, target, hints), upper, lower)
        turned = {leg.hip: upper, leg.knee: lower, leg.ankle: None}
        above: Rotations | None = None
        for joint, turn in turned.items():
            parent = rotations[:, parents[joint]]
            outside = parent if above is None else multiply(above, parent)
            world = rotations[:, joint] if turn is None else multiply(turn, rotations[:, joint])
            local[:, joint] = multiply(conjugate(outside), world)
            above = turn
    local /= np.linalg.norm(local, axis=-1, keepdims=True)
    if clip.cyclic:
        local[-1, 1:] = local[0, 1:]
    return clip.evolve(pelvis_positions=clip.pelvis_positions + up, local_rotations=local)


@kernel
def _turn_limbs(
    limbs: tuple[Positions, Positions, Positions, Positions, Positions],
    upper: Rotations,
    lower: Rotations,
) -> None:
    """Write how both bones of a limb turn, frame by frame, so that it reaches its target.

    Args:
        limbs: Start, middle and end of the limb, its target [m] and its bending direction,
            each of shape (frames, 3).
        upper: Written, shape (frames, 4).
        lower: Written, shape (frames, 4).
    """
    start, middle, end, target, hint = limbs
    for frame in range(upper.shape[0]):
        one, other, _, _ = reach_point(
            (start[frame, 0], start[frame, 1], start[frame, 2]),
            (middle[frame, 0], middle[frame, 1], middle[frame, 2]),
            (end[frame, 0], end[frame, 1], end[frame, 2]),
            (target[frame, 0], target[frame, 1], target[frame, 2]),
            (hint[frame, 0], hint[frame, 1], hint[frame, 2]),
        )
        for i in range(4):
            upper[frame, i] = one[i]
            lower[frame, i] = other[i]
