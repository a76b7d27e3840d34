"""From clip times and weights to a blended pose and the root's way: stages 4 to 6."""

from __future__ import annotations

import math
from typing import cast

import numpy as np

from footfall.adaptation.footprints import ROLL_TIME, SPEED_TIME, approach, toe_lead
from footfall.arrays import SmallFloats
from footfall.blending.poses import Layers, blend_layers
from footfall.blending.root import correct_displacement, foot_slide
from footfall.compilation import small_kernel
from footfall.engine.feet import carries
from footfall.engine.foot_turns import steered_turn
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf, key_at, read_points, travel
from footfall.engine.state import RUNNING, Workspace
from footfall.geometry import transforms
from footfall.skeleton import BodyPart
from footfall.skeleton.normalized import EFFECTORS
from footfall.skeleton.rig import Rig

__all__ = ["blend_poses", "move_root"]

LEGS = int(BodyPart.LEGS)
PARTS = len(BodyPart)

# Typed numbers: a literal would have what it is passed to compiled twice.
NEUTRAL, NONE_YET = cast(int, np.int64(SEATS)), cast(int, np.int64(0))


@small_kernel
def blend_poses(shelf: Shelf, rig: Rig, me: Character, work: Workspace, lane: int) -> None:
    """Sample every action and the neutral motion, and blend them by body part (stage 4).

    Written: the blended pose, and the way of all roots with what their feet slide by themselves.
    """
    me.way[:] = 0.0
    me.slides[:] = 0.0
    count = NONE_YET
    for seat in range(me.occupied):
        if me.status[seat] < RUNNING:
            continue
        frame, fraction, _ = key_at(shelf.entries[me.action[seat]], me.clip_time[seat])
        read_points(shelf, frame, fraction, work.points)
        _add_way(shelf, me, seat, work.points)
        count += _add_layer(me, seat, frame, fraction, work.layers, count)
    count += _add_layer(me, NEUTRAL, shelf.keys.shape[0] - 1, 0.0, work.layers, count)
    blended = work.blended[lane]
    blend_layers(shelf.keys, work.layers, count, rig.part_masks, blended)
    for i in range(EFFECTORS):
        me.effectors[i] = blended[4 * rig.part_masks.shape[1] + i]


@small_kernel
def _add_layer(
    me: Character, seat: int, frame: int, fraction: float, layers: Layers, count: int
) -> int:
    """List one motion among those that are mixed; return how many that adds: 0 or 1."""
    heaviest = 0.0
    for part in range(PARTS):
        weight = me.weights[seat, part]
        layers.weights[count, part] = weight
        heaviest = max(heaviest, weight)
    if heaviest <= 0.0:
        return 0
    layers.frames[count] = frame
    layers.after[count] = frame + 1 if fraction > 0.0 else frame
    layers.fractions[count] = fraction
    return 1


@small_kernel
def _add_way(shelf: Shelf, me: Character, seat: int, points: SmallFloats) -> None:
    """Add one motion's way, and how far its feet slide on it, to those of the others.

    The neutral motion has neither.
    """
    weight = me.weights[seat, LEGS]
    now = me.clip_time[seat]
    step = travel(shelf.roots, shelf.entries[me.action[seat]], me.posed_time[seat], now)
    me.posed_time[seat] = now
    for i in range(3):
        me.way[i] += weight * step[i]
    before = me.seat_points[seat]
    for side in range(2):
        for point in range(2):
            x, z = foot_slide(step, before, points, side, point)
            me.slides[side, point, 0] += weight * x
            me.slides[side, point, 1] += weight * z
    for side in range(2):
        for point in range(2):
            for axis in range(3):
                before[side, point, axis] = points[side, point, axis]


@small_kernel
def move_root(rig: Rig, me: Character, dt: float) -> None:
    """Move the root as the motions do, corrected so that the carrying feet stay (stage 6)."""
    step_x, step_z, turn = me.way[0], me.way[1], steered_turn(me, dt)
    _choose_points(rig, me, dt)
    if me.synchronized and not me.fresh:
        step_x, step_z = _corrected(me, step_x, step_z, turn)
    root = me.root
    root[0], root[1], root[2] = transforms.compose(
        root[0], root[1], root[2], step_x * rig.leg_length, step_z * rig.leg_length, turn
    )
    me.facing[0], me.facing[1] = math.cos(root[2]), math.sin(root[2])
    for side in range(2):
        for point in range(2):
            for axis in range(3):
                me.blended_points[side, point, axis] = me.points[side, point, axis]


@small_kernel
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


@small_kernel
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
