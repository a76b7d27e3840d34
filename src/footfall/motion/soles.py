"""Where the sole of a foot is under its heel: most skeletons have no joint there.

A foot that rolls turns about its heel, lies flat, and turns about its toes. The ankle, a hand's
breadth over the ground, goes far meanwhile; a heel on the sole does not, so that a foot can be
held at it. Rest poses do not tell how a foot stands (its toes may point at the ceiling there), so
its attitude is taken from the motion: where the ankle is lowest, the foot is flat. Frames in which
the body sits or lies do not count: there a foot may be on its side.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from footfall.arrays import Flags, Positions, Rotations
from footfall.geometry import conjugate, rotate
from footfall.skeleton import Anatomy, FootPoint, Leg

__all__ = ["flat_frames", "with_soles"]

FLAT_SHARE = 20.0
"""Percentile of an ankle's heights below which its foot is taken to be flat."""

HEEL_SHARE = 0.3
"""How far the heel is behind the ankle, as a share of how far the toe joint is before it
(Winter 2009, figure 4.1: a foot of 0.152 H, its ankle 0.039 H high and over its hind third)."""

LEAST_HEIGHT = 0.5
"""A body stands where its pelvis is this much of a leg's length over its ankle."""

SHORTEST = 1e-3
"""Feet shorter than this have no sole [m]."""


def with_soles(anatomy: Anatomy, rotations: Rotations, positions: Positions) -> Anatomy:
    """Return an anatomy whose heels are on the soles of the feet, level with the toe joints.

    Only heels that are the ankle joint itself are moved: a heel joint of the skeleton's own is
    better. A foot without a toe stays as it is, and so do the feet of a body that never stands.

    Args:
        anatomy: What the joints are.
        rotations: All joints in the world during a motion, shape (frames, joints, 4).
        positions: Likewise [m], shape (frames, joints, 3).
    """
    left, right = (_with_sole(leg, rotations, positions) for leg in anatomy.legs)
    return replace(anatomy, left=left, right=right)


def flat_frames(leg: Leg, positions: Positions) -> Flags:
    """Return the frames in which a foot is flat, shape (frames,): its ankle is lowest there.

    None where the body never stands.

    Args:
        leg: Which joints the leg is.
        positions: All joints in the world during a motion [m], shape (frames, joints, 3).
    """
    joints = positions[:, [leg.hip, leg.knee, leg.ankle]]
    length = np.linalg.norm(np.diff(joints[0], axis=0), axis=-1).sum()
    heights = positions[:, leg.ankle, 1]
    stands = positions[:, 0, 1] - heights > LEAST_HEIGHT * length
    if not stands.any():
        return stands
    return stands & (heights <= np.percentile(heights[stands], FLAT_SHARE))


def _with_sole(leg: Leg, rotations: Rotations, positions: Positions) -> Leg:
    if leg.heel != FootPoint(leg.ankle, (0.0, 0.0, 0.0)) or leg.toe == leg.heel:
        return leg
    flat = flat_frames(leg, positions)
    if not flat.any():
        return leg
    ankle_from_world = conjugate(rotations[flat, leg.ankle])
    toes = positions[flat, leg.toe.joint] - positions[flat, leg.ankle]
    toes = toes + rotate(rotations[flat, leg.toe.joint], np.array(leg.toe.offset))
    toe = np.median(rotate(ankle_from_world, toes), axis=0)
    down = np.median(rotate(ankle_from_world, np.array([0.0, -1.0, 0.0])), axis=0)
    down /= max(float(np.linalg.norm(down)), SHORTEST)
    drop = float(toe @ down)
    forward = toe - drop * down
    if np.linalg.norm(forward) < SHORTEST:
        return leg
    x, y, z = (drop * down - HEEL_SHARE * forward).tolist()
    return replace(leg, heel=FootPoint(leg.ankle, (x, y, z)))
