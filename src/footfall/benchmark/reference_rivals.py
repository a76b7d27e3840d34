"""The reference work without the engine's blocks: in plain NumPy, and one character at a time."""

from __future__ import annotations

from typing import Any

import numpy as np

from footfall.arrays import Positions, Rotations, SmallFloats
from footfall.benchmark.reference_work import LAYERS, Task
from footfall.compilation import kernel
from footfall.geometry import multiply, quaternions, rotate
from footfall.skeleton.kinematics import pose_forward
from footfall.skeleton.rig import FOOT, THIGH
from footfall.skeleton.two_bone_ik import Quaternion, Vector, reach_point

__all__ = ["work_in_numpy", "work_one_by_one"]

_product: Any = multiply
_turned: Any = rotate

TOGETHER = 256
"""Characters that NumPy works on at a time: what fits into the caches."""


def work_in_numpy(task: Task) -> SmallFloats:
    """Mix the poses and place the joints of all characters, legs as blended; shape as below.

    Without the legs' reaching, in NumPy's favor: it would take half as long again.
    """
    positions = np.empty((len(task.frames), len(task.rig.parents), 3), dtype=np.float32)
    for first in range(0, len(task.frames), TOGETHER):
        rows = slice(first, first + TOGETHER)
        positions[rows] = _chains(task, _blended(task, rows), task.aims[rows, 0])
    return positions


def _blended(task: Task, rows: slice) -> SmallFloats:
    """Return the mixed rotations, by component, shape (4, rows, rotations)."""
    count = task.rig.part_masks.shape[1]
    frames = task.frames[rows]
    one = task.keys[frames]
    mixed = one + (task.keys[frames + 1] - one) * task.fractions[rows, :, np.newaxis]
    q = mixed[..., : 4 * count].reshape(len(frames), LAYERS, 4, count)
    shares = task.weights[rows] @ task.rig.part_masks
    total = q[:, 0] * shares[:, 0, np.newaxis]
    for layer in range(1, LAYERS):
        dots = np.einsum("nci,nci->ni", total, q[:, layer])
        total += q[:, layer] * np.copysign(shares[:, layer], dots)[:, np.newaxis]
    length = np.sqrt(np.einsum("nci,nci->ni", total, total))
    length[length == 0.0] = 1.0
    total /= length[:, np.newaxis]
    return np.asarray(total.transpose(0, 2, 1), dtype=np.float32)


def _chains(task: Task, local: SmallFloats, height: SmallFloats) -> SmallFloats:
    rig, rows = task.rig, len(local)
    rotations = np.empty((rows, len(rig.parents), 4), dtype=np.float32)
    positions = np.zeros((rows, len(rig.parents), 3), dtype=np.float32)
    rotations[:, 0] = local[:, 0]
    positions[:, 0, 1] = height
    offsets = rig.rest_offsets.astype(np.float32)
    for joint in range(1, len(rig.parents)):
        parent = rig.parents[joint]
        rotations[:, joint] = _product(rotations[:, parent], local[:, joint])
        positions[:, joint] = positions[:, parent] + _turned(rotations[:, parent], offsets[joint])
    return positions


@kernel
def work_one_by_one(
    task: Task, local: Rotations, rotations: Rotations, positions: Positions
) -> None:
    """Do the whole work in a kernel, one character after the other.

    Args:
        task: What is to be done.
        local: Memory for one pose, shape (rotations, 4).
        rotations: Written, shape (rows, joints, 4).
        positions: Written [m], shape (rows, joints, 3).
    """
    rig = task.rig
    for row in range(task.frames.shape[0]):
        _mix(task, row, local)
        for i in range(4):
            rotations[row, 0, i] = local[0, i]
        positions[row, 0, 0] = positions[row, 0, 2] = 0.0
        positions[row, 0, 1] = task.aims[row, 0]
        pose_forward(rig.parents, rig.rest_offsets, local, rotations[row], positions[row])
        for side in range(2):
            _reach(task, row, side, local, rotations[row], positions[row])


