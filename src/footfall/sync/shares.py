"""What a phase contributes to each of the slots that it covers: plain numbers, no clock."""

from __future__ import annotations

from collections.abc import Sequence

from footfall.compilation import lean_kernel, small_kernel
from footfall.sync.columns import has_ended
from footfall.sync.tables import Rules, SequenceTable
from footfall.sync.window import Window

__all__ = ["finish_slot", "natural_duration", "slot_seconds", "spend_slot", "stretch_of"]


@small_kernel
def natural_duration(table: SequenceTable, sequence: int, phase: int) -> float:
    """Return how long a phase lasts at its clip's own speed; past the end, the last one."""
    count = table.phase_count[sequence]
    if table.cyclic[sequence]:
        phase %= count
    elif phase >= count:
        phase = count - 1
    return float(table.durations[table.first[sequence] + phase])


@lean_kernel
def finish_slot(table: SequenceTable, window: Window) -> None:
    """Count the slot being played to those for which somebody was held or a support lasted.

    To be called before `Window.remaining` is set for the next slot. A phase in which every limb
    carries may be split over as many slots as its own time covers: these are no holds (S-21).
    """
    lasting = window.durations[0]
    steady = window.results[1] == window.results[0]
    window.steady[0] = window.steady[0] + lasting if steady else 0.0
    for seat in range(window.playing.shape[0]):
        if not window.playing[seat]:
            continue
        phase = window.phases[seat, 0]
        if window.muted[seat]:
            window.held[seat] += 1
        elif window.phases[seat, 1] != phase:
            window.held[seat] = 0
        elif not has_ended(table, window.sequence[seat], phase):
            first = table.first[window.sequence[seat]]
            count = table.phase_count[window.sequence[seat]]
            splits = table.supports[first + phase % count] == table.whole
            if not (splits and window.remaining[seat] > lasting):
                window.held[seat] += 1


@lean_kernel
def spend_slot(table: SequenceTable, window: Window) -> None:
    """Let the slot being played pass in `Window.remaining`, before the next one is entered.

    An engine with a clock sets `remaining` from its clip times instead.
    """
    finish_slot(table, window)
    for seat in range(window.playing.shape[0]):
        if not window.playing[seat]:
            continue
        sequence = window.sequence[seat]
        phase = window.phases[seat, 0]
        if window.muted[seat]:
            left = window.remaining[seat] - window.durations[0]
            while left <= 0.0 and not has_ended(table, sequence, phase):
                phase += 1
                left += natural_duration(table, sequence, phase)
            window.phases[seat, 1] = phase
            window.remaining[seat] = left
            continue
        coming = window.phases[seat, 1]
        if has_ended(table, sequence, coming):
            window.remaining[seat] = 0.0
        elif coming == phase:
            window.remaining[seat] -= window.pace[seat, 0] * window.durations[0]
        else:
            window.remaining[seat] = natural_duration(table, sequence, coming)


def slot_seconds(
    table: SequenceTable, window: Window, rules: Rules, column: int = 0
) -> float | None:
    """Return how long a column lasts [s]: as planned, or in paper mode by equation 6.

    In paper mode a phase votes with all of its duration in every column that it covers (S-20).
    None where nobody is left who could say.
    """
    if rules.replans:
        seconds = float(window.durations[column])
        return seconds if seconds > 0.0 else None
    seats = [int(seat) for seat in window.playing.nonzero()[0] if window.phases[seat, column] >= 0]
    if not seats:
        return None
    own = [
        natural_duration(table, int(window.sequence[seat]), int(window.phases[seat, column]))
        for seat in seats
    ]
    weights = [float(window.weight[seat]) for seat in seats]
    if sum(weights) <= 0.0:
        return sum(own) / len(own)
    return sum(w * d for w, d in zip(weights, own, strict=True)) / sum(weights)


def stretch_of(
    table: SequenceTable,
    sequence: int,
    phases: Sequence[int],
    seconds: Sequence[float | None],
    slot: int,
) -> float | None:
    """Return how many times as long as at its own speed the phase of one slot lasts.

    Args:
        table: All sequences.
        sequence: The row of one.
        phases: Its absolute phase index in each slot.
        seconds: How long each slot lasts.
        slot: In which of them the phase is played.

    Returns:
        The factor, or None where the action does not play or has ended.
    """
    phase = phases[slot]
    if has_ended(table, sequence, phase):
        return None
    first = last = slot
    while first > 0 and phases[first - 1] == phase:
        first -= 1
    while last + 1 < len(phases) and phases[last + 1] == phase:
        last += 1
    lasting = sum(one or 0.0 for one in seconds[first : last + 1])
    return lasting / natural_duration(table, sequence, phase)
