"""Forward kinematics: where every joint is, from how every joint is turned."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Indices, Positions, Rotations
from footfall.compilation import kernel
from footfall.geometry import quaternions
from footfall.skeleton.skeleton import Skeleton

__all__ = ["forward_kinematics", "pose_forward", "world_poses"]


@kernel
def pose_forward(
    parents: Indices,
    rest_offsets: Positions,
    local_rotations: Rotations,
    rotations: Rotations,
    positions: Positions,
) -> None:
    """Place the joints of one pose; `rotations[0]` and `positions[0]` are given.

    Args:
        parents: Parent of each joint, shape (joints,).
        rest_offsets: Joint in its parent's frame [m], shape (joints, 3).
        local_rotations: Joint relative to its parent, shape (joints, 4); row 0 is not read.
        rotations: Written from row 1 on, in the frame of row 0, shape (joints, 4).
        positions: Written from row 1 on [m], shape (joints, 3).
    """
    for joint in range(1, parents.shape[0]):
        parent = parents[joint]
        qw, qx, qy, qz = (
            rotations[parent, 0],
            rotations[parent, 1],
            rotations[parent, 2],
            rotations[parent, 3],
        )
        x, y, z = quaternions.rotate(
            qw, qx, qy, qz, rest_offsets[joint, 0], rest_offsets[joint, 1], rest_offsets[joint, 2]
        )
        positions[joint, 0] = positions[parent, 0] + x
        positions[joint, 1] = positions[parent, 1] + y
        positions[joint, 2] = positions[parent, 2] + z
        (
            rotations[joint, 0],
            rotations[joint, 1],
            rotations[joint, 2],
            rotations[joint, 3],
        ) = quaternions.product(
            qw,
            qx,
            qy,
            qz,
            local_rotations[joint, 0],
            local_rotations[joint, 1],
            local_rotations[joint, 2],
            local_rotations[joint, 3],
        )


@kernel
def forward_kinematics(
    parents: Indices,
    rest_offsets: Positions,
    pelvis_positions: Positions,
    local_rotations: Rotations,
    world_rotations: Rotations,
    world_positions: Positions,
) -> None:
    """Place the joints of many poses; arguments as in `pose_forward`, frames leading."""
    for frame in range(local_rotations.shape[0]):
        world_rotations[frame, 0] = local_rotations[frame, 0]
        world_positions[frame, 0] = pelvis_positions[frame]
        pose_forward(
            parents,
            rest_offsets,
            local_rotations[frame],
            world_rotations[frame],
            world_positions[frame],
        )


def world_poses(
    skeleton: Skeleton, pelvis_positions: Positions, local_rotations: Rotations
) -> tuple[Rotations, Positions]:
    """Return where every joint is and how it is turned, frame by frame.

    Args:
        skeleton: The body.
        pelvis_positions: Joint 0 in the world [m], shape (frames, 3).
        local_rotations: Joints relative to their parents, joint 0 relative to the world, shape
            (frames, joints, 4).

    Returns:
        World rotations, shape (frames, joints, 4), and world positions [m], shape
        (frames, joints, 3).
    """
    world_rotations = np.empty(local_rotations.shape)
    world_positions = np.empty((*local_rotations.shape[:-1], 3))
    forward_kinematics(
        skeleton.parents,
        skeleton.rest_offsets,
        np.ascontiguousarray(pelvis_positions, dtype=np.float64),
        np.ascontiguousarray(local_rotations, dtype=np.float64),
        world_rotations,
        world_positions,
    )
    return world_rotations, world_positions
