"""The slip of a clip in its own supports (measures, section 1), written out."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Positions
from footfall.detection.pinning import foot_spans
from footfall.detection.tracks import points_of_pose
from footfall.motion import Clip, sample, with_soles
from footfall.skeleton import Anatomy, leg_length, world_poses
from footfall.support import SupportSequence

RATE = 60.0
EDGE = 0.067


def joints_at_60(clip: Clip) -> Positions:
    """Return all joints at 60 Hz [m], shape (frames, joints, 3)."""
    times = np.arange(int(clip.duration * RATE + 1e-6) + 1) / RATE
    return world_poses(clip.skeleton, *sample(clip, times))[1]


def inner_slips(clip: Clip, supports: SupportSequence, anatomy: Anatomy) -> list[float]:
    """Return the way of the carrying point of each support span [m], without its edges."""
    times = np.arange(int(clip.duration * RATE + 1e-6) + 1) / RATE
    poses = world_poses(clip.skeleton, *sample(clip, times))
    points = points_of_pose(*poses, with_soles(anatomy, *clip.world_poses()))
    slips: list[float] = []
    for foot, leg in enumerate(anatomy.legs):
        low = 0.05 * leg_length(clip.skeleton, leg)
        heights = points[:, foot, :, 1] - np.percentile(points[:, foot, :, 1], 5.0, axis=0)
        steps = np.linalg.norm(np.diff(points[:, foot][..., [0, 2]], axis=0), axis=-1)
        touching = (heights[1:] < low) & (heights[:-1] < low)
        lowest = np.take_along_axis(
            steps, (heights[1:] + heights[:-1]).argmin(axis=1)[:, np.newaxis], axis=1
        )[:, 0]
        carried = np.where(
            touching.any(axis=1), np.where(touching, steps, np.inf).min(axis=1), lowest
        )
        for span in foot_spans(supports, foot):
            first = max(int(np.ceil((span.start + EDGE) * RATE)), 0)
            last = int(np.floor((span.end - EDGE) * RATE))
            if min(last, len(carried)) > first:
                slips.append(float(carried[first:last].sum()))
    return slips


def sharpest(clip: Clip) -> float:
    """Return the acceleration of joints that one frame in a thousand exceeds [m/s²]."""
    accelerations = np.diff(joints_at_60(clip), 2, axis=0) * RATE**2
    return float(np.percentile(np.linalg.norm(accelerations, axis=-1), 99.9))
