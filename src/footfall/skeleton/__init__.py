"""A body at rest and in a pose."""

from footfall.skeleton.anatomy import Anatomy, BodyPart, FootPoint, Leg
from footfall.skeleton.kinematics import forward_kinematics, pose_forward, world_poses
from footfall.skeleton.skeleton import Skeleton

__all__ = [
    "Anatomy",
    "BodyPart",
    "FootPoint",
    "Leg",
    "Skeleton",
    "forward_kinematics",
    "pose_forward",
    "world_poses",
]
