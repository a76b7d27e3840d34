"""From clip times and weights to a blended pose and the root's way: stages 4 to 6."""

from __future__ import annotations

import math
from typing import cast

import numpy as np

from footfall.adaptation.footprints import ROLL_TIME, SPEED_TIME, toe_lead
from footfall.blending.poses import Layers, blend_layers
from footfall.blending.root import correct_displacement
from footfall.compilation import small_kernel
from footfall.engine.feet import carries
from footfall.engine.foot_turns import steered_turn
from footfall.engine.moment import Moment
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf, key_at, travel_between
from footfall.engine.sole_keys import sole_slides
from footfall.engine.state import RUNNING, Workspace
from footfall.geometry import transforms
from footfall.octet_memory import load, spread, store
from footfall.octets import LANES
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

    Written: the blended pose; the way of all roots, what their feet slide by themselves and how
    high they rest. The neutral motion has neither way nor slide.
    """
    moment: Moment = work.moments[0]
    moment.way[:] = 0.0
    slides = spread(0.0)
    resting = me.weights[NEUTRAL, LEGS] * load(
        shelf.resting_heights, LANES * shelf.entries.shape[0]
    )
    count = NONE_YET
    for seat in range(me.occupied):
        if me.status[seat] < RUNNING:
            continue
        action = me.action[seat]
        entry = shelf.entries[action]
        before = key_at(entry, me.posed_time[seat])
        now = key_at(entry, me.clip_time[seat])
        me.posed_time[seat] = me.clip_time[seat]
        count += _add_layer(me, seat, now[0], now[1], work.layers, count)
        weight = me.weights[seat, LEGS]
        if weight > 0.0:
            step = travel_between(shelf.roots, entry, before, now)
            for i in range(3):
                moment.way[i] += weight * step[i]
            slides = slides + weight * sole_slides(shelf.sole_keys, before, now, step[2])
            resting = resting + weight * load(shelf.resting_heights, LANES * action)
    store(moment.slides, 0, slides)
    store(moment.resting, 0, resting)
    count += _add_layer(me, NEUTRAL, shelf.keys.shape[0] - 1, 0.0, work.layers, count)
    blended = work.blended[lane]
    blend_layers(shelf.keys, work.layers, count, rig.part_masks, blended)
    for i in range(EFFECTORS):
        moment.effectors[i] = blended[4 * rig.part_masks.shape[1] + i]


@small_kernel
def _add_layer(
    me: Character, seat: int, frame: int, fraction: float, layers: Layers, count: int
) -> int:
    """List one motion among those that are mixed; return how many that adds: 0 or 1."""
    heaviest = lightest = me.weights[seat, LEGS]
    for part in range(PARTS):
        weight = me.weights[seat, part]
        layers.weights[count, part] = weight
        heaviest, lightest = max(heaviest, weight), min(lightest, weight)
    layers.whole[count] = heaviest == lightest
    if heaviest <= 0.0:
        return 0
    layers.frames[count] = frame
    layers.after[count] = frame + 1 if fraction > 0.0 else frame
    layers.fractions[count] = fraction
    return 1


@small_kernel
def move_root(rig: Rig, me: Character, moment: Moment, dt: float) -> None:
    """Move the root as the motions do, corrected so that the carrying feet stay (stage 6)."""
    step_x, step_z, turn = moment.way[0], moment.way[1], steered_turn(me, moment, dt)
    if dt != moment.step:
        moment.step = dt
        moment.kept_speed, moment.kept_roll = math.exp(-dt / SPEED_TIME), math.exp(-dt / ROLL_TIME)
    _choose_points(rig, me, moment, dt)
    if me.synchronized and not me.fresh:
        step_x, step_z = _corrected(me, moment, step_x, step_z, turn)
    root, leg = me.root, rig.leg_length
    cosine, sine = math.cos(root[2]), math.sin(root[2])
    x, z = transforms.turn(cosine, sine, leg * step_x, leg * step_z)
    root[0], root[1], root[2] = root[0] + x, root[1] + z, root[2] + turn
    turned_cosine, turned_sine = transforms.cosine_and_sine(turn)
    me.facing[0] = cosine * turned_cosine - sine * turned_sine
    me.facing[1] = sine * turned_cosine + cosine * turned_sine
    for side in range(2):
        for point in range(2):
            me.blended_points[side, point, 0] = moment.points[side, point, 0]
            me.blended_points[side, point, 1] = moment.points[side, point, 2]


@small_kernel
def _slide(moment: Moment, side: int, point: int) -> tuple[float, float]:
    """Return how far the motions themselves let a foot point slide, in leg lengths: x and z."""
    place = 2 * side + point
    x = float(moment.slides[place]) + moment.way[0]
    return x, float(moment.slides[place + 4]) + moment.way[1]


@small_kernel
def _choose_points(rig: Rig, me: Character, moment: Moment, dt: float) -> None:
    """Choose whether heel or toe of each foot carries; what is undecided stays as it was."""
    leg = rig.leg_length
    for side in range(2):
        for point in range(2):
            if dt > 0.0:
                x, z = _slide(moment, side, point)
                speed = leg * math.sqrt(x * x + z * z) / dt
                away = me.slide_speeds[side, point] - speed
                me.slide_speeds[side, point] = speed + away * moment.kept_speed
        lead = toe_lead(
            leg * moment.heights[side, 0],
            leg * moment.heights[side, 1],
            me.slide_speeds[side, 0],
            me.slide_speeds[side, 1],
        )
        if abs(lead) > 1.0 or me.fresh:
            me.on_toes[side] = lead > 0.0
        goal = 1.0 if me.on_toes[side] else 0.0
        kept = 0.0 if me.fresh else moment.kept_roll
        me.toe_shares[side] = goal + (me.toe_shares[side] - goal) * kept


@small_kernel
def _corrected(
    me: Character, moment: Moment, step_x: float, step_z: float, turn: float
) -> tuple[float, float]:
    """Return the displacement that suits the carrying feet; as it was where none carries."""
    x, z, feet = 0.0, 0.0, 0
    for side in range(2):
        if carries(me.support, side):
            share = me.toe_shares[side]
            heel, toe = _slide(moment, side, 0), _slide(moment, side, 1)
            foot_x, foot_z = correct_displacement(
                turn,
                (
                    (1.0 - share) * heel[0] + share * toe[0],
                    (1.0 - share) * heel[1] + share * toe[1],
                ),
                me.blended_points,
                moment.points,
                side,
                share,
            )
            x += foot_x
            z += foot_z
            feet += 1
    if feet == 0:
        return step_x, step_z
    return x / feet, z / feet
