"""Lower the pelvis a little where the feet would be out of the legs' reach."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Positions, Rotations
from footfall.motion.leg_placement import IN_PLACE
from footfall.motion.smooth_cover import covered
from footfall.skeleton import Anatomy, Skeleton, leg_length, world_poses
from footfall.skeleton.two_bone_ik import SOFT_REACH

__all__ = ["pelvis_drops"]

DROP_TIME = 0.15
"""Time before and after a frame over which a drop of the pelvis builds up and fades [s]."""


def pelvis_drops(
    skeleton: Skeleton,
    anatomy: Anatomy,
    pelvis_positions: Positions,
    local_rotations: Rotations,
    ankles: Positions,
    fps: float,
    cyclic: bool,
) -> Floats:
    """Return how far to lower the pelvis so that legs need not stretch for their ankles.

    A leg may be as straight as it was, or bent as little as where it would be softened. The drops
    are smooth and at least what each frame needs.

    Args:
        skeleton: The body.
        anatomy: Which joints its legs are.
        pelvis_positions: Joint 0 in the world [m], shape (frames, 3).
        local_rotations: The poses before their legs are placed, shape (frames, joints, 4).
        ankles: Where left and right ankle will be [m], shape (frames, 2, 3).
        fps: Frames per second.
        cyclic: Whether the last frame is the first one again.

    Returns:
        Drops [m], >= 0, shape (frames,).
    """
    _, positions = world_poses(skeleton, pelvis_positions, local_rotations)
    needed = np.zeros(len(ankles))
    for foot, leg in enumerate(anatomy.legs):
        hips = positions[:, leg.hip]
        length = leg_length(skeleton, leg)
        present = np.linalg.norm(positions[:, leg.ankle] - hips, axis=-1)
        reach = np.maximum(present, SOFT_REACH * length)
        apart = hips - ankles[:, foot]
        level = np.minimum(np.hypot(apart[:, 0], apart[:, 2]), reach)
        height = np.sqrt(reach**2 - level**2)
        needed = np.maximum(needed, apart[:, 1] - height)
    if needed.max() < IN_PLACE:
        return np.zeros(len(needed))
    return covered(needed, max(1, round(DROP_TIME * fps)), cyclic)
