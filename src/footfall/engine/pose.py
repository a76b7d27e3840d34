"""From clip times and weights to a blended pose and the root's way: stages 4 to 6."""

from __future__ import annotations

import math

from footfall.adaptation.footprints import ROLL_TIME, SPEED_TIME, approach, toe_lead
from footfall.blending.poses import add_pose, clear_pose, finish_pose
from footfall.blending.root import correct_displacement, foot_slide
from footfall.compilation import inner_kernel
from footfall.engine.feet import carries
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf, key_at, read_points, travel
from footfall.engine.state import RUNNING, Workspace
from footfall.geometry import transforms
from footfall.skeleton import BodyPart
from footfall.skeleton.rig import Rig

__all__ = ["blend_poses", "move_root"]

LEGS = int(BodyPart.LEGS)


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
def move_root(shelf: Shelf, rig: Rig, me: Character, dt: float) -> None:
    """Move the root as the motions do, corrected so that the carrying feet stay (stage 6)."""
    step_x, step_z, turn = _travel(shelf, me)
    _choose_points(rig, me, dt)
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
def _travel(shelf: Shelf, me: Character) -> tuple[float, float, float]:
    """Return the weighted mean way of all roots; write how far their feet slide by themselves."""
    step_x, step_z, turn = 0.0, 0.0, 0.0
    me.slides[:] = 0.0
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
            for point in range(2):
                x, z = foot_slide(step, me.old_points[seat], me.seat_points[seat], side, point)
                me.slides[side, point, 0] += weight * x
                me.slides[side, point, 1] += weight * z
    return step_x, step_z, turn


@inner_kernel
def _choose_points(rig: Rig, me: Character, dt: float) -> None:
    """Choose whether heel or toe of each foot carries; what is undecided stays as it was."""
    leg = rig.leg_length
    for side in range(2):
        for point in range(2):
            slide = me.slides[side, point]
            if dt > 0.0:
                speed = leg * math.sqrt(slide[0] * slide[0] + slide[1] * slide[1]) / dt
                smooth = approach(me.slide_speeds[side, point], speed, SPEED_TIME, dt)
                me.slide_speeds[side, point] = smooth
        lead = toe_lead(
            leg * me.heights[side, 0],
            leg * me.heights[side, 1],
            me.slide_speeds[side, 0],
            me.slide_speeds[side, 1],
        )
        if abs(lead) > 1.0 or me.fresh:
            me.on_toes[side] = lead > 0.0
        goal = 1.0 if me.on_toes[side] else 0.0
        share = goal if me.fresh else approach(me.toe_shares[side], goal, ROLL_TIME, dt)
        me.toe_shares[side] = share


@inner_kernel
def _corrected(me: Character, step_x: float, step_z: float, turn: float) -> tuple[float, float]:
    """Return the displacement that suits the carrying feet; as it was where none carries."""
    x, z, feet = 0.0, 0.0, 0
    for side in range(2):
        if carries(me.support, side):
            share = me.toe_shares[side]
            foot_x, foot_z = correct_displacement(
                turn,
                (
                    (1.0 - share) * me.slides[side, 0, 0] + share * me.slides[side, 1, 0],
                    (1.0 - share) * me.slides[side, 0, 1] + share * me.slides[side, 1, 1],
                ),
                me.blended_points,
                me.points,
                side,
                share,
            )
            x += foot_x
            z += foot_z
            feet += 1
    if feet == 0:
        return step_x, step_z
    return x / feet, z / feet
