"""The mannequin of a clip, as the files that show it have it, and its colors."""

from __future__ import annotations

from footfall.errors import SkeletonError
from footfall.io.flat_toes import flat_toe_turns
from footfall.io.mannequin import Mannequin, Tone, mannequin
from footfall.motion import Clip
from footfall.skeleton import find_anatomy

__all__ = ["COLORS", "clip_mannequin"]

COLORS = {
    Tone.BODY: (0.66, 0.64, 0.60),
    Tone.FACE: (0.10, 0.11, 0.13),
    Tone.LEFT: (0.27, 0.47, 0.62),
    Tone.RIGHT: (0.72, 0.42, 0.21),
    Tone.LEFT_FOOT: (0.03, 0.17, 0.42),
    Tone.RIGHT_FOOT: (0.64, 0.15, 0.02),
}
"""Linear colors: the right side warm, the left side cool, as in all pictures."""


def clip_mannequin(clip: Clip) -> Mannequin:
    """Return the body's mannequin; plain bones for one without two legs."""
    try:
        anatomy = find_anatomy(clip.skeleton)
    except SkeletonError:
        return mannequin(clip.skeleton, None)
    return mannequin(clip.skeleton, anatomy, flat_toe_turns(anatomy, *clip.world_poses()))
