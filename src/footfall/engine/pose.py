"""From clip times and weights to a blended pose and the root's way: stages 4 to 6."""

from __future__ import annotations

from footfall.adaptation.footprints import toe_share
from footfall.blending.poses import add_pose, clear_pose, finish_pose
from footfall.blending.root import correct_displacement, foot_slide
from footfall.compilation import inner_kernel
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf, key_at, read_points, travel
from footfall.engine.state import RUNNING, Workspace
from footfall.geometry import quaternions, transforms
from footfall.skeleton import BodyPart
from footfall.skeleton.rig import Rig
from footfall.support import Support

__all__ = ["blend_poses", "carries", "locate_feet", "move_root"]

LEGS = int(BodyPart.LEGS)
LEFT_FOOT = int(Support.LEFT) & ~int(Support.RIGHT)
RIGHT_FOOT = int(Support.RIGHT) & ~int(Support.LEFT)


@inner_kernel
def carries(support: int, side: int) -> bool:
    """Return whether a foot, 0 left or 1 right, is among those that carry."""
    return (support & (LEFT_FOOT if side == 0 else RIGHT_FOOT)) != 0


@inner_kernel
def blend_poses(shelf: Shelf, rig: Rig, me: Character, work: Workspace) -> None:
    """Sample every action and the neutral motion, and blend them by body part (stage 4)."""
    clear_pose(work.turned, me.effectors)
    for seat in range(SEATS + 1):
        frame, fraction = shelf.keys.shape[0] - 1, 0.0
        if seat < SEATS:
            if me.status[seat] < RUNNING:
                continue
            frame, fraction, _ = key_at(shelf.entries[me.action[seat]], me.clip_time[seat])
        for side in range(2):
            for point in range(2):
                for axis in range(3):
                    place = me.seat_points[seat, side, point, axis]
                    me.old_points[seat, side, point, axis] = place
        add_pose(
            shelf.keys,
            frame,
            fraction,
            rig.parts,
            me.weights[seat],
            work.turned,
            me.effectors,
        )
        read_points(shelf, frame, fraction, me.seat_points[seat])
    finish_pose(work.turned)


@inner_kernel
def locate_feet(shelf: Shelf, me: Character, work: Workspace) -> None:
    """Find heel and toe of the blended feet, and which of them carries (stage 5).

    Written: `me.points` in leg lengths, `me.heights` over each point's own height at rest,
    `me.toe_shares`.
    """
    for side in range(2):
        q = work.turned[shelf.joints + side]
        for point in range(2):
            offset = shelf.points[side, point]
            x, y, z = quaternions.rotate(q[0], q[1], q[2], q[3], offset[0], offset[1], offset[2])
            me.points[side, point, 0] = x + me.effectors[1 + 3 * side]
            me.points[side, point, 1] = y + me.effectors[2 + 3 * side]
            me.points[side, point, 2] = z + me.effectors[3 + 3 * side]
            resting = 0.0
            for seat in range(SEATS + 1):
                weight = me.weights[seat, LEGS]
                if weight > 0.0:
                    action = me.action[seat] if seat < SEATS else shelf.entries.shape[0]
                    resting += weight * shelf.resting_heights[action, side, point]
            me.heights[side, point] = me.points[side, point, 1] - resting
        me.toe_shares[side] = toe_share(me.heights[side, 0], me.heights[side, 1])


@inner_kernel
def move_root(shelf: Shelf, rig: Rig, me: Character) -> None:
    """Move the root as the motions do, corrected so that the carrying feet stay (stage 6)."""
    step_x, step_z, turn = 0.0, 0.0, 0.0
    for side in range(2):
        me.slides[side, 0] = me.slides[side, 1] = 0.0
    for seat in range(SEATS + 1):
        weight = me.weights[seat, LEGS]
        step = (0.0, 0.0, 0.0)
        if seat < SEATS:
            if me.status[seat] < RUNNING:
                continue
            now = me.clip_time[seat]
            step = travel(shelf, me.action[seat], me.posed_time[seat], now)
            me.posed_time[seat] = now
        step_x += weight * step[0]
        step_z += weight * step[1]
        turn += weight * step[2]
        for side in range(2):
            x, z = foot_slide(
                step,
                me.old_points[seat],
                me.seat_points[seat],
                side,
                me.toe_shares[side],
            )
            me.slides[side, 0] += weight * x
            me.slides[side, 1] += weight * z
    if me.synchronized and not me.fresh:
        step_x, step_z = _corrected(me, step_x, step_z, turn)
    root = me.root
    root[0], root[1], root[2] = transforms.compose(
        root[0], root[1], root[2], step_x * rig.leg_length, step_z * rig.leg_length, turn
    )
    for side in range(2):
        for point in range(2):
            for axis in range(3):
                me.blended_points[side, point, axis] = me.points[side, point, axis]


@inner_kernel
def _corrected(me: Character, step_x: float, step_z: float, turn: float) -> tuple[float, float]:
    """Return the displacement that suits the carrying feet; as it was where none carries."""
    x, z, feet = 0.0, 0.0, 0
    for side in range(2):
        if carries(me.support, side):
            foot_x, foot_z = correct_displacement(
                turn,
                (me.slides[side, 0], me.slides[side, 1]),
                me.blended_points,
                me.points,
                side,
                me.toe_shares[side],
            )
            x += foot_x
            z += foot_z
            feet += 1
    if feet == 0:
        return step_x, step_z
    return x / feet, z / feet
