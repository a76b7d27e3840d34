"""What the schedule costs: stretched phases, delayed starts, short phases, uneven rates."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats
from footfall.errors import ArgumentError
from footfall.report.spreads import Spread, rounded
from footfall.support import Support

__all__ = ["Delay", "PlayedPhase", "ScheduleReport", "Stretch", "measure_schedule"]

SHORT = 0.1
"""A phase of the result shorter than this is a stumble [s] (measures, section 2)."""


@dataclass(frozen=True, slots=True)
class PlayedPhase:
    """A phase of one action as it was played.

    Raises:
        ArgumentError: If either duration is not positive.
    """

    clock_seconds: float
    """How long it lasted [s]."""

    clip_seconds: float
    """How much of the clip was played meanwhile [s]."""

    support: Support
    """What it stood on."""

    def __post_init__(self) -> None:
        for label, seconds in (
            ("on the clock", self.clock_seconds),
            ("in its clip", self.clip_seconds),
        ):
            if not (seconds > 0.0 and math.isfinite(seconds)):
                raise ArgumentError(f"a played phase lasts {seconds} s {label}; it must be > 0")

    @property
    def octaves(self) -> float:
        """|log2 (clock seconds / clip seconds)|: 0 at its own speed, 1 at double or half."""
        return abs(math.log2(self.clock_seconds / self.clip_seconds))


@dataclass(frozen=True, slots=True)
class Delay:
    """A start command and what became of it."""

    commanded: float
    """When it was given [s]."""

    actual: float | None
    """When the action started [s]; None if it never did."""

    reason: str = ""
    """Why it waited; empty if it did not."""


@dataclass(frozen=True, slots=True)
class Stretch:
    """|log2 (clock seconds / clip seconds)| over phases: 0 is their own speed, 1 double or half."""

    count: int
    """How many phases."""

    mean: float | None
    """The mean; None where there is no phase."""

    p95: float | None
    """The 95th percentile; None likewise."""

    maximum: float | None
    """The greatest; None likewise."""

    @classmethod
    def of(cls, phases: Iterable[PlayedPhase]) -> Stretch:
        """Describe the stretch of phases, of which there may be none."""
        octaves = np.array([phase.octaves for phase in phases])
        if octaves.size == 0:
            return cls(0, None, None, None)
        p95 = float(np.percentile(octaves, 95.0))
        return cls(octaves.size, float(octaves.mean()), p95, float(octaves.max()))

    def to_json(self) -> dict[str, float | int | None]:
        """Return ``mean``, ``p95``, ``max`` and ``count`` for a report."""
        return {
            "mean": rounded(self.mean),
            "p95": rounded(self.p95),
            "max": rounded(self.maximum),
            "count": self.count,
        }


@dataclass(frozen=True, slots=True)
class ScheduleReport:
    """The measures of a schedule (measures, section 2)."""

    stretch: Stretch
    """Of every phase that was played, of all actions."""

    flights: Stretch
    """Of the flights among them: a stretched flight floats."""

    delays: Spread
    """From the command to the start [s], of the actions that started."""

    never_started: int
    """How many start commands led to nothing."""

    reasons: tuple[str, ...]
    """Why starts waited, in the order of the commands."""

    short_phases: int
    """How many phases of the result last less than 0.1 s."""

    short_share: float | None
    """Which share of its phases that is, 0 to 1; None where it has none."""

    slowest_rate: float | None
    """Least clip time per clock time of an action while it plays; None where none plays."""

    fastest_rate: float | None
    """The greatest; None likewise."""

    greatest_jump: float | None
    """Greatest change of an action's rate from one frame to the next; None likewise."""

    def to_json(self) -> dict[str, object]:
        """Return all figures by name for a report."""
        return {
            "stretch": self.stretch.to_json(),
            "flight_stretch": self.flights.to_json(),
            "delay_s": {**self.delays.to_json(), "never": self.never_started},
            "delay_reasons": list(self.reasons),
            "short_phases": self.short_phases,
            "short_phase_share": rounded(self.short_share),
            "rate_min": rounded(self.slowest_rate),
            "rate_max": rounded(self.fastest_rate),
            "rate_jump": rounded(self.greatest_jump),
        }


def measure_schedule(
    actions: Iterable[Sequence[PlayedPhase]],
    result_durations: Sequence[float],
    delays: Sequence[Delay],
    rates: Floats,
) -> ScheduleReport:
    """Measure a schedule that was played.

    Args:
        actions: The phases of each action as they were played.
        result_durations: How long each phase of the combined support lasted [s]; leave out the
            first and the last one where the recording cuts them.
        delays: What became of each start command.
        rates: Clip time per clock time of each action in each frame, shape (frames, actions),
            NaN while it does not play.
    """
    phases = [phase for action in actions for phase in action]
    short = sum(duration < SHORT for duration in result_durations)
    playing = rates[np.isfinite(rates)]
    jumps = np.abs(np.diff(rates, axis=0))
    jumps = jumps[np.isfinite(jumps)]
    return ScheduleReport(
        stretch=Stretch.of(phases),
        flights=Stretch.of(phase for phase in phases if phase.support is Support.FLIGHT),
        delays=Spread.of(d.actual - d.commanded for d in delays if d.actual is not None),
        never_started=sum(delay.actual is None for delay in delays),
        reasons=tuple(delay.reason for delay in delays if delay.reason),
        short_phases=short,
        short_share=short / len(result_durations) if result_durations else None,
        slowest_rate=float(playing.min()) if playing.size else None,
        fastest_rate=float(playing.max()) if playing.size else None,
        greatest_jump=float(jumps.max()) if jumps.size else None,
    )
