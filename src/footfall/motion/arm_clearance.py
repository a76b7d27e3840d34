"""Keep the arms of a retargeted motion out of the trunk.

Shoulders of another breadth, or arms of another length, take hands to where another trunk is.
Where a forearm is deeper in the trunk than the leader's, the whole arm is turned about its
shoulder, outwards, by as little as it takes; before and after that it goes there smoothly.
"""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Positions, Rotations
from footfall.geometry import conjugate, from_rotation_vector, multiply, rotate
from footfall.motion.smooth_cover import covered, spread
from footfall.skeleton import Anatomy, Skeleton, world_poses
from footfall.skeleton.capsule_overlap import forearm_overlap

__all__ = ["clear_arm"]

MARGIN = 0.005
"""How much deeper than the leader's an arm may be [m]."""

TURN_TIME = 0.2
"""Time before and after a frame over which a turn of the arm builds up and fades [s]."""

ROUNDS = 16
"""How often the arm is looked at again: turning it out of one place may take it into another."""

LONGEST_TURN = 0.5
"""Greatest turn of one round [rad]."""


def clear_arm(
    skeleton: Skeleton,
    anatomy: Anatomy,
    side: int,
    pose: tuple[Positions, Rotations],
    allowed: Floats,
    fps: float,
    cyclic: bool,
) -> Rotations:
    """Return local rotations with which one forearm is no deeper in the trunk than allowed.

    Args:
        skeleton: The body.
        anatomy: What its joints are.
        side: 0 for the left arm, 1 for the right one.
        pose: Joint 0 in the world [m], shape (frames, 3), and local rotations, shape
            (frames, joints, 4).
        allowed: How deep it may be [m], shape (frames,).
        fps: Frames per second.
        cyclic: Whether the last frame is the first one again.
    """
    pelvis, local = pose
    arm = anatomy.arms[side]
    if arm is None:
        return local
    cleared = np.array(local)
    parent = int(skeleton.parents[arm.shoulder])
    reach = max(1, round(TURN_TIME * fps))
    for _ in range(ROUNDS):
        rotations, positions = world_poses(skeleton, pelvis, cleared)
        found = forearm_overlap(skeleton, anatomy, positions, side)
        if found is None:
            break
        excess = np.maximum(found.depths - allowed - MARGIN, 0.0)
        if cyclic:
            excess[-1] = excess[0] = max(excess[0], excess[-1])
        if not excess.any():
            break
        lever = found.points - positions[:, arm.shoulder]
        turns = rotate(conjugate(rotations[:, parent]), _turns(lever, found.outward, excess))
        turn = from_rotation_vector(_smoothed(turns, reach, cyclic))
        cleared[:, arm.shoulder] = multiply(turn, cleared[:, arm.shoulder])
    return cleared


def _turns(lever: Positions, outward: Positions, excess: Floats) -> Positions:
    """Return the rotation vectors that move the end of a lever outwards, (frames, 3)."""
    axes = np.cross(lever, outward)
    moment = np.maximum((axes**2).sum(axis=-1), 1e-9)
    angles = np.minimum(excess / np.sqrt(moment), LONGEST_TURN)
    return (angles / np.sqrt(moment))[:, np.newaxis] * axes


def _smoothed(turns: Positions, reach: int, cyclic: bool) -> Positions:
    """Return turns that are as large as needed, building up and fading smoothly."""
    sizes = covered(np.linalg.norm(turns, axis=-1), reach, cyclic)
    directions = spread(turns, reach, cyclic)
    lengths = np.maximum(np.linalg.norm(directions, axis=-1), 1e-12)
    return (sizes / lengths)[:, np.newaxis] * directions
