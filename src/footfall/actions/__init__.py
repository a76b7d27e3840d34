"""Actions that are more than a clip: what they play follows parameters."""

from footfall.actions.cycles import GaitCycle
from footfall.actions.locomotion import CycleMix, Locomotion

__all__ = ["CycleMix", "GaitCycle", "Locomotion"]
