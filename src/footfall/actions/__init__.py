"""Actions that are more than a clip: they follow parameters, or a program of the user's."""

from footfall.actions.cycles import GaitCycle
from footfall.actions.locomotion import CycleMix, Locomotion
from footfall.actions.motion_source import MotionSource, ask_source

__all__ = ["CycleMix", "GaitCycle", "Locomotion", "MotionSource", "ask_source"]
