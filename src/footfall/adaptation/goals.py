"""Goals met after the blend: hands that reach, a head that looks, a seat at some height.

They work on the finished pose in the world, whatever was blended. What is out of reach is
approached softly, and `missed` says by how much.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from footfall.arrays import Floats, Indices, Positions, Rotations, Seconds, Weights
from footfall.compilation import kernel
from footfall.geometry import conjugate, quaternions, rotate
from footfall.skeleton import Anatomy, Skeleton
from footfall.skeleton.arm_ik import ArmRig, arm_rig_of, reach_end
from footfall.skeleton.canonical_pose import canonical_rotations
from footfall.skeleton.landmarks import find_landmarks
from footfall.skeleton.leg_search import descendants

__all__ = ["GAZE", "GOALS", "HANDS", "SEAT", "GoalBody", "GoalMemory", "goal_body_of", "meet_goals"]

HANDS, GAZE, SEAT = (0, 1), 2, 3
"""Which row of a memory is whose goal: left and right hand, gaze, seat."""

GOALS = 4
"""How many there are."""

WIDEST_LOOK = math.radians(75.0)
"""How far the head turns from the chest at most."""

NECK_SHARE = 0.4
"""How much of that the neck does."""

CATCH_UP = 10.0
"""How fast what a goal jumped by is made up for [1/s]."""

ARM_BEND = (0.0, -1.0, -0.5)
"""Where the elbow of a straight arm goes, of a body that faces +z."""

LEG_BEND = (0.0, 0.0, 1.0)
"""Likewise the knee of a straight leg."""


class GoalBody(NamedTuple):
    """What of a body meets goals."""

    arms: ArmRig
    """Its arms."""

    legs: ArmRig
    """Its legs, likewise."""

    chest: int
    """The joint that the head turns against."""

    neck: int
    """The joint of the neck, or -1."""

    head: int
    """The joint of the head, or -1."""

    carried: Indices
    """2 for what moves with the head, 1 for what else moves with the neck, else 0, (joints,)."""

    forward: Positions
    """Where chest and head face, in their own frames: unit vectors, shape (2, 3)."""


class GoalMemory(NamedTuple):
    """The goals of one character; the rows are `HANDS`, `GAZE`, `SEAT`."""

    targets: Positions
    """Where they are in the world [m], of the seat only the height counts, shape (goals, 3)."""

    lags: Positions
    """What is still to be made up for after a target jumped [m], shape (goals, 3)."""

    wanted: Weights
    """How much of the way is wanted, shape (goals,)."""

    weights: Weights
    """How much that is by now, shape (goals,)."""

    progress: Floats
    """How far the fades are, 0 to 1, shape (goals,)."""

    fades: Seconds
    """How long a whole one takes: above 0 it comes, below 0 it goes, 0 nothing (goals,)."""

    together: Floats
    """How far apart the hands are held where they go to each other [m], below 0: they do not;
    and whether they have to leave other goals for that, shape (2,)."""

    missed: Floats
    """How far each goal was missed in the last pose [m], of the gaze [rad], shape (goals,)."""

    @classmethod
    def empty(cls) -> GoalMemory:
        """Return one without goals."""
        wanted, weights, progress, fades, missed = (np.zeros(GOALS) for _ in range(5))
        together = np.array([-1.0, 0.0])
        places = np.zeros((2, GOALS, 3))
        return cls(*places, wanted, weights, progress, fades, together, missed)


def goal_body_of(skeleton: Skeleton, anatomy: Anatomy) -> GoalBody:
    """Pack what of a body meets goals."""
    marks = find_landmarks(skeleton, anatomy)
    canonical = canonical_rotations(skeleton, marks)
    head = -1 if marks.head is None else marks.head
    neck = marks.neck[0] if marks.neck else -1
    carried = np.zeros(skeleton.count, dtype=np.int64)
    for joint, mark in ((neck, 1), (head, 2)):
        if joint >= 0:
            carried[[joint, *descendants(skeleton, joint)]] = mark
    ahead = np.array([0.0, 0.0, 1.0])
    faces = [marks.chest, max(head, 0)]
    return GoalBody(
        arms=arm_rig_of(skeleton, anatomy),
        legs=_leg_rig(skeleton, anatomy),
        chest=marks.chest,
        neck=neck,
        head=head,
        carried=carried,
        forward=rotate(conjugate(canonical[faces]), ahead),
    )


def _leg_rig(skeleton: Skeleton, anatomy: Anatomy) -> ArmRig:
    """Return the legs as if they were arms: hip, knee and ankle."""
    sides = np.full(skeleton.count, -1, dtype=np.int64)
    segments = np.zeros(skeleton.count, dtype=np.int64)
    limbs = np.array([[leg.hip, leg.knee, leg.ankle] for leg in anatomy.legs], dtype=np.int64)
    for side in range(2):
        own = {int(joint): place + 1 for place, joint in enumerate(limbs[side])}
        for joint in [int(limbs[side, 0]), *sorted(descendants(skeleton, int(limbs[side, 0])))]:
            sides[joint] = side
            segments[joint] = own.get(joint, int(segments[skeleton.parents[joint]]))
    return ArmRig(limbs, sides, segments)


@kernel
def meet_goals(
    body: GoalBody,
    me: GoalMemory,
    heading: float,
    dt: float,
    rotations: Rotations,
    positions: Positions,
) -> None:
    """Change one finished pose so that its goals are met as far as they are faded in.

    Args:
        body: What meets them.
        me: The goals; their fades go on.
        heading: Where the body faces [rad].
        dt: Time since the last pose [s].
        rotations: Joints in the world, shape (joints, 4); rewritten.
        positions: Likewise [m], shape (joints, 3).
    """
    for goal in range(GOALS):
        _go_on(me, goal, dt)
    if me.progress[SEAT] > 0.0:
        _sit(body, me, heading, rotations, positions)
    if me.together[0] >= 0.0:
        _join_hands(body, me, positions)
    sine, cosine = math.sin(heading), math.cos(heading)
    bend = (ARM_BEND[2] * sine, ARM_BEND[1], ARM_BEND[2] * cosine)
    for side in range(2):
        share = _share(me, side)
        me.missed[side] = 0.0
        if share > 0.0:
            target = _target(me, side)
            missed = reach_end(body.arms, side, target, share, bend, rotations, positions)
            me.missed[side] = missed
    me.missed[GAZE] = 0.0
    if me.progress[GAZE] > 0.0 and body.head >= 0:
        _look(body, me, rotations, positions)


@kernel
def _go_on(me: GoalMemory, goal: int, dt: float) -> None:
    """Let one fade go on, and make up for a jump of its target."""
    if me.fades[goal] != 0.0:
        me.progress[goal] = min(max(me.progress[goal] + dt / me.fades[goal], 0.0), 1.0)
    decay = math.exp(-CATCH_UP * dt)
    me.weights[goal] = me.wanted[goal] + (me.weights[goal] - me.wanted[goal]) * decay
    for axis in range(3):
        me.lags[goal, axis] *= decay


@kernel
def _share(me: GoalMemory, goal: int) -> float:
    """Return how much of the way a goal is met: a smoothstep of its fade, times its weight."""
    done = me.progress[goal]
    return me.weights[goal] * done * done * (3.0 - 2.0 * done)


@kernel
def _target(me: GoalMemory, goal: int) -> tuple[float, float, float]:
    place, lag = me.targets[goal], me.lags[goal]
    return place[0] + lag[0], place[1] + lag[1], place[2] + lag[2]


@kernel
def _sit(
    body: GoalBody, me: GoalMemory, heading: float, rotations: Rotations, positions: Positions
) -> None:
    """Raise or lower the body so that its hips are at a height, its feet where they are."""
    left, right = body.legs.limbs[0], body.legs.limbs[1]
    hips = 0.5 * (positions[left[0], 1] + positions[right[0], 1])
    rise = _share(me, SEAT) * (me.targets[SEAT, 1] + me.lags[SEAT, 1] - hips)
    for joint in range(positions.shape[0]):
        positions[joint, 1] += rise
    bend = (LEG_BEND[2] * math.sin(heading), 0.0, LEG_BEND[2] * math.cos(heading))
    missed = 0.0
    for side in range(2):
        ankle = positions[body.legs.limbs[side, 2]]
        target = (ankle[0], ankle[1] - rise, ankle[2])
        missed = max(missed, reach_end(body.legs, side, target, 1.0, bend, rotations, positions))
    me.missed[SEAT] = missed


@kernel
def _join_hands(body: GoalBody, me: GoalMemory, positions: Positions) -> None:
    """Let both hands go to the middle between them, as far apart as they are to be."""
    one, other = body.arms.limbs[0], body.arms.limbs[1]
    if one[0] < 0 or other[0] < 0:
        return
    x = positions[one[0], 0] - positions[other[0], 0]
    y = positions[one[0], 1] - positions[other[0], 1]
    z = positions[one[0], 2] - positions[other[0], 2]
    breadth = max(math.sqrt(x * x + y * y + z * z), 1e-9)
    half = 0.5 * me.together[0] / breadth
    for axis, across in ((0, x), (1, y), (2, z)):
        middle = 0.5 * (positions[one[2], axis] + positions[other[2], axis])
        for side in range(2):
            goal = middle + (half if side == 0 else -half) * across
            if me.together[1] > 0.0:
                me.lags[side, axis] += me.targets[side, axis] - goal
            me.targets[side, axis] = goal
    me.together[1] = 0.0


@kernel
def _look(body: GoalBody, me: GoalMemory, rotations: Rotations, positions: Positions) -> None:
    """Turn neck and head so that the face looks at a target, as far as a neck turns."""
    head, chest = body.head, rotations[body.chest]
    tx, ty, tz = _target(me, GAZE)
    place = positions[head]
    tx, ty, tz = tx - place[0], ty - place[1], tz - place[2]
    if tx * tx + ty * ty + tz * tz < 1e-12:
        return
    ahead = body.forward[0]
    cx, cy, cz = quaternions.rotate(
        chest[0], chest[1], chest[2], chest[3], ahead[0], ahead[1], ahead[2]
    )
    w, x, y, z = quaternions.between(cx, cy, cz, tx, ty, tz)
    angle = 2.0 * math.acos(min(max(w, -1.0), 1.0))
    me.missed[GAZE] = max(0.0, angle - WIDEST_LOOK)
    if angle > WIDEST_LOOK:
        tx, ty, tz = _turned_at_most((cx, cy, cz), (x, y, z))
    face = rotations[head]
    ahead = body.forward[1]
    fx, fy, fz = quaternions.rotate(
        face[0], face[1], face[2], face[3], ahead[0], ahead[1], ahead[2]
    )
    turn = quaternions.between(fx, fy, fz, tx, ty, tz)
    share = _share(me, GAZE)
    if body.neck >= 0:
        _turn_part(body, 1, body.neck, turn, NECK_SHARE * share, rotations, positions)
        face = rotations[head]
        fx, fy, fz = quaternions.rotate(
            face[0], face[1], face[2], face[3], ahead[0], ahead[1], ahead[2]
        )
        turn = quaternions.between(fx, fy, fz, tx, ty, tz)
        share = share * (1.0 - NECK_SHARE) / max(1.0 - NECK_SHARE * share, 1e-9)
    _turn_part(body, 2, head, turn, share, rotations, positions)


@kernel
def _turned_at_most(
    ahead: tuple[float, float, float], axis: tuple[float, float, float]
) -> tuple[float, float, float]:
    """Return a direction turned about an axis as far as a neck turns."""
    length = max(math.sqrt(axis[0] ** 2 + axis[1] ** 2 + axis[2] ** 2), 1e-12)
    sine = math.sin(0.5 * WIDEST_LOOK) / length
    return quaternions.rotate(
        math.cos(0.5 * WIDEST_LOOK),
        sine * axis[0],
        sine * axis[1],
        sine * axis[2],
        ahead[0],
        ahead[1],
        ahead[2],
    )


@kernel
def _turn_part(
    body: GoalBody,
    mark: int,
    pivot: int,
    turn: tuple[float, float, float, float],
    share: float,
    rotations: Rotations,
    positions: Positions,
) -> None:
    """Turn neck or head, and all that it carries, part of the way."""
    w, x, y, z = quaternions.nlerp(
        1.0, 0.0, 0.0, 0.0, turn[0], turn[1], turn[2], turn[3], min(max(share, 0.0), 1.0)
    )
    px, py, pz = positions[pivot, 0], positions[pivot, 1], positions[pivot, 2]
    for joint in range(pivot, positions.shape[0]):
        if body.carried[joint] < mark:
            continue
        place, q = positions[joint], rotations[joint]
        dx, dy, dz = quaternions.rotate(w, x, y, z, place[0] - px, place[1] - py, place[2] - pz)
        place[0], place[1], place[2] = px + dx, py + dy, pz + dz
        q[0], q[1], q[2], q[3] = quaternions.product(w, x, y, z, q[0], q[1], q[2], q[3])
