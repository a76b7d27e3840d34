"""Clean a clip once, at import: every planted foot is pinned, and the swing takes up the rest.

Recorded feet slide by some centimeters while they carry. Here each foot is moved so that the
point that carries it stays where it is, at the height at which it rests, and its leg is solved
again; how the foot is turned in the world, and where the knee points, stay as they were.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.detection.filters import gaussian
from footfall.detection.pinning import foot_spans, pinned_offsets
from footfall.detection.tracks import PlanarStep, foot_tracks, points_of_pose
from footfall.motion import Clip, place_feet, with_soles
from footfall.motion.pelvis_drop import pelvis_drops
from footfall.skeleton import Anatomy, find_anatomy
from footfall.support import SupportSequence

__all__ = ["CleanedClip", "clean", "clean_and_tell"]

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
    poses = clip.world_poses()
    points = points_of_pose(*poses, with_soles(anatomy, *poses))
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
    cleaned, rise = _cleaned(clip, anatomy, offsets)
    told = CleanedClip(cleaned, offsets, rise)
    return CleanedClip(cleaned.evolve(because=str(told)), offsets, rise)


def _cleaned(clip: Clip, anatomy: Anatomy, offsets: Positions) -> tuple[Clip, Floats]:
    """Return the clip with its feet moved, and how far its pelvis was raised, (frames,).

    The pelvis follows the mean of both feet slowly, so that legs keep their bend where a floor
    is leveled, and goes down before a leg is stretched further than it was.
    """
    skeleton, local = clip.skeleton, clip.local_rotations
    rotations, positions = clip.world_poses()
    joints = [leg.ankle for leg in anatomy.legs]
    ankles = positions[:, joints] + offsets
    pelvis = np.array(clip.pelvis_positions)
    pelvis[:, 1] += _leveled(offsets[..., 1].mean(axis=1), clip)
    pelvis[:, 1] -= pelvis_drops(
        skeleton, anatomy, pelvis, local, ankles, clip.fps, cyclic=clip.cyclic
    )
    placed = place_feet(skeleton, anatomy, pelvis, local, ankles, rotations[:, joints])
    placed /= np.linalg.norm(placed, axis=-1, keepdims=True)
    if clip.cyclic:
        placed[-1, 1:] = placed[0, 1:]
    rise = pelvis[:, 1] - clip.pelvis_positions[:, 1]
    return clip.evolve(pelvis_positions=pelvis, local_rotations=placed), rise


def _leveled(heights: Floats, clip: Clip) -> Floats:
    """Return one value a frame, slowly; on a cycle the last frame is the first."""
    deviation = _FLOOR_SPREAD * clip.fps
    if not clip.cyclic:
        return gaussian(heights, deviation)
    smooth = gaussian(heights[:-1], deviation, cyclic=True)
    return np.concatenate([smooth, smooth[:1]])
