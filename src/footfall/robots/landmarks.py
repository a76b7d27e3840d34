"""Where the landmarks of a robot should be, so that it moves as a body does.

Directions are taken from the body, lengths from the robot: each limb's end is its beginning plus
the body's direction times the robot's length. So the pose carries over whatever the proportions,
and what a robot's joints cannot reach is all that is left to the solver.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.errors import SkeletonError
from footfall.geometry import rotate
from footfall.motion import Clip
from footfall.robots.model import Robot
from footfall.skeleton import Anatomy, Leg, find_anatomy, leg_length

__all__ = ["Landmark", "landmark_targets", "landmarks"]

FORWARD = 0.15
"""How far before each ankle the robot's foot is led by a second point [m]."""


class Landmark(NamedTuple):
    """A point of the robot that is led."""

    body: int
    """MuJoCo's number of its body."""

    offset: tuple[float, float, float]
    """Where it is in the body's frame, in MuJoCo's axes [m]."""


def landmarks(robot: Robot) -> tuple[Landmark, ...]:
    """Return the points that are led: hips, knees, ankles, feet; shoulders, elbows, wrists, head.

    Raises:
        SkeletonError: If the robot has no arms or no head.
    """
    joints = [joint for leg in robot.anatomy.legs for joint in (leg.hip, leg.knee, leg.ankle)]
    joints += [joint for arm in _arms(robot.anatomy) for joint in arm]
    points = [Landmark(joint + 1, (0.0, 0.0, 0.0)) for joint in (*joints, _head(robot.anatomy))]
    points += [Landmark(leg.ankle + 1, (FORWARD, 0.0, 0.0)) for leg in robot.anatomy.legs]
    return tuple(points)


def landmark_targets(robot: Robot, clip: Clip) -> Positions:
    """Return where the landmarks should be, in MuJoCo's axes [m], shape (frames, landmarks, 3).

    The ground is at height zero: the ankles come down as low as the robot's soles allow.

    Raises:
        SkeletonError: If the clip's body or the robot lacks legs, arms or head.
    """
    anatomy = find_anatomy(clip.skeleton)
    _, positions = clip.world_poses()
    scale = leg_length(robot.skeleton, robot.anatomy.left) / leg_length(clip.skeleton, anatomy.left)
    places = _rest_places(robot)
    hips, shoulders = _pairs(anatomy)
    robot_hips, robot_shoulders = _pairs(robot.anatomy)
    middle = positions[:, hips].mean(axis=1)
    across = _unit(positions[:, hips[0]] - positions[:, hips[1]])
    up = _unit(positions[:, shoulders].mean(axis=1) - middle)
    trunk = np.linalg.norm(places[robot_shoulders].mean(axis=0) - places[robot_hips].mean(axis=0))
    pelvis = scale * middle
    chest = pelvis + trunk * up
    over = _unit(positions[:, shoulders[0]] - positions[:, shoulders[1]])
    columns: list[Positions] = []
    toes: list[Positions] = []
    for side, (leg, robot_leg) in enumerate(zip(anatomy.legs, robot.anatomy.legs, strict=True)):
        start = pelvis + (0.5 - side) * _apart(places, robot_hips) * across
        chain = (leg.hip, leg.knee, leg.ankle)
        robot_chain = (robot_leg.hip, robot_leg.knee, robot_leg.ankle)
        columns += _led(start, positions, chain, places, robot_chain)
        toes.append(columns[-1] + FORWARD * _foot_directions(positions, leg, across))
    for side, (arm, robot_arm) in enumerate(zip(_arms(anatomy), _arms(robot.anatomy), strict=True)):
        start = chest + (0.5 - side) * _apart(places, robot_shoulders) * over
        columns += _led(start, positions, arm, places, robot_arm)
    skull = _unit(positions[:, _head(anatomy)] - positions[:, shoulders].mean(axis=1))
    reach = np.linalg.norm(places[_head(robot.anatomy)] - places[robot_shoulders].mean(axis=0))
    targets = np.stack([*columns, chest + reach * skull, *toes], axis=1)
    ankles = targets[:, [2, 5], 1].min(axis=1)
    targets[..., 1] += robot.sole_height - np.percentile(ankles, 5.0)
    return targets[..., [2, 0, 1]]


def _led(
    start: Positions,
    positions: Positions,
    chain: tuple[int, ...],
    places: Positions,
    robot_chain: tuple[int, ...],
) -> list[Positions]:
    """Return a limb's points: the body's directions, the robot's lengths."""
    points = [start]
    for index in range(1, len(chain)):
        length = np.linalg.norm(places[robot_chain[index]] - places[robot_chain[index - 1]])
        direction = _unit(positions[:, chain[index]] - positions[:, chain[index - 1]])
        points.append(points[-1] + length * direction)
    return points


def _foot_directions(positions: Positions, leg: Leg, across: Positions) -> Positions:
    """Return where a foot points: level where the body's foot stands flat, shape (frames, 3)."""
    foot = positions[:, leg.toe.joint] - positions[:, leg.ankle]
    lengths = np.linalg.norm(foot, axis=-1, keepdims=True)
    if lengths.max() < 1e-6:
        # Nothing is known of the foot: it points where the body does.
        return np.cross(across, np.array([0.0, 1.0, 0.0]))
    heights = np.percentile(positions[:, [leg.ankle, leg.toe.joint], 1], 5.0, axis=0)
    drop = np.clip((heights[0] - heights[1]) / np.median(lengths), -0.99, 0.99)
    level = foot / lengths
    sideways = _unit(np.cross(level, np.array([0.0, 1.0, 0.0])) + 1e-12)
    half = 0.5 * np.arcsin(drop)
    turn = np.concatenate([np.full((len(foot), 1), np.cos(half)), np.sin(half) * sideways], axis=1)
    return rotate(turn, level)


def _rest_places(robot: Robot) -> Positions:
    places = np.zeros((robot.skeleton.count, 3))
    for joint, parent in enumerate(robot.skeleton.parents.tolist()):
        if parent >= 0:
            places[joint] = places[parent] + robot.skeleton.rest_offsets[joint]
    return places


def _apart(places: Positions, pair: list[int]) -> float:
    return float(np.linalg.norm(places[pair[0]] - places[pair[1]]))


def _pairs(anatomy: Anatomy) -> tuple[list[int], list[int]]:
    return [leg.hip for leg in anatomy.legs], [arm[0] for arm in _arms(anatomy)]


def _arms(anatomy: Anatomy) -> tuple[tuple[int, int, int], ...]:
    left, right = anatomy.arms
    if left is None or right is None:
        raise SkeletonError("no two arms are found, by which the trunk of a robot is led")
    return tuple((arm.shoulder, arm.elbow, arm.wrist) for arm in (left, right))


def _head(anatomy: Anatomy) -> int:
    if anatomy.head is None:
        raise SkeletonError("no head is found; a robot's neck is led by it")
    return anatomy.head


def _unit(vectors: Floats) -> Floats:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-12)
