"""The stages in order; read `footfall.engine.pipeline` first."""

from footfall.engine.action import Action
from footfall.engine.answers import Impossible, Started, Waiting
from footfall.engine.character import Character
from footfall.engine.crowd import Crowd
from footfall.engine.library import MotionLibrary
from footfall.engine.path_follower import PathFollower
from footfall.engine.recording import Recorder, Recording
from footfall.engine.state import Frame

__all__ = [
    "Action",
    "Character",
    "Crowd",
    "Frame",
    "Impossible",
    "MotionLibrary",
    "PathFollower",
    "Recorder",
    "Recording",
    "Started",
    "Waiting",
]
