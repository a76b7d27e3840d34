"""Put the feet of a clip where they should be, by turning its legs only."""

from __future__ import annotations

import math

import numpy as np

from footfall.arrays import Floats, Positions, Rotations
from footfall.compilation import kernel
from footfall.geometry import conjugate, multiply
from footfall.skeleton import Anatomy, Leg, Skeleton, pelvis_headings, world_poses
from footfall.skeleton.two_bone_ik import reach_point

__all__ = ["IN_PLACE", "place_feet"]

IN_PLACE = 1e-6
"""Distance below which an ankle is where it should be [m]."""


@kernel
def _reach(
    hips: Positions,
    knees: Positions,
    ankles: Positions,
    targets: Positions,
    headings: Floats,
    upper_turns: Rotations,
    lower_turns: Rotations,
) -> None:
    """Write the turns of thigh and shank, frame by frame; knees bend forward where straight."""
    for frame in range(hips.shape[0]):
        upper, lower, _, _ = reach_point(
            (hips[frame, 0], hips[frame, 1], hips[frame, 2]),
            (knees[frame, 0], knees[frame, 1], knees[frame, 2]),
            (ankles[frame, 0], ankles[frame, 1], ankles[frame, 2]),
            (targets[frame, 0], targets[frame, 1], targets[frame, 2]),
            (math.sin(headings[frame]), 0.0, math.cos(headings[frame])),
        )
        for i in range(4):
            upper_turns[frame, i] = upper[i]
            lower_turns[frame, i] = lower[i]


def place_feet(
    skeleton: Skeleton,
    anatomy: Anatomy,
    pelvis_positions: Positions,
    local_rotations: Rotations,
    ankles: Positions,
    foot_rotations: Rotations,
) -> Rotations:
    """Return local rotations with which the ankles are at their targets.

    Where a target is out of reach the leg approaches it softly. What hangs on the ankle moves
    with it. A leg whose ankle is in place in all frames is left as it is, however straight.

    Args:
        skeleton: The body.
        anatomy: Which joints its legs are.
        pelvis_positions: Joint 0 in the world [m], shape (frames, 3).
        local_rotations: The poses as they are, shape (frames, joints, 4).
        ankles: Where left and right ankle should be [m], shape (frames, 2, 3).
        foot_rotations: How the ankle joints should be turned in the world, (frames, 2, 4).
    """
    placed = np.array(local_rotations)
    rotations, positions = world_poses(skeleton, pelvis_positions, local_rotations)
    headings = pelvis_headings(anatomy, positions)
    for foot, leg in enumerate(anatomy.legs):
        _place_foot(
            skeleton,
            leg,
            rotations,
            positions,
            headings,
            np.ascontiguousarray(ankles[:, foot]),
            foot_rotations[:, foot],
            placed,
        )
    return placed


def _place_foot(
    skeleton: Skeleton,
    leg: Leg,
    rotations: Rotations,
    positions: Positions,
    headings: Floats,
    ankles: Positions,
    foot_rotations: Rotations,
    placed: Rotations,
) -> None:
    if np.abs(ankles - positions[:, leg.ankle]).max() < IN_PLACE:
        above = rotations[:, skeleton.parents[leg.ankle]]
        placed[:, leg.ankle] = multiply(conjugate(above), foot_rotations)
        return
    upper_turns, lower_turns = np.empty(foot_rotations.shape), np.empty(foot_rotations.shape)
    _reach(
        np.ascontiguousarray(positions[:, leg.hip]),
        np.ascontiguousarray(positions[:, leg.knee]),
        np.ascontiguousarray(positions[:, leg.ankle]),
        ankles,
        headings,
        upper_turns,
        lower_turns,
    )
    parents = skeleton.parents
    above_hip = rotations[:, parents[leg.hip]]
    hip = multiply(upper_turns, rotations[:, leg.hip])
    placed[:, leg.hip] = multiply(conjugate(above_hip), hip)
    above_knee = multiply(upper_turns, rotations[:, parents[leg.knee]])
    knee = multiply(lower_turns, rotations[:, leg.knee])
    placed[:, leg.knee] = multiply(conjugate(above_knee), knee)
    above_ankle = multiply(lower_turns, rotations[:, parents[leg.ankle]])
    placed[:, leg.ankle] = multiply(conjugate(above_ankle), foot_rotations)
