"""When each foot comes down: what animators mark in a clip to have it synchronized."""

from __future__ import annotations

from typing import NamedTuple

from footfall.support import SupportSequence

__all__ = ["Landing", "landings"]

LEFT, RIGHT = 0, 1
"""Which foot."""


class Landing(NamedTuple):
    """A moment in which a foot comes down."""

    time: float
    """Clip time [s]."""

    foot: int
    """0 left, 1 right."""


def landings(supports: SupportSequence) -> tuple[Landing, ...]:
    """Return every landing of a motion, in order of time; of a cycle, within its first turn.

    Args:
        supports: What carries the body when. The beginning of a motion that is played once is no
            landing.
    """
    found: list[Landing] = []
    phases = supports.phases
    for index, time in enumerate(supports.boundaries[:-1]):
        if index == 0 and not supports.cyclic:
            continue
        before, after = phases[index - 1].support, phases[index].support
        place = time % supports.duration if supports.cyclic else time
        if after.left and not before.left:
            found.append(Landing(place, LEFT))
        if after.right and not before.right:
            found.append(Landing(place, RIGHT))
    return tuple(sorted(found))
