"""Eight bodies at once: where their joints are, their legs reaching for their ankles.

A block of poses is `PLACEMENT` octets a joint: its rotation w, x, y, z, then its position x, y,
z, all relative to the root, in single precision. One body is a block that is partly filled.
"""

from __future__ import annotations

from footfall.arrays import SmallFloats
from footfall.compilation import small_kernel
from footfall.geometry import quaternions
from footfall.octet_memory import load, spread, store
from footfall.octets import LANES, select
from footfall.skeleton.rig import FOOT, THIGH, Rig
from footfall.skeleton.two_bone_ik import Quaternion, Vector, reach_point

__all__ = ["PLACEMENT", "joint_at", "lower_bodies", "place_chains", "reach_ankles"]

PLACEMENT = 7
"""Numbers that place a joint: four of its rotation, three of its position."""

Placement = tuple[Quaternion, Vector]


@small_kernel
def joint_at(poses: SmallFloats, block: int, joint: int) -> Placement:
    """Return rotation and position of a joint of eight bodies.

    Args:
        poses: Shape (blocks, joints, 7, 8).
        block: Which eight bodies.
        joint: Which joint.
    """
    at = (block * poses.shape[1] + joint) * PLACEMENT * LANES
    rotation = (
        load(poses, at),
        load(poses, at + LANES),
        load(poses, at + 2 * LANES),
        load(poses, at + 3 * LANES),
    )
    position = (
        load(poses, at + 4 * LANES),
        load(poses, at + 5 * LANES),
        load(poses, at + 6 * LANES),
    )
    return rotation, position


@small_kernel
def _put_joint(poses: SmallFloats, block: int, joint: int, where: Placement) -> None:
    at = (block * poses.shape[1] + joint) * PLACEMENT * LANES
    rotation, position = where
    store(poses, at, rotation[0])
    store(poses, at + LANES, rotation[1])
    store(poses, at + 2 * LANES, rotation[2])
    store(poses, at + 3 * LANES, rotation[3])
    store(poses, at + 4 * LANES, position[0])
    store(poses, at + 5 * LANES, position[1])
    store(poses, at + 6 * LANES, position[2])


@small_kernel
def _local_rotation(local: SmallFloats, row: int) -> Quaternion:
    """Return a blended rotation of eight bodies: of a joint, or of a foot, which come last."""
    stride = local.shape[1] * LANES
    at = row * LANES
    return (
        load(local, at),
        load(local, at + stride),
        load(local, at + 2 * stride),
        load(local, at + 3 * stride),
    )


@small_kernel
def _below_parent(
    rig: Rig, local: SmallFloats, poses: SmallFloats, block: int, joint: int
) -> Placement:
    """Return where a joint is by its own rotation and where its parent is."""
    p, (px, py, pz) = joint_at(poses, block, rig.parents[joint])
    q = _local_rotation(local, joint)
    offset = rig.rest_offsets[joint]
    x, y, z = quaternions.rotate(p[0], p[1], p[2], p[3], offset[0], offset[1], offset[2])
    turned = quaternions.product(p[0], p[1], p[2], p[3], q[0], q[1], q[2], q[3])
    return turned, (px + x, py + y, pz + z)


@small_kernel
def place_chains(
    rig: Rig, local: SmallFloats, pelvis_height: float, poses: SmallFloats, block: int
) -> None:
    """Place every joint of eight bodies by its rotation alone.

    Args:
        rig: The body.
        local: As blended, joint 0 and the feet relative to the root, shape (4, rows, 8).
        pelvis_height: Over the root [m]: an octet.
        poses: Written, shape (blocks, joints, 7, 8).
        block: Which eight.
    """
    place = (spread(0.0), pelvis_height, spread(0.0))
    _put_joint(poses, block, 0, (_local_rotation(local, 0), place))
    for joint in range(1, rig.parents.shape[0]):
        _put_joint(poses, block, joint, _below_parent(rig, local, poses, block, joint))


@small_kernel
def lower_bodies(poses: SmallFloats, block: int, drop: float) -> None:
    """Lower every joint of eight bodies, each by its own amount [m]: an octet."""
    for joint in range(poses.shape[1]):
        at = ((block * poses.shape[1] + joint) * PLACEMENT + 5) * LANES
        store(poses, at, load(poses, at) - drop)


@small_kernel
def reach_ankles(
    rig: Rig,
    side: int,
    local: SmallFloats,
    ankle: Vector,
    reaches: bool,
    poses: SmallFloats,
    block: int,
) -> None:
    """Turn one leg of eight bodies so that ankles are where they should be, feet as blended.

    Args:
        rig: The body.
        side: 0 for the left leg, 1 for the right one.
        local: As for `place_chains`.
        ankle: Where the ankle should be, relative to the root [m]: three octets.
        reaches: Which of the eight reach at all: an octet of claims.
        poses: As `place_chains` has left them; the leg is rewritten.
        block: Which eight.
    """
    hip, knee, end = rig.limbs[side, 0], rig.limbs[side, 1], rig.limbs[side, 2]
    _, hips = joint_at(poses, block, hip)
    _, knees = joint_at(poses, block, knee)
    _, ends = joint_at(poses, block, end)
    upper, lower, bent, reached = reach_point(hips, knees, ends, ankle, (0.0, 0.0, 1.0))
    for joint in range(hip, rig.parents.shape[0]):
        if rig.leg_sides[joint] != side:
            continue
        segment = rig.leg_segments[joint]
        old = joint_at(poses, block, joint)
        if joint == end:
            feet = rig.parents.shape[0] + side
            new = (_local_rotation(local, feet), reached)
        elif segment == FOOT:
            new = _below_parent(rig, local, poses, block, joint)
        elif segment == THIGH:
            new = _turned_about(old, upper, hips, hips)
        else:
            new = _turned_about(old, lower, knees, bent)
        _put_joint(poses, block, joint, _chosen(reaches, new, old))


@small_kernel
def _turned_about(old: Placement, turn: Quaternion, pivot: Vector, new_pivot: Vector) -> Placement:
    """Return a joint turned about a pivot, which itself moves."""
    q, place = old
    x, y, z = quaternions.rotate(
        turn[0],
        turn[1],
        turn[2],
        turn[3],
        place[0] - pivot[0],
        place[1] - pivot[1],
        place[2] - pivot[2],
    )
    turned = quaternions.product(turn[0], turn[1], turn[2], turn[3], q[0], q[1], q[2], q[3])
    return turned, (new_pivot[0] + x, new_pivot[1] + y, new_pivot[2] + z)


@small_kernel
def _chosen(where: bool, one: Placement, other: Placement) -> Placement:
    """Return one placement where a claim holds, else the other."""
    (aw, ax, ay, az), (apx, apy, apz) = one
    (bw, bx, by, bz), (bpx, bpy, bpz) = other
    rotation = (
        select(where, aw, bw),
        select(where, ax, bx),
        select(where, ay, by),
        select(where, az, bz),
    )
    return rotation, (select(where, apx, bpx), select(where, apy, bpy), select(where, apz, bpz))
