"""The methods that are set beside each other: ours, the paper's, and what others offer."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from footfall.baselines import EqualCycles, MarkerLeader, Pacing
from footfall.sync.tables import Planner

__all__ = ["METHODS", "Method"]


@dataclass(frozen=True, slots=True)
class Method:
    """A way to play a cue sheet."""

    imitates: str
    """Whose way it is."""

    synchronized: bool = True
    """Whether supports are synchronized at all."""

    footprints: bool = False
    """Whether planted feet are held where they came down."""

    planner: Planner | None = None
    """Instead of the cue sheet's."""

    pacing: Callable[[], Pacing] | None = None
    """What keeps the clips in step where supports are not synchronized; None: nothing does."""


METHODS: Mapping[str, Method] = MappingProxyType(
    {
        "cross-fade": Method("a plain cross-fade; every clip at its own speed", synchronized=False),
        "equal-cycles": Method(
            "blend trees: a cross-fade with cycles scaled to one length",
            synchronized=False,
            pacing=EqualCycles,
        ),
        "marker-leader": Method(
            "synchronization groups: the heaviest cycle leads, the others follow its markers",
            synchronized=False,
            pacing=MarkerLeader,
        ),
        "paper": Method("the rule of the paper as printed", planner="paper"),
        "no-footprints": Method("ours, without holding planted feet"),
        "footfall": Method("ours", footprints=True),
    }
)
"""Each by its name, in the order of the table (measures, section 3)."""
