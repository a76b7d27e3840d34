"""The normalized pose: what is blended, free of where the body is and of how long its legs are.

One row of numbers a pose, seen from the root (on the ground under the pelvis, y up, heading
smooth). Feet are *positions*: if several motions each keep a foot still, so does every fixed
weighted sum of them. Lengths are shares of the leg's length.

| channels | meaning |
|---|---|
| 4 × joints | rotation of each joint relative to its parent; of joint 0, relative to the root |
| 4 × 2 | rotation of each foot (ankle joint) relative to the root |
| 1 | height of the pelvis over the ground ÷ leg length |
| 3 × 2 | position of each ankle relative to the root ÷ leg length |

The rotations of thigh and shank are kept beside the position of the ankle: they say which way
the knee looks and how the leg is twisted, also where it is straight, and `reach_ankles` turns
them by as little as it takes to reach the ankle. One clip alone thus comes back as it was.
"""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Positions, Rotations, SmallFloats
from footfall.geometry import conjugate, continuous, from_yaw, multiply, rotate
from footfall.octets import LANES
from footfall.skeleton.kinematics import world_poses
from footfall.skeleton.rig import Rig
from footfall.skeleton.skeleton import Skeleton

__all__ = ["by_component", "channel_count", "normalize", "padded_count"]

EFFECTORS = 7
"""Numbers that are lengths: the pelvis' height and two ankle positions."""

ANKLES = 1
"""Where among them the ankle positions begin."""


def channel_count(joints: int) -> int:
    """Return how many numbers a normalized pose of so many joints has."""
    return 4 * joints + 8 + EFFECTORS


def normalize(
    skeleton: Skeleton,
    rig: Rig,
    pelvis_positions: Positions,
    local_rotations: Rotations,
    headings: Floats,
    floor: float,
) -> SmallFloats:
    """Return the normalized poses of a motion.

    Args:
        skeleton: The body that performs it.
        rig: The same body, packed.
        pelvis_positions: Joint 0 in the world [m], shape (frames, 3).
        local_rotations: Joints relative to their parents, shape (frames, joints, 4).
        headings: Of the root [rad], shape (frames,).
        floor: Height of the ground in the world of the motion [m].

    Returns:
        Normalized poses, shape (frames, channels).
    """
    world_rotations, world_positions = world_poses(skeleton, pelvis_positions, local_rotations)
    frames, joints = local_rotations.shape[:2]
    root_from_world = conjugate(from_yaw(headings))
    rotations = np.array(local_rotations)
    rotations[:, 0] = multiply(root_from_world, world_rotations[:, 0])
    ankles = rig.limbs[:, 2]
    feet = multiply(root_from_world[:, np.newaxis], world_rotations[:, ankles])
    roots = np.array(pelvis_positions)
    roots[:, 1] = floor
    from_root = world_positions[:, ankles] - roots[:, np.newaxis]
    places = rotate(root_from_world[:, np.newaxis], from_root) / rig.leg_length
    height = (pelvis_positions[:, 1] - floor) / rig.leg_length
    turned = continuous(np.concatenate([rotations, feet], axis=1))
    channels = np.empty((frames, channel_count(joints)), dtype=np.float32)
    channels[:, : 4 * joints + 8] = turned.reshape(frames, -1)
    channels[:, 4 * joints + 8] = height
    channels[:, 4 * joints + 9 :] = places.reshape(frames, -1)
    return channels


def padded_count(joints: int) -> int:
    """Return how many rotations a pose of so many joints has by component: full octets."""
    return -(-(joints + 2) // LANES) * LANES


def by_component(keys: SmallFloats, joints: int) -> SmallFloats:
    """Return normalized poses as the kernels blend them: component by component.

    Args:
        keys: Normalized poses, shape (frames, channels).
        joints: How many joints they have.

    Returns:
        w of every joint and of both feet, then x, y and z, each padded with zeros to full octets;
        then the lengths, padded likewise. Shape (frames, 4 padded + 8).
    """
    rotations, padded = joints + 2, padded_count(joints)
    out = np.zeros((len(keys), 4 * padded + LANES), dtype=np.float32)
    for component in range(4):
        first = component * padded
        out[:, first : first + rotations] = keys[:, component : 4 * rotations : 4]
    out[:, 4 * padded : 4 * padded + EFFECTORS] = keys[:, 4 * rotations :]
    return out
