"""From a body's motion to a robot's, and back."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from footfall.arrays import Floats
from footfall.errors import FileFormatError
from footfall.io.rigid_frames import matrices_of
from footfall.io.scene_clip import clip_of_scene
from footfall.io.scene_nodes import SceneNodes
from footfall.motion import Clip
from footfall.robots.landmarks import landmark_targets, landmarks
from footfall.robots.model import Robot
from footfall.robots.motion_file import RobotMotion
from footfall.robots.solving import solve_frames
from footfall.support import SupportSequence

__all__ = ["clip_of_robot", "perform_on_robot"]

MJ_TO_OURS = np.array(
    [[0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
)
"""Takes MuJoCo's axes (x forward, z up) to ours (z forward, y up)."""


def perform_on_robot(robot: Robot, clip: Clip, supports: SupportSequence) -> RobotMotion:
    """Return a clip as a robot performs it.

    Args:
        robot: The model.
        clip: The motion of any body with legs, arms and a head.
        supports: What the clip stands on.

    Raises:
        SkeletonError: If the clip's body or the robot lacks one of these.
    """
    targets = landmark_targets(robot, clip)
    qpos = solve_frames(robot, landmarks(robot), targets)
    return RobotMotion(
        qpos=qpos,
        qvel=_velocities(robot, qpos, clip.fps),
        supports=supports.supports_at(np.arange(clip.frames) / clip.fps),
        fps=clip.fps,
        joint_names=robot.hinges,
        name=clip.name,
    )


def _velocities(robot: Robot, qpos: Floats, fps: float) -> Floats:
    qvel = np.zeros((len(qpos), robot.model.nv))
    for frame in range(len(qpos) - 1):
        robot.mujoco.mj_differentiatePos(
            robot.model, qvel[frame], 1.0 / fps, qpos[frame], qpos[frame + 1]
        )
    if len(qpos) > 1:
        qvel[-1] = qvel[-2]
    return qvel


def clip_of_robot(motion: RobotMotion, robot: Robot, path: Path) -> Clip:
    """Return the motion of a robot as a clip: its bodies are the joints.

    Args:
        motion: What the robot does.
        robot: Its model.
        path: Where the motion is from, for messages.

    Raises:
        FileFormatError: If the motion is that of another robot.
    """
    if motion.joint_names != robot.hinges:
        raise FileFormatError(
            f"moves {len(motion.joint_names)} hinges ({', '.join(motion.joint_names[:3])}, ...), "
            f"but {robot.name!r} has {len(robot.hinges)} ({', '.join(robot.hinges[:3])}, ...); "
            "name its own model",
            path=path,
        )
    data = robot.mujoco.MjData(robot.model)
    count = robot.skeleton.count
    places, turns = (np.empty((len(motion.qpos), count, width)) for width in (3, 4))
    for frame, qpos in enumerate(motion.qpos):
        data.qpos[:] = qpos
        robot.mujoco.mj_kinematics(robot.model, data)
        places[frame], turns[frame] = data.xpos[1:], data.xquat[1:]
    world = matrices_of(turns, places, np.ones((1, 1, 3)))
    world = MJ_TO_OURS @ world @ MJ_TO_OURS.T
    parents = robot.skeleton.parents
    local = world.copy()
    below = parents >= 0
    local[:, below] = np.linalg.inv(world[:, parents[below]]) @ world[:, below]
    nodes = SceneNodes(robot.skeleton.names, parents, np.ones(count, np.bool_), local, motion.fps)
    clip, _ = clip_of_scene(nodes, path, metres_per_unit=1.0, up="z")
    return clip.evolve(name=motion.name)
