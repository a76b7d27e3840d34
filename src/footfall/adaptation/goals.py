"""Goals met after the blend: hands that reach, a head that looks, a seat at some height.

They work on the finished pose in the world, whatever was blended. What is out of reach is
approached softly, and `missed` says by how much.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.adaptation.gaze import look_at
from footfall.adaptation.goal_body import GoalBody
from footfall.arrays import Floats, Positions, Rotations, Seconds, Weights
from footfall.compilation import kernel, records
from footfall.skeleton.arm_ik import reach_end

__all__ = ["GAZE", "GOALS", "HANDS", "SEAT", "GoalMemory", "goal_type", "meet_goals", "new_goals"]

HANDS, GAZE, SEAT = (0, 1), 2, 3
"""Which row of a memory is whose goal: left and right hand, gaze, seat."""

GOALS = 4
"""How many there are."""

CATCH_UP = 10.0
"""How fast what a goal jumped by is made up for [1/s]."""

ARM_BEND = (0.0, -1.0, -0.5)
"""Where the elbow of a straight arm goes, of a body that faces +z."""

LEG_BEND = (0.0, 0.0, 1.0)
"""Likewise the knee of a straight leg."""


class GoalMemory:
    """The goals of one character, a record of `goal_type`; rows are `HANDS`, `GAZE`, `SEAT`."""

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


goal_type = np.dtype(
    [
        *((name, np.float64, (GOALS, 3)) for name in ("targets", "lags")),
        *(
            (name, np.float64, (GOALS,))
            for name in ("wanted", "weights", "progress", "fades", "missed")
        ),
        ("together", np.float64, (2,)),
    ],
    align=True,
)
"""The memory layout of `GoalMemory`."""


def new_goals(rows: int) -> npt.NDArray[Any]:
    """Return the memories of so many characters without goals, shape (rows,)."""
    goals = records(np.zeros(rows, dtype=goal_type))
    goals["together"][:, 0] = -1.0
    return goals


@kernel
def meet_goals(
    body: GoalBody,
    goals: npt.NDArray[Any],
    headings: Floats,
    dt: float,
    rotations: Rotations,
    positions: Positions,
) -> None:
    """Change finished poses so that their goals are met as far as they are faded in.

    Args:
        body: What meets them.
        goals: Records of `GoalMemory`, shape (rows,); their fades go on.
        headings: Where the bodies face [rad], shape (rows,).
        dt: Time since the last pose [s].
        rotations: Joints in the world, shape (rows, joints, 4); rewritten.
        positions: Likewise [m], shape (rows, joints, 3).
    """
    for row in range(goals.shape[0]):
        me: GoalMemory = goals[row]
        if _has_any(me):
            _meet(body, me, headings[row], dt, rotations[row], positions[row])


@kernel
def _has_any(me: GoalMemory) -> bool:
    """Return whether a goal is on its way, or there."""
    found = False
    for goal in range(GOALS):
        found = found or me.progress[goal] != 0.0 or me.fades[goal] > 0.0
    return found


@kernel
def _meet(
    body: GoalBody,
    me: GoalMemory,
    heading: float,
    dt: float,
    rotations: Rotations,
    positions: Positions,
) -> None:
    """Change one pose, shape (joints, 4) and (joints, 3)."""
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
        target, share = _target(me, GAZE), _share(me, GAZE)
        me.missed[GAZE] = look_at(body, target, share, rotations, positions)


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
