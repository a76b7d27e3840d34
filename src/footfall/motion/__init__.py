"""A body in time."""

from footfall.motion.clip import Clip

__all__ = ["Clip"]
