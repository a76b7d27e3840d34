"""Median, 95th percentile and greatest of many values, by what the blend did meanwhile."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from footfall.report.spans import Group

__all__ = ["GroupedSpread", "Spread", "rounded"]

DECIMALS = 4
"""Decimals of every number of a report."""


def rounded(value: float | None) -> float | None:
    """Return a number as reports hold it: four decimals, None where there is none."""
    # The sum turns -0.0 into 0.0.
    return None if value is None else round(value, DECIMALS) + 0.0


@dataclass(frozen=True, slots=True)
class Spread:
    """How values are distributed; in the unit of the values."""

    count: int
    """How many values there are."""

    median: float | None
    """Half of them are at most this; None where there are no values."""

    p95: float | None
    """95 % of them are at most this, linear between two values; None likewise."""

    maximum: float | None
    """The greatest; None likewise."""

    @classmethod
    def of(cls, values: Iterable[float]) -> Spread:
        """Describe values, of which there may be none."""
        array = np.fromiter(values, dtype=np.float64)
        if array.size == 0:
            return cls(0, None, None, None)
        median, p95 = np.percentile(array, [50.0, 95.0])
        return cls(array.size, float(median), float(p95), float(array.max()))

    def to_json(self) -> dict[str, float | int | None]:
        """Return ``median``, ``p95``, ``max`` and ``count`` for a report."""
        return {
            "median": rounded(self.median),
            "p95": rounded(self.p95),
            "max": rounded(self.maximum),
            "count": self.count,
        }


@dataclass(frozen=True, slots=True)
class GroupedSpread:
    """The same of all spans, and of the spans of each group apart.

    All together hides everything, since most spans are of one clip alone: bounds are on groups.
    """

    overall: Spread
    """All spans."""

    alone: Spread
    """Spans in which one action had all the weight."""

    transitions: Spread
    """Spans in which weights moved."""

    mixes: Spread
    """Spans in which several actions had lasting weights."""

    @classmethod
    def of(cls, values: Sequence[tuple[Group, float]]) -> GroupedSpread:
        """Describe values, each with the group it belongs to."""
        by_group = {group: [value for of, value in values if of is group] for group in Group}
        return cls(
            Spread.of([value for _, value in values]),
            Spread.of(by_group[Group.ALONE]),
            Spread.of(by_group[Group.TRANSITIONS]),
            Spread.of(by_group[Group.MIXES]),
        )

    def to_json(self) -> dict[str, object]:
        """Return the figures of all spans, and under each group's name its own."""
        return {
            **self.overall.to_json(),
            "alone": self.alone.to_json(),
            "transitions": self.transitions.to_json(),
            "mixes": self.mixes.to_json(),
        }
