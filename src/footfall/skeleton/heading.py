"""Which way a body faces, from the line between its hip joints."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.skeleton.anatomy import Anatomy

__all__ = ["pelvis_headings"]

LEAST_LEVEL_SHARE = 0.2
"""Level share of the line between the hips below which it tells no heading: 78° of tilt, where
a millimeter of noise on one hip already turns it by one to two degrees."""


def pelvis_headings(anatomy: Anatomy, world_positions: Positions) -> Floats:
    """Return the heading of the pelvis in each frame, unwrapped.

    It is the yaw that turns +x into the line from the right to the left hip joint, seen from
    above. Where that line stands nearly upright (a cartwheel) its direction says nothing, and the
    heading is interpolated from the frames before and after.

    Args:
        anatomy: Which joints the hips are.
        world_positions: Joints in the world [m], shape (frames, joints, 3).

    Returns:
        Headings [rad], 0 facing +z, positive from z towards x, shape (frames,).
    """
    across = world_positions[:, anatomy.left.hip] - world_positions[:, anatomy.right.hip]
    level = np.hypot(across[:, 0], across[:, 2])
    told = level > LEAST_LEVEL_SHARE * np.linalg.norm(across, axis=-1)
    if not told.any():
        return np.zeros(len(across))
    headings: Floats = np.unwrap(np.arctan2(-across[told, 2], across[told, 0]))
    frames = np.arange(len(across))
    return np.interp(frames, frames[told], headings)
