"""Put the hands of a clip where they should be, by turning its arms only."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Positions, Rotations
from footfall.compilation import kernel
from footfall.geometry import conjugate, multiply
from footfall.skeleton import Arm, Skeleton, world_poses
from footfall.skeleton.two_bone_ik import reach_point

__all__ = ["place_wrist"]


@kernel
def _reach(
    shoulders: Positions,
    elbows: Positions,
    wrists: Positions,
    targets: Positions,
    upper_turns: Rotations,
    lower_turns: Rotations,
) -> None:
    """Write the turns of upper arm and forearm, frame by frame; the elbow keeps its plane."""
    for frame in range(shoulders.shape[0]):
        upper, lower, _, _ = reach_point(
            (shoulders[frame, 0], shoulders[frame, 1], shoulders[frame, 2]),
            (elbows[frame, 0], elbows[frame, 1], elbows[frame, 2]),
            (wrists[frame, 0], wrists[frame, 1], wrists[frame, 2]),
            (targets[frame, 0], targets[frame, 1], targets[frame, 2]),
            (0.0, -1.0, 0.0),
        )
        for i in range(4):
            upper_turns[frame, i] = upper[i]
            lower_turns[frame, i] = lower[i]


def place_wrist(
    skeleton: Skeleton,
    arm: Arm,
    pelvis_positions: Positions,
    local_rotations: Rotations,
    wrists: Positions,
) -> Rotations:
    """Return local rotations with which one wrist is at its target, the hand turned as before.

    Out of reach it is approached softly. The elbow stays in the plane it is in.

    Args:
        skeleton: The body.
        arm: Which joints the arm is.
        pelvis_positions: Joint 0 in the world [m], shape (frames, 3).
        local_rotations: The poses as they are, shape (frames, joints, 4).
        wrists: Where the wrist should be [m], shape (frames, 3).
    """
    placed = np.array(local_rotations)
    rotations, positions = world_poses(skeleton, pelvis_positions, local_rotations)
    upper_turns, lower_turns = np.empty((2, len(placed), 4))
    _reach(
        np.ascontiguousarray(positions[:, arm.shoulder]),
        np.ascontiguousarray(positions[:, arm.elbow]),
        np.ascontiguousarray(positions[:, arm.wrist]),
        np.ascontiguousarray(wrists),
        upper_turns,
        lower_turns,
    )
    parents = skeleton.parents
    above = rotations[:, parents[arm.shoulder]]
    upper = multiply(upper_turns, rotations[:, arm.shoulder])
    placed[:, arm.shoulder] = multiply(conjugate(above), upper)
    above = multiply(upper_turns, rotations[:, parents[arm.elbow]])
    lower = multiply(lower_turns, rotations[:, arm.elbow])
    placed[:, arm.elbow] = multiply(conjugate(above), lower)
    above = multiply(lower_turns, rotations[:, parents[arm.wrist]])
    placed[:, arm.wrist] = multiply(conjugate(above), rotations[:, arm.wrist])
    return placed
