"""The joint angles that bring a robot's landmarks to their targets, frame by frame."""

from __future__ import annotations

from typing import Any

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.robots.landmarks import Landmark
from footfall.robots.model import Robot

__all__ = ["solve_frames"]

ITERATIONS, FIRST_ITERATIONS = 12, 150
"""Steps a frame, begun from the frame before; and for the first one, begun from rest."""

ENOUGH = 1e-5
"""A step that turns and moves by less than this ends the search [rad, m]."""

DAMPING = 1e-3
"""Keeps steps short where a joint hardly moves a landmark (Levenberg-Marquardt)."""

REST = 2e-3
"""Weight with which hinges are drawn to zero, so that what no landmark decides stays at rest."""

KEEP = 3e-3
"""Weight with which they are drawn to where they were in the frame before: a straight limb does not
say how it is turned about itself."""


def solve_frames(robot: Robot, points: tuple[Landmark, ...], targets: Positions) -> Floats:
    """Return `qpos` of every frame, shape (frames, nq); hinges stay within their ranges.

    Args:
        robot: The model.
        points: Its landmarks.
        targets: Where they should be, in MuJoCo's axes [m], shape (frames, landmarks, 3).
    """
    data = robot.mujoco.MjData(robot.model)
    data.qpos[:7] = _start(robot, points, targets[0])
    found = np.empty((len(targets), robot.model.nq))
    for frame, wanted in enumerate(targets):
        before = data.qpos[7:].copy() if frame else None
        for _ in range(ITERATIONS if frame else FIRST_ITERATIONS):
            step = _step(robot, data, points, wanted, before)
            robot.mujoco.mj_integratePos(robot.model, data.qpos, step, 1.0)
            _within_ranges(robot, data)
            if np.abs(step).max() < ENOUGH:
                break
        found[frame] = data.qpos
    return _continuous(found)


def _start(robot: Robot, points: tuple[Landmark, ...], wanted: Positions) -> Floats:
    """Return the root as the targets' trunk stands, so that the search begins near its end."""
    hips = wanted[[0, 3]]
    left = hips[0] - hips[1]
    up = wanted[[6, 9]].mean(axis=0) - hips.mean(axis=0)
    up /= np.linalg.norm(up)
    left -= up * (left @ up)
    left /= max(float(np.linalg.norm(left)), 1e-9)
    matrix = np.stack([np.cross(left, up), left, up], axis=1)
    turn = np.empty(4)
    robot.mujoco.mju_mat2Quat(turn, matrix.reshape(-1))
    assert len(points) == len(wanted)
    return np.concatenate([hips.mean(axis=0), turn])


def _step(
    robot: Robot,
    data: Any,
    points: tuple[Landmark, ...],
    wanted: Positions,
    before: Floats | None,
) -> Floats:
    """Return the damped Gauss-Newton step, shape (nv,)."""
    mujoco, model = robot.mujoco, robot.model
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    rows = np.empty((3 * len(points), model.nv))
    misses = np.empty(3 * len(points))
    for index, point in enumerate(points):
        place = data.xpos[point.body] + data.xmat[point.body].reshape(3, 3) @ point.offset
        mujoco.mj_jac(model, data, rows[3 * index : 3 * index + 3], None, place, point.body)
        misses[3 * index : 3 * index + 3] = wanted[index] - place
    square = rows.T @ rows
    pull = rows.T @ misses
    hinges = np.arange(6, int(model.nv))
    square[np.diag_indices(model.nv)] += DAMPING
    square[hinges, hinges] += REST
    pull[6:] -= REST * data.qpos[7:]
    if before is not None:
        square[hinges, hinges] += KEEP
        pull[6:] += KEEP * (before - data.qpos[7:])
    return np.asarray(np.linalg.solve(square, pull), dtype=np.float64)


def _within_ranges(robot: Robot, data: Any) -> None:
    limited = robot.model.jnt_limited[1:].astype(np.bool_)
    low, high = robot.model.jnt_range[1:].T
    data.qpos[7:] = np.where(limited, np.clip(data.qpos[7:], low, high), data.qpos[7:])


def _continuous(found: Floats) -> Floats:
    """Return the same with no sign of the root's quaternion changing between frames."""
    flips = np.einsum("tq,tq->t", found[1:, 3:7], found[:-1, 3:7]) < 0.0
    found[1:, 3:7] *= np.cumprod(np.where(flips, -1.0, 1.0))[:, np.newaxis]
    return found
