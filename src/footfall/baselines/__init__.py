"""How others keep motions in step, beside which ours is measured (measures, section 3)."""

from footfall.baselines.equal_cycles import EqualCycles
from footfall.baselines.fixed_contacts import (
    FIXED_RULES,
    displacement_contacts,
    height_and_speed_contacts,
    speed_contacts,
)
from footfall.baselines.landings import Landing, landings
from footfall.baselines.marker_leader import MarkerLeader
from footfall.baselines.paced_character import PacedCharacter
from footfall.baselines.pacing import Pacing, Playing

__all__ = [
    "FIXED_RULES",
    "EqualCycles",
    "Landing",
    "MarkerLeader",
    "PacedCharacter",
    "Pacing",
    "Playing",
    "displacement_contacts",
    "height_and_speed_contacts",
    "landings",
    "speed_contacts",
]
