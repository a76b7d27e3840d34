"""A body in time."""

from footfall.motion.clip import Clip
from footfall.motion.root_motion import RootPath, extract_root_path
from footfall.motion.sampling import cycle_displacement, sample

__all__ = ["Clip", "RootPath", "cycle_displacement", "extract_root_path", "sample"]
