"""The paper's vocabulary: symbols and sequences that know no body and no clock."""

from footfall.support.algebra import Support, combine
from footfall.support.sequence import SupportPhase, SupportSequence, merge_equal_neighbors

__all__ = ["Support", "SupportPhase", "SupportSequence", "combine", "merge_equal_neighbors"]
