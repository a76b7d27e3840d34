"""A body in time."""

from footfall.motion.clip import Clip
from footfall.motion.cycle_closing import close_cycle, cut_cycle
from footfall.motion.cycle_search import Cycle, find_cycle
from footfall.motion.editing import crop, resample
from footfall.motion.leg_placement import place_feet
from footfall.motion.mirroring import mirror
from footfall.motion.root_motion import RootPath, extract_root_path
from footfall.motion.sampling import cycle_displacement, sample
from footfall.motion.soles import with_soles

__all__ = [
    "Clip",
    "Cycle",
    "RootPath",
    "close_cycle",
    "crop",
    "cut_cycle",
    "cycle_displacement",
    "extract_root_path",
    "find_cycle",
    "mirror",
    "place_feet",
    "resample",
    "sample",
    "with_soles",
]