@kernel
def _mix(task: Task, row: int, local: Rotations) -> None:
    masks = task.rig.part_masks
    count = masks.shape[1]
    joints = task.rig.parents.shape[0]
    for joint in range(joints + 2):
        part = task.rig.parts[joint] if joint < joints else 0
        w, x, y, z = 0.0, 0.0, 0.0, 0.0
        for layer in range(LAYERS):
            frame, fraction = task.frames[row, layer], task.fractions[row, layer]
            one, other = task.keys[frame], task.keys[frame + 1]
            qw = one[joint] + (other[joint] - one[joint]) * fraction
            i = joint + count
            qx = one[i] + (other[i] - one[i]) * fraction
            i += count
            qy = one[i] + (other[i] - one[i]) * fraction
            i += count
            qz = one[i] + (other[i] - one[i]) * fraction
            share = task.weights[row, layer, part]
            if w * qw + x * qx + y * qy + z * qz < 0.0:
                share = -share
            w, x, y, z = w + share * qw, x + share * qx, y + share * qy, z + share * qz
        q = quaternions.normalize(w, x, y, z)
        local[joint, 0], local[joint, 1], local[joint, 2], local[joint, 3] = q


@kernel
def _reach(
    task: Task, row: int, side: int, local: Rotations, rotations: Rotations, positions: Positions
) -> None:
    rig, p = task.rig, positions
    hip, knee, end = rig.limbs[side, 0], rig.limbs[side, 1], rig.limbs[side, 2]
    aim = task.aims[row]
    at = 1 + 3 * side
    hips = (p[hip, 0], p[hip, 1], p[hip, 2])
    knees = (p[knee, 0], p[knee, 1], p[knee, 2])
    ends = (p[end, 0], p[end, 1], p[end, 2])
    target = (float(aim[at]), float(aim[at + 1]), float(aim[at + 2]))
    upper, lower, bent, reached = reach_point(hips, knees, ends, target, (0.0, 0.0, 1.0))
    for joint in range(hip, rig.parents.shape[0]):
        if rig.leg_sides[joint] != side:
            continue
        segment = rig.leg_segments[joint]
        q = rotations[joint]
        if joint == end:
            p[joint, 0], p[joint, 1], p[joint, 2] = reached
            for i in range(4):
                q[i] = local[rig.parents.shape[0] + side, i]
            continue
        if segment == FOOT:
            _follow(task, joint, local, rotations, positions)
        elif segment == THIGH:
            _turn(upper, hips, hips, joint, rotations, positions)
        else:
            _turn(lower, knees, bent, joint, rotations, positions)


@kernel
def _turn(
    turn: Quaternion,
    pivot: Vector,
    place: Vector,
    joint: int,
    rotations: Rotations,
    positions: Positions,
) -> None:
    q, p = rotations[joint], positions
    x, y, z = quaternions.rotate(
        turn[0],
        turn[1],
        turn[2],
        turn[3],
        p[joint, 0] - pivot[0],
        p[joint, 1] - pivot[1],
        p[joint, 2] - pivot[2],
    )
    p[joint, 0], p[joint, 1], p[joint, 2] = place[0] + x, place[1] + y, place[2] + z
    q[0], q[1], q[2], q[3] = quaternions.product(
        turn[0], turn[1], turn[2], turn[3], q[0], q[1], q[2], q[3]
    )


@kernel
def _follow(
    task: Task, joint: int, local: Rotations, rotations: Rotations, positions: Positions
) -> None:
    parent, offset = task.rig.parents[joint], task.rig.rest_offsets[joint]
    q, own, out = rotations[parent], local[joint], rotations[joint]
    x, y, z = quaternions.rotate(q[0], q[1], q[2], q[3], offset[0], offset[1], offset[2])
    positions[joint, 0] = positions[parent, 0] + x
    positions[joint, 1] = positions[parent, 1] + y
    positions[joint, 2] = positions[parent, 2] + z
    out[0], out[1], out[2], out[3] = quaternions.product(
        q[0], q[1], q[2], q[3], own[0], own[1], own[2], own[3]
    )
