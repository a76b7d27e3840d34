"""From the blended pose to this body on this ground: stages 7 to 9."""

from __future__ import annotations

from footfall.adaptation.footprints import GRIP_TIME, hold_foot, release_foot, spring
from footfall.adaptation.pelvis import FALL_SPEED, RISE_SPEED, needed_drop
from footfall.arrays import Positions, Rotations
from footfall.blending.root import mix_point
from footfall.compilation import inner_kernel
from footfall.engine.feet import carries
from footfall.engine.record import Character
from footfall.engine.shelf import Shelf
from footfall.engine.state import Workspace
from footfall.geometry import quaternions, transforms
from footfall.skeleton.normalized import place_chain, reach_ankle
from footfall.skeleton.rig import Rig

__all__ = ["keep_footprints", "place_body", "write_world"]


@inner_kernel
def keep_footprints(rig: Rig, me: Character, dt: float) -> None:
    """Hold the carrying feet where they are, let go of the others (stage 7)."""
    root = me.root
    leg = rig.leg_length
    for side in range(2):
        share = me.toe_shares[side]
        old_x = mix_point(me.world_points, side, share, 0)
        old_z = mix_point(me.world_points, side, share, 2)
        for point in range(2):
            place = me.points[side, point]
            x, z = transforms.apply(root[0], root[1], root[2], leg * place[0], leg * place[2])
            me.world_points[side, point, 0] = x
            me.world_points[side, point, 1] = leg * place[1]
            me.world_points[side, point, 2] = z
        slide_x = mix_point(me.world_points, side, share, 0) - old_x
        slide_z = mix_point(me.world_points, side, share, 2) - old_z
        planted = carries(me.support, side)
        me.planted_time[side] = me.planted_time[side] + dt if planted else 0.0
        if not me.printed or me.fresh:
            continue
        offset, velocity = me.foot_offset[side], me.foot_velocity[side]
        heel, toe = leg * me.heights[side, 0], leg * me.heights[side, 1]
        if planted:
            height = (1.0 - share) * heel + share * toe
            hold_foot(offset, velocity, (slide_x, slide_z), height, _grip(me, side), dt)
        else:
            release_foot(offset, velocity, min(heel, toe), dt)


@inner_kernel
def _grip(me: Character, side: int) -> float:
    """Return how firmly a carrying foot is held: less where its span begins or ends."""
    grip = min(1.0, me.planted_time[side] / GRIP_TIME)
    if me.slot_duration > 0.0 and not carries(me.results[1], side):
        left = (1.0 - me.slot_progress) * me.slot_duration
        grip = min(grip, left / GRIP_TIME)
    return max(grip, 0.0)


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
        offset = _offset_in_root(me, side)
        for axis in range(3):
            me.offset[axis] = offset[axis]
        needed = max(needed, needed_drop(rig, side, me.ankles[side], me.offset, work.positions))
        for axis in range(3):
            me.ankles[side, axis] += me.offset[axis]
        me.shown_ankles[side, 0] = me.ankles[side, 0] / leg
        me.shown_ankles[side, 1] = me.ankles[side, 2] / leg
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
def _offset_in_root(me: Character, side: int) -> tuple[float, float, float]:
    """Return how far a footprint moves a foot, seen from the root [m]."""
    offset = me.foot_offset[side]
    x, z = transforms.apply(0.0, 0.0, -me.root[2], offset[0], offset[2])
    return x, offset[1], z


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
        out[1] = me.ground_height + py
        out[2] = root[1] + pz
        q = work.rotations[joint]
        turned = world_rotations[joint]
        turned[0], turned[1], turned[2], turned[3] = quaternions.product(
            w, x, y, z, q[0], q[1], q[2], q[3]
        )
