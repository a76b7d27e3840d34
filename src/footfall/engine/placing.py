"""From the blended pose to this body, its legs on their footprints: stages 8 and 9."""

from __future__ import annotations

from footfall.adaptation.footprints import spring
from footfall.adaptation.pelvis import FALL_SPEED, RISE_SPEED, needed_drop
from footfall.arrays import Positions, Rotations
from footfall.blending.root import mix_point
from footfall.compilation import inner_kernel
from footfall.engine.record import Character
from footfall.engine.shelf import Shelf
from footfall.engine.state import Workspace
from footfall.geometry import quaternions, transforms
from footfall.skeleton.normalized import place_chain, reach_ankle
from footfall.skeleton.rig import Rig

__all__ = ["place_body", "write_world"]


@inner_kernel
def place_body(shelf: Shelf, rig: Rig, me: Character, work: Workspace, dt: float) -> None:
    """Give the pose this body's lengths, its feet their footprints (stage 8)."""
    leg = rig.leg_length
    place_chain(rig, work.turned, leg * me.effectors[0], work.rotations, work.positions)
    if not me.synchronized:
        return
    needed = 0.0
    for side in range(2):
        for axis in range(3):
            me.ankles[side, axis] = leg * me.effectors[1 + 3 * side + axis]
        x, y, z = _placed_ankle(rig, me, work, side)
        me.offset[0] = x - me.ankles[side, 0]
        me.offset[1] = y - me.ankles[side, 1]
        me.offset[2] = z - me.ankles[side, 2]
        needed = max(needed, needed_drop(rig, side, me.ankles[side], me.offset, work.positions))
        me.ankles[side, 0], me.ankles[side, 1], me.ankles[side, 2] = x, y, z
        me.shown_ankles[side, 0] = x / leg
        me.shown_ankles[side, 1] = z / leg
    drop = me.pelvis_drop
    speed = FALL_SPEED if needed > drop[0] else RISE_SPEED
    drop[0], drop[1] = spring(drop[0], drop[1], needed, speed, dt)
    for joint in range(shelf.joints):
        work.positions[joint, 1] -= drop[0]
    for side in range(2):
        reach_ankle(
            rig,
            side,
            work.turned,
            work.turned[shelf.joints :],
            me.ankles,
            work.rotations,
            work.positions,
        )


@inner_kernel
def _placed_ankle(
    rig: Rig, me: Character, work: Workspace, side: int
) -> tuple[float, float, float]:
    """Tilt a foot about the middle of its sole as the ground is, and put it on its footprint.

    Returns:
        Where its ankle then is, relative to the root [m].
    """
    leg = rig.leg_length
    offset = me.foot_offset[side]
    x, z = transforms.apply(0.0, 0.0, -me.root[2], offset[0], offset[2])
    px = leg * mix_point(me.points, side, 0.5, 0)
    py = leg * mix_point(me.points, side, 0.5, 1)
    pz = leg * mix_point(me.points, side, 0.5, 2)
    ax, ay, az = me.ankles[side, 0] - px, me.ankles[side, 1] - py, me.ankles[side, 2] - pz
    slope_x, slope_z = transforms.apply(0.0, 0.0, -me.root[2], me.tilt[side, 0], me.tilt[side, 1])
    if slope_x != 0.0 or slope_z != 0.0:
        q = quaternions.between(0.0, 1.0, 0.0, -slope_x, 1.0, -slope_z)
        ax, ay, az = quaternions.rotate(q[0], q[1], q[2], q[3], ax, ay, az)
        foot = work.turned[rig.parents.shape[0] + side]
        foot[0], foot[1], foot[2], foot[3] = quaternions.product(
            q[0], q[1], q[2], q[3], foot[0], foot[1], foot[2], foot[3]
        )
    return px + ax + x, py + ay + offset[1], pz + az + z


@inner_kernel
def write_world(
    shelf: Shelf,
    me: Character,
    work: Workspace,
    world_rotations: Rotations,
    world_positions: Positions,
) -> None:
    """Take the body from its root into the world (stage 9)."""
    root = me.root
    w, x, y, z = quaternions.from_yaw(root[2])
    for joint in range(shelf.joints):
        place = work.positions[joint]
        out = world_positions[joint]
        px, py, pz = quaternions.rotate(w, x, y, z, place[0], place[1], place[2])
        out[0] = root[0] + px
        out[1] = me.level[0] + py
        out[2] = root[1] + pz
        q = work.rotations[joint]
        turned = world_rotations[joint]
        turned[0], turned[1], turned[2], turned[3] = quaternions.product(
            w, x, y, z, q[0], q[1], q[2], q[3]
        )
