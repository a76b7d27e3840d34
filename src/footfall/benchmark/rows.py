"""One figure, and how times are taken."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass

__all__ = ["Row", "seconds_each"]


@dataclass(frozen=True)
class Row:
    """One figure beside its budget."""

    name: str
    """What was measured."""

    value: float
    """How much."""

    budget: float | None
    """What it should be at most; None where nothing was asked for."""

    unit: str
    """Of both."""

    @property
    def mark(self) -> str:
        """A star where the budget is not met."""
        return "*" if self.budget is not None and self.value > self.budget else " "


def seconds_each(action: Callable[[], object], rounds: int, times: int = 1) -> float:
    """Return how long an action takes [s]: the median over some rounds of some times each.

    Time is that of this process, so that others on the machine count for less.
    """
    action()
    taken: list[float] = []
    for _ in range(rounds):
        start = time.process_time()
        for _ in range(times):
            action()
        taken.append((time.process_time() - start) / times)
    return statistics.median(taken)
