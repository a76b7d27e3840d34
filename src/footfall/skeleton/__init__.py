"""A body at rest and in a pose."""

from footfall.skeleton.anatomy import (
    Anatomy,
    Arm,
    BodyPart,
    FootPoint,
    Leg,
    arm_length,
    leg_length,
    resized,
)
from footfall.skeleton.anatomy_search import find_anatomy
from footfall.skeleton.heading import pelvis_headings
from footfall.skeleton.kinematics import forward_kinematics, pose_forward, world_poses
from footfall.skeleton.skeleton import Skeleton

__all__ = [
    "Anatomy",
    "Arm",
    "BodyPart",
    "FootPoint",
    "Leg",
    "Skeleton",
    "arm_length",
    "find_anatomy",
    "forward_kinematics",
    "leg_length",
    "pelvis_headings",
    "pose_forward",
    "resized",
    "world_poses",
]
