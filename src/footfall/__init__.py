"""Starts, stops and mixes motion clips of humanoid characters so that the feet never slide."""

from footfall.adaptation import Plane
from footfall.detection import clean, detect_supports
from footfall.engine import Character, Crowd, Frame, Impossible, MotionLibrary, Started, Waiting
from footfall.errors import FootfallError
from footfall.io import load, load_supports, save, save_supports
from footfall.motion import Clip
from footfall.samples import sample
from footfall.skeleton import Skeleton
from footfall.support import Support, SupportPhase, SupportSequence
from footfall.warming import warmup

__all__ = [
    "Character",
    "Clip",
    "Crowd",
    "FootfallError",
    "Frame",
    "Impossible",
    "MotionLibrary",
    "Plane",
    "Skeleton",
    "Started",
    "Support",
    "SupportPhase",
    "SupportSequence",
    "Waiting",
    "clean",
    "detect_supports",
    "load",
    "load_supports",
    "sample",
    "save",
    "save_supports",
    "warmup",
]
