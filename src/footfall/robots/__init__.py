"""Humanoid robots: what their joints are to do so that they move as a body does."""

from footfall.robots.humanoid import humanoid_mjcf
from footfall.robots.model import Robot, load_robot, our_robot
from footfall.robots.motion import clip_of_robot, perform_on_robot
from footfall.robots.motion_file import RobotMotion, load_robot_motion, save_robot_motion

__all__ = [
    "Robot",
    "RobotMotion",
    "clip_of_robot",
    "humanoid_mjcf",
    "load_robot",
    "load_robot_motion",
    "our_robot",
    "perform_on_robot",
    "save_robot_motion",
]
