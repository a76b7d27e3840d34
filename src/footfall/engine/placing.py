"""From blended poses to bodies, their legs on their footprints: stages 8 and 9."""

from __future__ import annotations

from typing import Any

import numpy.typing as npt

from footfall.adaptation.footprints import settle
from footfall.adaptation.pelvis import FALL_SPEED, RISE_SPEED, needed_drop
from footfall.arrays import Positions, Rotations, SmallFloats
from footfall.blending.root import mix_point
from footfall.compilation import lean_kernel, small_kernel
from footfall.engine.feet import stance_shift
from footfall.engine.foot_turns import foot_rotation
from footfall.engine.moment import Moment
from footfall.engine.record import NO_REACHING, Character
from footfall.engine.state import Workspace
from footfall.geometry import quaternions, transforms
from footfall.octet_memory import load, store, transpose
from footfall.octets import LANES, exponential, greater, select
from footfall.skeleton.octet_poses import (
    PLACEMENT,
    joint_at,
    lower_bodies,
    place_chains,
    reach_ankles,
)
from footfall.skeleton.rig import Rig

__all__ = ["STEP", "aim_body", "place_bodies", "reach_footprints", "world_poses_of"]

STEP, HEIGHT, DROP, DROP_SPEED, REACHES, ANKLE, OFFSET = 0, 1, 2, 3, 4, 5, 11
"""Rows of `Workspace.aims`: the time step [s], less than 0 for a row that is left out; the pelvis'
height over the root, how far it is lowered and how fast
that changes [m], [m/s]; whether the legs reach at all; the ankles of the blended pose and how far
footprints move them, three numbers a foot [m]."""


AGES = 10.0
"""A time in which every spring comes to rest [s]."""


@small_kernel
def aim_body(rig: Rig, me: Character, work: Workspace, lane: int) -> None:
    """Say what one body has to reach: its feet on their footprints (stage 8)."""
    leg, aims = rig.leg_length, work.aims
    moment: Moment = work.moments[0]
    aims[HEIGHT, lane] = leg * moment.effectors[0]
    aims[DROP, lane], aims[DROP_SPEED, lane] = me.pelvis_drop[0], me.pelvis_drop[1]
    aims[REACHES, lane] = 1.0 if me.synchronized and me.detail != NO_REACHING else 0.0
    if not me.synchronized:
        return
    if me.placed:
        # The pelvis of a body that was put somewhere is at once where its legs need it.
        aims[STEP, lane] = AGES
    for side in range(2):
        ankle = (
            leg * moment.effectors[1 + 3 * side],
            leg * moment.effectors[2 + 3 * side],
            leg * moment.effectors[3 + 3 * side],
        )
        x, y, z = _placed_ankle(rig, me, moment, work.blended[lane], side, ankle)
        me.shown_ankles[side, 0], me.shown_ankles[side, 1] = x / leg, z / leg
        placed = (x, y, z)
        # A stance is not the pose's own: the pelvis sinks for it as for a footprint.
        x, z = stance_shift(me, side)
        own = (ankle[0] - leg * x, ankle[1], ankle[2] - leg * z)
        for axis in range(3):
            aims[ANKLE + 3 * side + axis, lane] = own[axis]
            aims[OFFSET + 3 * side + axis, lane] = placed[axis] - own[axis]


@small_kernel
def _placed_ankle(
    rig: Rig,
    me: Character,
    moment: Moment,
    blended: SmallFloats,
    side: int,
    ankle: tuple[float, float, float],
) -> tuple[float, float, float]:
    """Turn and tilt a foot about the middle of its sole, and put it on its footprint.

    Returns:
        Where its ankle then is, relative to the root [m].
    """
    leg = rig.leg_length
    offset = me.foot_offset[side]
    cosine, sine = me.facing[0], -me.facing[1]
    x, z = transforms.turn(cosine, sine, offset[0], offset[2])
    if me.tilt[side, 0] == 0.0 and me.tilt[side, 1] == 0.0 and not me.twisted:
        return ankle[0] + x, ankle[1] + offset[1], ankle[2] + z
    px = leg * mix_point(moment.points, side, 0.5, 0)
    py = leg * mix_point(moment.points, side, 0.5, 1)
    pz = leg * mix_point(moment.points, side, 0.5, 2)
    slope_x, slope_z = transforms.turn(cosine, sine, me.tilt[side, 0], me.tilt[side, 1])
    q = foot_rotation(me, side, slope_x, slope_z)
    ax, ay, az = quaternions.rotate(
        q[0], q[1], q[2], q[3], ankle[0] - px, ankle[1] - py, ankle[2] - pz
    )
    rows = rig.part_masks.shape[1]
    foot = rig.parents.shape[0] + side
    turned = quaternions.product(
        q[0],
        q[1],
        q[2],
        q[3],
        float(blended[foot]),
        float(blended[foot + rows]),
        float(blended[foot + 2 * rows]),
        float(blended[foot + 3 * rows]),
    )
    for i in range(4):
        blended[foot + i * rows] = turned[i]
    return px + ax + x, py + ay + offset[1], pz + az + z


