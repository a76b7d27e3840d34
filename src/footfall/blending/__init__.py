"""The weighted mean of normalized poses, and of the ways they go."""

from footfall.blending.poses import add_pose, clear_pose, finish_pose

__all__ = ["add_pose", "clear_pose", "finish_pose"]
