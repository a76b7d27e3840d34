"""What one frame works out of a character, and nobody remembers: a record too."""

from __future__ import annotations

from typing import Annotated

from footfall.arrays import Floats, Positions, SmallFloats
from footfall.octets import LANES

__all__ = ["Moment"]


class Moment:
    """One character in the middle of a frame, as the kernels see it: a record of `moment_type`.

    Feet are in the order left, right.
    """

    way: Annotated[Floats, 3]
    """Where the motions take the root in this step: x, z in leg lengths, heading [rad], (3,)."""

    effectors: Annotated[Floats, 7]
    """Blended pelvis height and ankle positions, shape (7,)."""

    slides: Annotated[SmallFloats, LANES]
    """How far the motions themselves let heel and toe of each foot slide, less `way`, in leg
    lengths: x of all four, then z. Shape (8,)."""

    resting: Annotated[SmallFloats, LANES]
    """How high heel and toe of each foot rest in the mix, in leg lengths; the first four, (8,)."""

    points: Annotated[Positions, 2, 2, 3]
    """Heel and toe of the blended feet, relative to the root, in leg lengths, (2, 2, 3)."""

    heights: Annotated[Floats, 2, 2]
    """Their heights over where they rest, in leg lengths, shape (2, 2)."""

    step: float
    """Of the frame for which the following numbers hold [s]; they are the same for most rows."""

    kept_speed: float
    """What is left after that time of a difference of smoothed speed, 0..1."""

    kept_roll: float
    """The same of the way between heel and toe."""

    foreseen_points: Annotated[Positions, 2, 2, 3]
    """Heel and toe of each foot at the end of the slot, relative to the root, in leg lengths,
    shape (2, 2, 3)."""
