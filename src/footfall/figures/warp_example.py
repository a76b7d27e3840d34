"""The time warp of a run that plays together with a handball shot, for figures 10 to 12."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats
from footfall.figures.cast import Cast
from footfall.scenario.schedule_problem import ScheduleProblem, solve
from footfall.support import Support

__all__ = ["LEADER", "OTHER", "WarpExample"]

LEADER, OTHER = "run", "shot"
SLOTS = 8


@dataclass(frozen=True, eq=False)
class WarpExample:
    """Slots of a schedule, and what the leading action plays in them."""

    clock_times: Floats
    """Where the slots begin, and the last one ends [s], shape (slots + 1,)."""

    clip_times: Floats
    """Where the clip is there [s], shape (slots + 1,)."""

    supports: tuple[Support, ...]
    """What the leading action stands on in each slot."""

    @classmethod
    def of(cls, cast: Cast) -> WarpExample:
        """Schedule both motions at equal weights by the paper's rule (eq. 6)."""
        sequences = [cast.motion(role).supports for role in (LEADER, OTHER)]
        answer = solve(
            ScheduleProblem.of(
                {
                    "sequences": [str(sequence) for sequence in sequences],
                    "priorities": [0.5, 0.5],
                    "planner": "paper",
                    "slots": SLOTS,
                }
            )
        )
        row: list[int] = answer["rows"][0][: len(answer["durations"])]
        durations = [seconds for seconds in answer["durations"] if seconds is not None]
        phases = sequences[0].phases
        shares = _shares(row[: len(durations)])
        natural = [
            phases[index].duration * share
            for index, share in zip(row[: len(durations)], shares, strict=True)
        ]
        return cls(
            np.concatenate([[0.0], np.cumsum(durations)]),
            np.concatenate([[0.0], np.cumsum(natural)]),
            tuple(phases[index].support for index in row[: len(durations)]),
        )

    @property
    def rates(self) -> Floats:
        """Mean clip time per clock time in each slot, shape (slots,)."""
        return np.diff(self.clip_times) / np.diff(self.clock_times)


def _shares(row: list[int]) -> list[float]:
    """Return which share of its phase each slot plays: one that is held is split evenly."""
    shares: list[float] = []
    for slot, index in enumerate(row):
        first = slot
        while first > 0 and row[first - 1] == index:
            first -= 1
        last = slot
        while last + 1 < len(row) and row[last + 1] == index:
            last += 1
        shares.append(1.0 / (last - first + 1))
    return shares
