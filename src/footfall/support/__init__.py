"""The paper's vocabulary: symbols and sequences that know no body and no clock."""

from footfall.support.algebra import EVERY_LIMB, LIMBS, Support, combine
from footfall.support.sequence import SupportPhase, SupportSequence, merge_equal_neighbors

__all__ = [
    "EVERY_LIMB",
    "LIMBS",
    "Support",
    "SupportPhase",
    "SupportSequence",
    "combine",
    "merge_equal_neighbors",
]
