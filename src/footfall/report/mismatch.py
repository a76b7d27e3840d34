"""Whether the feet do what was commanded: the detector's verdict against the schedule."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Flags, Supports
from footfall.report.track import carrying
from footfall.support import Support

__all__ = ["NEAR", "Mismatch", "support_mismatch"]

NEAR = 2
"""Frames this near to a scheduled boundary are not judged (measures, section 1)."""


@dataclass(frozen=True, slots=True)
class Mismatch:
    """How often the detected contacts disagree with the commanded support."""

    overall: float | None
    """Share of the judged frames, 0 to 1; None where no frame is judged."""

    transitions: float | None
    """The same over frames in which weights move; None where no such frame is judged."""


def support_mismatch(supports: Supports, contacts: Flags, moving: Flags) -> Mismatch:
    """Compare what was commanded with what a detector finds in the result.

    The share of frames, more than two frames away from a scheduled boundary, in which the
    detector disagrees with the schedule about a foot (measures, section 1): the last two frames
    before a boundary and the first two after it are not judged, nor are frames of CONFLICT,
    which command nothing.

    Args:
        supports: The commanded support of each frame, shape (frames,).
        contacts: Whether the detector finds each foot on the ground, shape (frames, 2).
        moving: Whether weights move, shape (frames,).
    """
    judged = (supports != Support.CONFLICT) & ~_near_boundary(supports)
    wrong = (carrying(supports) != contacts).any(axis=1)
    return Mismatch(_share(wrong[judged]), _share(wrong[judged & moving]))


def _near_boundary(supports: Supports) -> Flags:
    near = np.zeros(len(supports), dtype=np.bool_)
    for boundary in np.flatnonzero(np.diff(supports)) + 1:
        near[max(boundary - NEAR, 0) : boundary + NEAR] = True
    return near


def _share(flags: Flags) -> float | None:
    return float(flags.mean()) if flags.size else None
