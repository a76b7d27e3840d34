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
the knee looks and how the leg is twisted, also where it is straight, and `reach_ankle` turns
them by as little as it takes to reach the ankle. One clip alone thus comes back as it was.
"""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Positions, Rotations, SmallFloats
from footfall.compilation import kernel
from footfall.geometry import conjugate, continuous, from_yaw, multiply, quaternions, rotate
from footfall.skeleton.kinematics import pose_forward, world_poses
from footfall.skeleton.rig import FOOT, THIGH, Rig
from footfall.skeleton.skeleton import Skeleton
from footfall.skeleton.two_bone_ik import reach_point, turn_about

__all__ = ["channel_count", "normalize", "place_chain", "reach_ankle"]

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


@kernel
def place_chain(
    rig: Rig,
    local_rotations: Rotations,
    pelvis_height: float,
    rotations: Rotations,
    positions: Positions,
) -> None:
    """Place every joint by its rotation alone.

    Args:
        rig: The body.
        local_rotations: As blended, joint 0 relative to the root, shape (joints, 4).
        pelvis_height: Over the ground [m].
        rotations: Written: joints relative to the root, shape (joints, 4).
        positions: Written: joints relative to the root [m], shape (joints, 3).
    """
    for i in range(4):
        rotations[0, i] = local_rotations[0, i]
    positions[0, 0] = 0.0
    positions[0, 1] = pelvis_height
    positions[0, 2] = 0.0
    pose_forward(rig.parents, rig.rest_offsets, local_rotations, rotations, positions)


@kernel
def reach_ankle(
    rig: Rig,
    side: int,
    local_rotations: Rotations,
    foot_rotations: Rotations,
    ankles: Positions,
    rotations: Rotations,
    positions: Positions,
) -> None:
    """Turn one leg so that its ankle is where it should be and its foot as it was blended.

    Args:
        rig: The body.
        side: 0 for the left leg, 1 for the right one.
        local_rotations: As blended, shape (joints, 4).
        foot_rotations: As blended, relative to the root, shape (2, 4).
        ankles: Where the ankles should be, relative to the root [m], shape (2, 3).
        rotations: Joints relative to the root, shape (joints, 4); the leg's are rewritten.
        positions: Joints relative to the root [m], shape (joints, 3); likewise.
    """
    hip, knee, ankle = rig.limbs[side, 0], rig.limbs[side, 1], rig.limbs[side, 2]
    upper, lower, bent, end = reach_point(
        (positions[hip, 0], positions[hip, 1], positions[hip, 2]),
        (positions[knee, 0], positions[knee, 1], positions[knee, 2]),
        (positions[ankle, 0], positions[ankle, 1], positions[ankle, 2]),
        (ankles[side, 0], ankles[side, 1], ankles[side, 2]),
        (0.0, 0.0, 1.0),
    )
    hip_x, hip_y, hip_z = positions[hip, 0], positions[hip, 1], positions[hip, 2]
    knee_x, knee_y, knee_z = positions[knee, 0], positions[knee, 1], positions[knee, 2]
    for joint in range(hip, rig.parents.shape[0]):
        if rig.leg_sides[joint] != side:
            continue
        segment = rig.leg_segments[joint]
        if joint == ankle:
            positions[joint, 0], positions[joint, 1], positions[joint, 2] = end
            for i in range(4):
                rotations[joint, i] = foot_rotations[side, i]
        elif segment == FOOT:
            _follow_parent(rig, joint, local_rotations, rotations, positions)
        elif segment == THIGH:
            turn_about(
                joint, upper, (hip_x, hip_y, hip_z), (hip_x, hip_y, hip_z), rotations, positions
            )
        else:
            turn_about(joint, lower, (knee_x, knee_y, knee_z), bent, rotations, positions)


@kernel
def _follow_parent(
    rig: Rig,
    joint: int,
    local_rotations: Rotations,
    rotations: Rotations,
    positions: Positions,
) -> None:
    """Place one joint from its parent."""
    parent = rig.parents[joint]
    p = rotations[parent]
    offset = rig.rest_offsets[joint]
    x, y, z = quaternions.rotate(p[0], p[1], p[2], p[3], offset[0], offset[1], offset[2])
    positions[joint, 0] = positions[parent, 0] + x
    positions[joint, 1] = positions[parent, 1] + y
    positions[joint, 2] = positions[parent, 2] + z
    q = local_rotations[joint]
    turned = rotations[joint]
    turned[0], turned[1], turned[2], turned[3] = quaternions.product(
        p[0], p[1], p[2], p[3], q[0], q[1], q[2], q[3]
    )