@small_kernel
def place_bodies(
    rig: Rig,
    characters: npt.NDArray[Any],
    work: Workspace,
    poses: SmallFloats,
    block: int,
) -> None:
    """Give eight poses their body's lengths, their feet their footprints (stage 8)."""
    rows = min(LANES, characters.shape[0] - block * LANES)
    for lane in range(rows):
        if work.aims[STEP, lane] < 0.0:
            for joint in range(poses.shape[1]):
                for i in range(PLACEMENT):
                    work.kept[lane, joint, i] = poses[block, joint, i, lane]
    _place_all(rig, work, poses, block)
    for lane in range(rows):
        if work.aims[STEP, lane] < 0.0:
            for joint in range(poses.shape[1]):
                for i in range(PLACEMENT):
                    poses[block, joint, i, lane] = work.kept[lane, joint, i]
        else:
            me: Character = characters[block * LANES + lane]
            me.pelvis_drop[0] = work.aims[DROP, lane]
            me.pelvis_drop[1] = work.aims[DROP_SPEED, lane]


@small_kernel
def _place_all(rig: Rig, work: Workspace, poses: SmallFloats, block: int) -> None:
    """Place all eight, those that are left out too."""
    stride = work.blended.shape[1]
    for row in range(0, stride - LANES, LANES):
        transpose(work.blended, row, stride, work.local, row * LANES)
    place_chains(rig, work.local, load(work.aims, HEIGHT * LANES), poses, block)
    reach_footprints(rig, work, poses, block)


@small_kernel
def reach_footprints(rig: Rig, work: Workspace, poses: SmallFloats, block: int) -> None:
    """Lower eight pelvises as far as their legs need, and let the legs reach their footprints."""
    reaches = load(work.aims, REACHES * LANES) > 0.5
    drop = _lower_pelvis(rig, work.aims, poses, block, reaches)
    lower_bodies(poses, block, drop)
    for side in range(2):
        x, y, z = _aim(work.aims, ANKLE + 3 * side)
        dx, dy, dz = _aim(work.aims, OFFSET + 3 * side)
        ankle = (x + dx, y + dy, z + dz)
        reach_ankles(rig, side, work.local, ankle, reaches, poses, block)


@small_kernel
def _aim(aims: SmallFloats, row: int) -> tuple[float, float, float]:
    at = row * LANES
    return load(aims, at), load(aims, at + LANES), load(aims, at + 2 * LANES)


@small_kernel
def _lower_pelvis(
    rig: Rig, aims: SmallFloats, poses: SmallFloats, block: int, reaches: bool
) -> float:
    """Let eight pelvises sink as far as their legs need, and rise again; return how far [m]."""
    needed = select(reaches, 0.0, 0.0)
    for side in range(2):
        _, hip = joint_at(poses, block, rig.limbs[side, 0])
        ankle, offset = _aim(aims, ANKLE + 3 * side), _aim(aims, OFFSET + 3 * side)
        needed = greater(needed, needed_drop(rig.leg_length, hip, ankle, offset))
    drop, speed = load(aims, DROP * LANES), load(aims, DROP_SPEED * LANES)
    falls = needed > drop
    stiffness, dt = select(falls, FALL_SPEED, RISE_SPEED), load(aims, STEP * LANES)
    decay = exponential(-stiffness * dt)
    new_drop, new_speed = settle(drop, speed, needed, stiffness, dt, decay)
    store(aims, DROP * LANES, select(reaches, new_drop, drop))
    store(aims, DROP_SPEED * LANES, select(reaches, new_speed, speed))
    return select(reaches, new_drop, 0.0)


@lean_kernel
def world_poses_of(
    characters: npt.NDArray[Any],
    poses: SmallFloats,
    world_rotations: Rotations,
    world_positions: Positions,
) -> None:
    """Take bodies from their roots into the world (stage 9).

    Args:
        characters: Records of `character_type`, shape (rows,).
        poses: Joints relative to the roots, shape (blocks, joints, 7, 8).
        world_rotations: Written, shape (rows, joints, 4).
        world_positions: Written [m], shape (rows, joints, 3).
    """
    for row in range(characters.shape[0]):
        me: Character = characters[row]
        root, block, lane = me.root, row // LANES, row % LANES
        w, x, y, z = quaternions.from_yaw(root[2])
        for joint in range(poses.shape[1]):
            one = poses[block, joint]
            px, py, pz = quaternions.rotate(
                w, x, y, z, float(one[4, lane]), float(one[5, lane]), float(one[6, lane])
            )
            out = world_positions[row, joint]
            out[0], out[1], out[2] = root[0] + px, me.level[0] + py, root[1] + pz
            turned = world_rotations[row, joint]
            turned[0], turned[1], turned[2], turned[3] = quaternions.product(
                w,
                x,
                y,
                z,
                float(one[0, lane]),
                float(one[1, lane]),
                float(one[2, lane]),
                float(one[3, lane]),
            )
