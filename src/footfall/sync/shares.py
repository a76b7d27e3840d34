"""What a phase contributes to each of the slots that it covers: plain numbers, no clock.

The paper lets an extended phase vote with its whole duration in every slot it covers. The
default planner splits it: what is left of it, over the slots that are known to be left to it.
"""

from __future__ import annotations

from footfall.compilation import kernel
from footfall.sync.columns import has_ended
from footfall.sync.tables import SequenceTable, Window

__all__ = ["column_share", "natural_duration", "spend_slot"]


@kernel
def natural_duration(table: SequenceTable, sequence: int, phase: int) -> float:
    """Return how long a phase lasts at its clip's own speed; past the end, the last one."""
    count = table.phase_count[sequence]
    if table.cyclic[sequence]:
        phase %= count
    elif phase >= count:
        phase = count - 1
    return float(table.durations[table.first[sequence] + phase])


@kernel
def column_share(table: SequenceTable, window: Window, seat: int, column: int) -> float:
    """Return what the phase of a seat contributes to one decided column of the window.

    What is left of the phase (`Window.remaining` for that of column 0, else all of it), split
    evenly over its columns from there on. The action must not have ended.
    """
    phase = window.phases[seat, column]
    columns = window.results.shape[0] - 1
    first = column
    while first > 0 and window.phases[seat, first - 1] == phase:
        first -= 1
    after = column + 1
    while after < columns and window.phases[seat, after] == phase:
        after += 1
    own = window.remaining[seat]
    if first > 0:
        own = natural_duration(table, window.sequence[seat], phase)
    return own / (after - first)


@kernel
def spend_slot(table: SequenceTable, window: Window) -> None:
    """Let the slot being played pass in `Window.remaining`, before the next one is entered.

    An engine with a clock sets `remaining` from its clip times instead.
    """
    for seat in range(window.playing.shape[0]):
        if window.playing[seat]:
            phase = window.phases[seat, 0]
            coming = window.phases[seat, 1]
            if has_ended(table, window.sequence[seat], coming):
                window.remaining[seat] = 0.0
            elif coming == phase:
                window.remaining[seat] -= column_share(table, window, seat, 0)
            else:
                window.remaining[seat] = natural_duration(table, window.sequence[seat], coming)
