"""The times of each foot in one cycle as times of the same foot in another one.

Where a walk answers a run, the double support of one lies on the flight of the other: a foot comes
down as that begins in the walk, and as it ends in the run. Laid over each other phase by phase, the
foot of the run would still be in the air where that of the walk stands. So each foot is mapped by
its own events: it comes down when it comes down, and leaves when it leaves.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from footfall.actions.cycles import ONE_FOOT, GaitCycle
from footfall.arrays import Flags, Floats, Seconds
from footfall.support import Support

__all__ = ["FootEvent", "event_times", "foot_events", "left_shares", "mapped_times", "mixed_phases"]


class FootEvent(NamedTuple):
    """A moment at which one foot comes down or leaves."""

    boundary: int
    """The boundary between two phases at which it does; where `mixed`, the one before a phase
    that is a double support in some cycles and a flight in others."""

    mixed: bool
    """Whether it does so at either end of that phase, by what the phase is."""

    strikes: bool
    """Whether it comes down."""


def mixed_phases(cycles: Sequence[GaitCycle]) -> Flags:
    """Return which phases stand on both feet in some cycles and on none in others, (phases,)."""
    kinds = zip(*(cycle.supports for cycle in cycles), strict=True)
    return np.array([len(set(one)) > 1 for one in kinds])


def _carries(support: Support, side: int) -> bool:
    return support.left if side == 0 else support.right


def foot_events(supports: Sequence[Support], mixed: Flags, side: int) -> list[FootEvent]:
    """Return what one foot does in a cycle, in order; nothing where it always stands, or never.

    Args:
        supports: What the phases stand on in any of the cycles.
        mixed: As of `mixed_phases`.
        side: 0 for the left foot, 1 for the right one.
    """
    count = len(supports)
    events: list[FootEvent] = []
    for phase in range(count):
        before, after = supports[phase - 1], supports[(phase + 1) % count]
        here = supports[phase]
        if mixed[phase]:
            ends = _carries(before, side), _carries(after, side)
            if ends[0] != ends[1]:
                events.append(FootEvent(phase, True, ends[1]))
        elif not mixed[phase - 1] and _carries(before, side) != _carries(here, side):
            events.append(FootEvent(phase, False, _carries(here, side)))
    return events


def event_times(
    events: Sequence[FootEvent], supports: Sequence[Support], starts: Seconds
) -> Seconds:
    """Return when the events are in one cycle, and in those before and after it [s].

    A foot that does nothing is told by where the phases begin.

    Args:
        events: As of `foot_events`.
        supports: What the phases of this cycle stand on.
        starts: Their boundaries [s], shape (phases + 1,).

    Returns:
        Times in order, shape (3 events,).
    """
    if not events:
        events = [FootEvent(phase, False, True) for phase in range(len(supports))]
    times: list[float] = []
    for event in events:
        # On both feet a foot comes down first and the other leaves last; in flight reversed.
        late = event.mixed and (supports[event.boundary] is Support.DOUBLE) is not event.strikes
        times.append(float(starts[event.boundary + late]))
    period = float(starts[-1] - starts[0])
    once = np.array(times)
    return np.concatenate([once - period, once, once + period])


def left_shares(times: Seconds, supports: Sequence[Support], starts: Seconds) -> Floats:
    """Return how much the left foot rather than the right one leads at some times, 0 to 1.

    All of it while it stands alone, going over evenly where both stand, or none.
    """
    count = len(supports)
    knots: list[float] = []
    values: list[float] = []
    for phase, support in enumerate(supports):
        if support in ONE_FOOT:
            knots += [float(starts[phase]), float(starts[phase + 1])]
            values += [1.0 if support is Support.LEFT else 0.0] * 2
    period = float(starts[count] - starts[0])
    knots = [knot + shift for shift in (-period, 0.0, period) for knot in knots]
    return np.interp(times, knots, values * 3)


def mapped_times(times: Seconds, knots: Seconds, values: Seconds) -> Seconds:
    """Return times of one cycle as times of another one, without a jump of speed.

    A monotone cubic whose slope at each knot is the harmonic mean of both sides' (S-25).

    Args:
        times: In the first cycle [s], within its knots.
        knots: Moments in the first cycle, in order; all of whole cycles.
        values: The same moments in the other one.
    """
    spans = np.diff(knots)
    slopes = np.diff(values) / spans
    before = np.roll(slopes, 1)
    ends = 2.0 * slopes * before / (slopes + before)
    ends = np.append(ends, ends[0])
    index = np.clip(np.searchsorted(knots, times, side="right") - 1, 0, len(spans) - 1)
    u = (times - knots[index]) / spans[index]
    span = spans[index]
    return (
        (1.0 + 2.0 * u) * (1.0 - u) ** 2 * values[index]
        + u * u * (3.0 - 2.0 * u) * values[index + 1]
        + span * u * (1.0 - u) ** 2 * ends[index]
        + span * u * u * (u - 1.0) * ends[index + 1]
    )
