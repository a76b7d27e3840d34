"""Hands that reach for a point and take what is there: after the blend, beside the schedule.

A reach has no leg weight, so it is no part of the schedule (S-15): it begins when it is told to.
Its weight fades; the point it goes for may move, and is followed without a leap. Where the hand
gets to the point it may close on it: from then on the object goes with the hand, and the arm goes
back to its own motion with it.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from footfall.adaptation.footprints import spring
from footfall.arrays import Positions, Rotations
from footfall.compilation import kernel
from footfall.engine.hand_record import FREE, HOLDS, REACHES, Hand
from footfall.engine.record import Character
from footfall.geometry import quaternions
from footfall.skeleton.anatomy import Anatomy
from footfall.skeleton.arm_ik import BEND, ArmRig, reach_end
from footfall.skeleton.skeleton import Skeleton
from footfall.skeleton.two_bone_ik import Vector

__all__ = ["CLOSE", "Palms", "move_hands", "palms_of"]

FOLLOWING = 12.0
"""Of the spring with which a hand follows a point that moves or is exchanged [1/s]."""

CLOSE = 0.01
"""A hand closes on a point from this distance, and is short of one that is farther [m]."""

SOFT = (0.93, 0.995)
"""Extension of the arm beyond which a target is approached ever slower, and the greatest one."""


class Palms(NamedTuple):
    """The arms of a body, and their palms."""

    arms: ArmRig
    """The arms."""

    offsets: Positions
    """Each palm in the frame of its wrist [m], shape (2, 3)."""


def palms_of(skeleton: Skeleton, anatomy: Anatomy, arms: ArmRig) -> Palms:
    """Return where the palms are: between the wrist and where its fingers begin."""
    offsets = np.zeros((2, 3))
    for side, arm in enumerate(anatomy.arms):
        if arm is None:
            continue
        fingers = np.flatnonzero(skeleton.parents == arm.wrist)
        if len(fingers):
            offsets[side] = 0.5 * skeleton.rest_offsets[fingers].mean(axis=0)
    return Palms(arms, offsets)


@kernel
def move_hands(
    palms: Palms,
    characters: npt.NDArray[Any],
    hands: npt.NDArray[Any],
    world_rotations: Rotations,
    world_positions: Positions,
    dt: float,
) -> None:
    """Let every hand go on with its task, and turn its arm.

    Args:
        palms: The arms of the body.
        characters: Records of `Character`, shape (rows,).
        hands: Records of `Hand`, shape (rows, 2).
        world_rotations: As blended, shape (rows, joints, 4); the arms are rewritten.
        world_positions: Likewise [m], shape (rows, joints, 3).
        dt: Time step [s], >= 0.
    """
    for row in range(characters.shape[0]):
        me: Character = characters[row]
        for side in range(2):
            hand: Hand = hands[row, side]
            if palms.arms.limbs[side, 2] < 0 or (hand.task == FREE and hand.progress <= 0.0):
                continue
            _move_hand(
                palms, side, me.root[2], hand, world_rotations[row], world_positions[row], dt
            )


@kernel
def _move_hand(
    palms: Palms,
    side: int,
    heading: float,
    hand: Hand,
    rotations: Rotations,
    positions: Positions,
    dt: float,
) -> None:
    wrist = palms.arms.limbs[side, 2]
    change = dt / hand.fade
    goes = hand.task == REACHES
    hand.progress = min(hand.progress + change, 1.0) if goes else max(hand.progress - change, 0.0)
    for axis in range(3):
        hand.aim[axis], hand.aim_velocity[axis] = spring(
            hand.aim[axis], hand.aim_velocity[axis], hand.point[axis], FOLLOWING, dt
        )
    ox, oy, oz = _palm_offset(palms, side, rotations)
    weight = hand.progress * hand.progress * (3.0 - 2.0 * hand.progress)
    w, x, y, z = quaternions.from_yaw(heading)
    bend = quaternions.rotate(w, x, y, z, BEND[0], BEND[1], BEND[2])
    target = (hand.aim[0] - ox, hand.aim[1] - oy, hand.aim[2] - oz)
    goal = (
        positions[wrist, 0] + weight * (target[0] - positions[wrist, 0]),
        positions[wrist, 1] + weight * (target[1] - positions[wrist, 1]),
        positions[wrist, 2] + weight * (target[2] - positions[wrist, 2]),
    )
    near = _softened(palms, side, target, positions)
    reach_end(palms.arms, side, near, weight, bend, rotations, positions)
    hand.palm[0] = positions[wrist, 0] + ox
    hand.palm[1] = positions[wrist, 1] + oy
    hand.palm[2] = positions[wrist, 2] + oz
    hand.missing = math.sqrt(
        (positions[wrist, 0] - goal[0]) ** 2
        + (positions[wrist, 1] - goal[1]) ** 2
        + (positions[wrist, 2] - goal[2]) ** 2
    )
    _take(hand, rotations, wrist)


@kernel
def _softened(palms: Palms, side: int, target: Vector, positions: Positions) -> Vector:
    """Return a target brought near enough for the elbow not to snap straight.

    An elbow stands off the line by the root of what is left to full length: the last centimeters
    throw it. So they are gone ever slower, and the very last ones are not gone.
    """
    shoulder, elbow, wrist = (
        palms.arms.limbs[side, 0],
        palms.arms.limbs[side, 1],
        palms.arms.limbs[side, 2],
    )
    length = _distance(positions, shoulder, elbow) + _distance(positions, elbow, wrist)
    x = target[0] - positions[shoulder, 0]
    y = target[1] - positions[shoulder, 1]
    z = target[2] - positions[shoulder, 2]
    away = math.sqrt(x * x + y * y + z * z)
    start, room = SOFT[0] * length, (SOFT[1] - SOFT[0]) * length
    if away <= start:
        return target
    share = (start + room * (1.0 - math.exp(-(away - start) / room))) / away
    return (
        positions[shoulder, 0] + share * x,
        positions[shoulder, 1] + share * y,
        positions[shoulder, 2] + share * z,
    )


@kernel
def _distance(positions: Positions, one: int, other: int) -> float:
    x = positions[one, 0] - positions[other, 0]
    y = positions[one, 1] - positions[other, 1]
    z = positions[one, 2] - positions[other, 2]
    return math.sqrt(x * x + y * y + z * z)


@kernel
def _palm_offset(palms: Palms, side: int, rotations: Rotations) -> tuple[float, float, float]:
    q, offset = rotations[palms.arms.limbs[side, 2]], palms.offsets[side]
    return quaternions.rotate(q[0], q[1], q[2], q[3], offset[0], offset[1], offset[2])


@kernel
def _take(hand: Hand, rotations: Rotations, wrist: int) -> None:
    """Close the hand on its point if it is there, and keep what it holds in it."""
    q = rotations[wrist]
    if hand.task == REACHES:
        away = 0.0
        for axis in range(3):
            hand.held[axis] = hand.point[axis]
            away += (hand.point[axis] - hand.palm[axis]) ** 2
        if hand.closes and hand.progress >= 1.0 and math.sqrt(away) < CLOSE:
            hand.task = HOLDS
            hand.grip[0], hand.grip[1], hand.grip[2] = quaternions.conjugate_rotate(
                q[0],
                q[1],
                q[2],
                q[3],
                hand.point[0] - hand.palm[0],
                hand.point[1] - hand.palm[1],
                hand.point[2] - hand.palm[2],
            )
    if hand.task == HOLDS:
        gx, gy, gz = quaternions.rotate(
            q[0], q[1], q[2], q[3], hand.grip[0], hand.grip[1], hand.grip[2]
        )
        hand.held[0] = hand.palm[0] + gx
        hand.held[1] = hand.palm[1] + gy
        hand.held[2] = hand.palm[2] + gz
