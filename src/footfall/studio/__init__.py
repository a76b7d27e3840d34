"""The studio: see a motion, steer it, correct its supports, in a browser (extra ``studio``)."""

from footfall.studio.opening import open_studio
from footfall.studio.show import show_character

__all__ = ["open_studio", "show_character"]
