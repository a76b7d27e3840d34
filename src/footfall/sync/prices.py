"""What a schedule costs: motions off their own speed, and feet in disagreement.

A price is per phase for the first, per second for the second. They were swept over the pairs of
realistic sequences that `footfall.report.schedule_score` plays, for the least of both at once.
"""

from __future__ import annotations

import math

from footfall.compilation import small_kernel
from footfall.support import Support

__all__ = [
    "DISAGREEMENT_PRICE",
    "EQUAL_CONCERN",
    "FLIGHT_VOTE",
    "GREATEST_RATE",
    "LEAST_RATE",
    "SHORTEST_SUPPORT",
    "SOON",
    "TIME_VALUE",
    "stretch_cost",
]

FLIGHT = int(Support.FLIGHT)

GREATEST_RATE = 2.5
"""A clip is never asked to run faster than this, clip time per clock time."""

LEAST_RATE = 0.4
"""Nor slower than this."""

DISAGREEMENT_PRICE = 4.7
"""A second in which one foot is planted by half of the weight."""

FLIGHT_PRICE = 2.0
"""A flight cannot be stretched without breaking the laws of motion, so it costs more."""

FLIGHT_VOTE = 3.0
"""For the same reason its duration counts thrice in that of a column."""

EASY_OCTAVES, STEEPNESS = 0.6, 1.0
"""Beyond ×1.5 a stretch costs twice as much for each octave."""

EASY_FLIGHT_OCTAVES, FLIGHT_STEEPNESS = 0.4, 2.0
"""A flight beyond ×1.3 costs three times as much."""

SOON = 0.05
"""Whoever is held must be able to go on for this long afterwards [s]."""

SHORTEST_SUPPORT = 0.1
"""What carries the body does so for this long [s] where the rates allow it: a foot that is down
for less is a tap."""

EQUAL_CONCERN = 0.7
"""The stretch of an action counts by this much as if all weighed the same, else by its weight:
a light action is seen too, on the arms for one, and may weigh more soon."""

TIME_VALUE = 0.5
"""What a second of a good schedule costs: by it states at different times are compared."""


@small_kernel
def stretch_cost(stretch: float, support: int, weight: float) -> float:
    """Return the cost of playing a phase `stretch` times as long as at its own speed."""
    octaves = abs(math.log2(stretch))
    if support == FLIGHT:
        excess = max(octaves - EASY_FLIGHT_OCTAVES, 0.0)
        return weight * FLIGHT_PRICE * (octaves + FLIGHT_STEEPNESS * excess)
    return weight * (octaves + STEEPNESS * max(octaves - EASY_OCTAVES, 0.0))
