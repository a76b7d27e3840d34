"""From the search's best way to the window: phases, results, durations and paces."""

from __future__ import annotations

from footfall.compilation import inner_kernel
from footfall.support import Support
from footfall.sync.columns import combine_column, following, has_ended, support_of
from footfall.sync.prices import SOON
from footfall.sync.search_memory import SearchMemory
from footfall.sync.shares import natural_duration
from footfall.sync.tables import Rules, SequenceTable
from footfall.sync.window import Window

__all__ = ["write_path"]

FLIGHT, CONFLICT = int(Support.FLIGHT), int(Support.CONFLICT)


@inner_kernel
def write_path(table: SequenceTable, window: Window, rules: Rules, node: int) -> None:
    """Write the decided columns.

    Args:
        table: All sequences.
        window: The schedule; its search memory holds the lanes, and the way to the node.
        rules: The rules of the planner.
        node: The end of the way, or -1 if no action is left that could go on.
    """
    memory = window.search[0]
    searched = memory.depth[node] if node >= 0 else 0
    window.offset[0] = memory.offset[node] if node >= 0 else 0.0
    columns = window.results.shape[0]
    for seat in range(window.playing.shape[0]):
        if window.playing[seat] and has_ended(table, window.sequence[seat], window.phases[seat, 0]):
            for column in range(1, columns):
                window.phases[seat, column] = following(window.phases[seat, column - 1])
            window.pace[seat, 0] = window.pace[seat, 1] = 0.0
    for column in range(1, columns):
        if column <= searched:
            window.durations[column - 1] = memory.durations[node, column - 1]
            for lane in range(memory.lanes):
                seat = memory.seat[lane]
                goes_on = memory.advancing[node, column - 1] >> lane & 1
                window.phases[seat, column] = window.phases[seat, column - 1] + goes_on
        else:
            _go_on_without_search(table, window, rules, memory, column)
    window.durations[columns - 1] = window.durations[columns - 2]
    for lane in range(memory.lanes):
        _set_pace(table, window, memory, node, lane)
    for seat in range(window.playing.shape[0]):
        if window.playing[seat] and window.muted[seat]:
            _run_freely(table, window, seat)
    for column in range(1, columns):
        combine_column(table, window, rules, column)


@inner_kernel
def _go_on_without_search(
    table: SequenceTable, window: Window, rules: Rules, memory: SearchMemory, column: int
) -> None:
    """Decide a column beyond the search: all go on but for those who would conflict.

    It is decided again before it is played. Where it is not that simple everybody waits.
    """
    constraint = table.whole
    weighted = total = 0.0
    stuck = False
    for lane in range(memory.lanes):
        seat = memory.seat[lane]
        sequence = int(window.sequence[seat])
        before = window.phases[seat, column - 1]
        phase = following(before)
        support = support_of(table, sequence, phase, rules.ended)
        if support != FLIGHT and constraint & support == CONFLICT:
            phase = before
            support = support_of(table, sequence, phase, rules.ended)
        elif not has_ended(table, sequence, before):
            weighted += memory.weight[lane] * natural_duration(table, sequence, before)
            total += memory.weight[lane]
        if support != FLIGHT:
            constraint &= support
            stuck = stuck or constraint == CONFLICT
        window.phases[seat, column] = phase
    if stuck:
        for lane in range(memory.lanes):
            seat = memory.seat[lane]
            window.phases[seat, column] = window.phases[seat, column - 1]
    window.durations[column - 1] = weighted / total if total > 0.0 else 0.0


@inner_kernel
def _set_pace(
    table: SequenceTable, window: Window, memory: SearchMemory, node: int, lane: int
) -> None:
    """Set how fast a lane plays in columns 0 and 1: each phase evenly over all its columns."""
    seat = memory.seat[lane]
    own = memory.left[lane]
    column = 0
    for place in range(2):
        lasting = 0.0
        ends = False
        while column < memory.depth[node] and not ends:
            lasting += memory.durations[node, column]
            ends = memory.advancing[node, column] >> lane & 1 != 0
            column += 1
        if not ends:
            # The rest lies behind the end of the search.
            lasting = max(lasting + SOON, own)
        window.pace[seat, place] = own / lasting
        if place == 0 and (not ends or memory.advancing[node, 0] >> lane & 1 == 0):
            window.pace[seat, 1] = window.pace[seat, 0]
            return
        coming = window.phases[seat, 0] + 1
        if has_ended(table, int(window.sequence[seat]), coming):
            window.pace[seat, 1] = 0.0
            return
        own = natural_duration(table, int(window.sequence[seat]), coming)


@inner_kernel
def _run_freely(table: SequenceTable, window: Window, seat: int) -> None:
    """Say where a muted action will be, which plays at its own speed."""
    sequence = int(window.sequence[seat])
    phase = window.phases[seat, 0]
    left = window.remaining[seat]
    window.pace[seat, 0] = window.pace[seat, 1] = 1.0
    for column in range(1, window.results.shape[0]):
        left -= window.durations[column - 1]
        while left <= 0.0 and not has_ended(table, sequence, phase):
            phase += 1
            left += natural_duration(table, sequence, phase)
        window.phases[seat, column] = phase
