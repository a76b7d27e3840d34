"""From a clip to its support phases, and to a clip whose planted feet hold."""

from footfall.detection.cleaning import CleanedClip, clean, clean_and_tell
from footfall.detection.contacts import Contacts, detect_contacts
from footfall.detection.intervals import Interval
from footfall.detection.limb_contacts import detect_limb_supports, hands_on_the_ground
from footfall.detection.phases import contact_supports, detect_supports, frame_symbols
from footfall.detection.planted import planted_intervals
from footfall.detection.traveling import travel

__all__ = [
    "CleanedClip",
    "Contacts",
    "Interval",
    "clean",
    "clean_and_tell",
    "contact_supports",
    "detect_contacts",
    "detect_limb_supports",
    "detect_supports",
    "frame_symbols",
    "hands_on_the_ground",
    "planted_intervals",
    "travel",
]
