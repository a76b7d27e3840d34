r"""The support algebra: which supports can be blended, and what the blend stands on.

The relation of [SCA04, figure 4] is the meet of a five-element lattice,

              DOUBLE
             /      \
          LEFT      RIGHT
             \      /
             CONFLICT
                |
              FLIGHT

and a meet of sets is an intersection. Give each support the set of things it still allows
(the body grounded, the left foot down, the right foot down), one bit each, and the whole
relation is ``&``. That it is commutative, associative and idempotent is then a property of
the processor, and more limbs are more bits.
"""

from __future__ import annotations

from enum import IntEnum

import numpy as np

from footfall.arrays import Supports

__all__ = ["Support", "combine"]


class Support(IntEnum):
    """What holds the body up: an element of the paper's set FS."""

    FLIGHT = 0b000
    """No foot on the ground (the paper's Ø). Absorbs every other support."""

    CONFLICT = 0b001
    """Left and right are both required (Err). Never found in a clip, only in a blend."""

    LEFT = 0b011
    """Left foot only (LS)."""

    RIGHT = 0b101
    """Right foot only (RS)."""

    DOUBLE = 0b111
    """Both feet (DS). Neutral: it gives way to any other support."""

    def __and__(self, other: int) -> Support:
        """Return the support of the blend of two motions (the paper's ⊕)."""
        return Support(int(self) & int(other))

    @property
    def symbol(self) -> str:
        """The letter of the text form: R, L, D or -, and Err for a conflict."""
        return _SYMBOLS[self]

    @classmethod
    def from_symbol(cls, symbol: str) -> Support:
        """Return the support that a letter of the text form means.

        Raises:
            KeyError: If the letter is none of R, L, D and -.
        """
        return _SUPPORTS[symbol]

    @classmethod
    def from_feet(cls, left: bool, right: bool) -> Support:
        """Return the support of a body that stands on these feet."""
        if left and right:
            return cls.DOUBLE
        if left:
            return cls.LEFT
        return cls.RIGHT if right else cls.FLIGHT

    @property
    def left(self) -> bool:
        """Whether the left foot carries."""
        return self in (Support.LEFT, Support.DOUBLE)

    @property
    def right(self) -> bool:
        """Whether the right foot carries."""
        return self in (Support.RIGHT, Support.DOUBLE)


_SYMBOLS = {
    Support.FLIGHT: "-",
    Support.CONFLICT: "Err",
    Support.LEFT: "L",
    Support.RIGHT: "R",
    Support.DOUBLE: "D",
}
_SUPPORTS = {
    "-": Support.FLIGHT,
    "L": Support.LEFT,
    "R": Support.RIGHT,
    "D": Support.DOUBLE,
}


def combine(supports: Supports, axis: int = 0) -> Supports:
    """Combine many supports at once (eq. 2).

    Args:
        supports: Values of `Support`, any shape; usually (actions, slots).
        axis: The axis to combine over; usually the actions.

    Returns:
        Values of `Support`, the shape of `supports` without `axis`. A column can be played
        if and only if it is not `Support.CONFLICT` (eq. 3).
    """
    return np.bitwise_and.reduce(supports, axis=axis)
