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
the processor, and more limbs are more bits: hands, or the front legs of a quadruped, follow the
feet, and a body that stands on them too is a support beside the five named ones.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import IntEnum

import numpy as np

from footfall.arrays import Supports

__all__ = ["EVERY_LIMB", "LIMBS", "Support", "combine"]

LIMBS = "LRlrps"
"""One letter a limb, in the order of their bits: the feet or hind legs, the hands or front legs,
and the legs between them (port and starboard), left before right."""

EVERY_LIMB = (1 << (len(LIMBS) + 1)) - 1
"""The support that gives way to any other one, however many limbs there are."""


class Support(IntEnum):
    """What holds the body up: an element of the paper's set FS, or any set of limbs.

    The five of the paper have names. The others exist as soon as they are asked for, one object
    each: ``Support.from_symbol("D+lr")`` is a body on all fours, ``Support.from_symbol("+lr")`` a
    handstand. Feet alone, such as DOUBLE, then say that the hands are off the ground.
    """

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

    @classmethod
    def _missing_(cls, value: object) -> Support | None:
        """Make the object of a set of limbs that has no name of its own."""
        if not isinstance(value, int) or not 0 < value <= EVERY_LIMB or not value & 1:
            return None
        support = int.__new__(cls, value)
        support._name_ = _symbol_of(int(support))
        support._value_ = int(support)
        # Threads may race to here: the first one's object stays.
        return cls.__dict__["_value2member_map_"].setdefault(int(support), support)

    @property
    def symbol(self) -> str:
        """The text form, such as R, D, - or L+r; Err for a conflict."""
        return _symbol_of(int(self))

    @classmethod
    def from_symbol(cls, symbol: str) -> Support:
        """Return the support that a word of the text form means.

        Args:
            symbol: R, L, D or -; or R, L, D or nothing, then + and the other limbs that carry,
                in the order of `LIMBS`, such as D+lr, L+r or +lr.

        Raises:
            KeyError: If it is none of them.
        """
        if symbol in _SUPPORTS:
            return _SUPPORTS[symbol]
        letters = symbol.replace("D", "LR", 1).replace("+", "", 1)
        support = cls.from_limbs(LIMBS.index(letter) for letter in letters if letter in LIMBS)
        if support.symbol != symbol:
            raise KeyError(symbol)
        return support

    @classmethod
    def from_limbs(cls, limbs: Iterable[int]) -> Support:
        """Return the support of a body that stands on these limbs, as positions in `LIMBS`."""
        bits = 0
        for limb in limbs:
            bits |= 2 << limb
        return cls(bits | 1 if bits else 0)

    @property
    def limbs(self) -> tuple[int, ...]:
        """The limbs that carry, as positions in `LIMBS`."""
        return tuple(limb for limb in range(len(LIMBS)) if int(self) >> (limb + 1) & 1)

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
        return bool(int(self) & 0b010)

    @property
    def right(self) -> bool:
        """Whether the right foot carries."""
        return bool(int(self) & 0b100)


def _symbol_of(bits: int) -> str:
    if bits in (0, 1):
        return "Err" if bits else "-"
    carrying = [letter for limb, letter in enumerate(LIMBS) if bits >> (limb + 1) & 1]
    feet = "".join(letter for letter in carrying if letter in "LR").replace("LR", "D")
    others = "".join(letter for letter in carrying if letter not in "LR")
    return f"{feet}+{others}" if others else feet


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
