"""Where every joint is, by recursion over the tree with rotation matrices."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Positions, Rotations
from footfall.skeleton import Skeleton


def rotation_matrix(quaternion: Rotations) -> Floats:
    """Return the matrix of one quaternion wxyz, from its textbook form."""
    w, x, y, z = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def joint_frames(
    skeleton: Skeleton, pelvis_position: Positions, local_rotations: Rotations
) -> tuple[Floats, Positions]:
    """Return the world matrices (joints, 3, 3) and positions (joints, 3) of one pose."""
    matrices = np.full((skeleton.count, 3, 3), np.nan)
    positions = np.full((skeleton.count, 3), np.nan)

    def place(joint: int, matrix: Floats, position: Positions) -> None:
        matrices[joint] = matrix @ rotation_matrix(local_rotations[joint])
        positions[joint] = position
        for child in skeleton.children(joint):
            place(child, matrices[joint], position + matrices[joint] @ skeleton.rest_offsets[child])

    place(0, np.eye(3), pelvis_position)
    return matrices, positions
