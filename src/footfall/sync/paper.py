"""The paper's rule for who is held: priorities, Appendix A, and the start of an action.

Section 5.1: when a column is in conflict, the first action in order of priority that stands on
one foot there says which foot it is; those about to stand on the other one are *held*: their
phase of the column before is repeated. Among sequences whose neighbors differ and that do not
end, this never fails: whoever is held stands on anything but the other foot.
"""

from __future__ import annotations

from footfall.compilation import lean_kernel, small_kernel
from footfall.support import Support
from footfall.sync.columns import combine_column, following, support_of
from footfall.sync.tables import ABSENT, ENDED_STOPS, Rules, SequenceTable
from footfall.sync.window import Window

__all__ = [
    "enter_next_slot",
    "enter_window",
    "keep_window",
    "precedes",
    "restore_window",
    "synchronize_column",
    "try_start",
]

FLIGHT = int(Support.FLIGHT)
LEFT = int(Support.LEFT)
RIGHT = int(Support.RIGHT)


@small_kernel
def precedes(window: Window, seat: int, other: int) -> bool:
    """Return whether a seat has the higher priority, or is the older of two equal ones."""
    if window.priority[seat] != window.priority[other]:
        return window.priority[seat] > window.priority[other]
    return window.age[seat] < window.age[other]


@lean_kernel
def synchronize_column(table: SequenceTable, window: Window, rules: Rules, column: int) -> bool:
    """Decide one column from the one before it (section 5.1).

    Args:
        table: All sequences.
        window: The schedule; column `column` of its phases and results is written.
        rules: The rules of the planner.
        column: The column to decide, from 1 on.

    Returns:
        Whether it can be played. If not, `window.results` is CONFLICT there.
    """
    for seat in range(window.playing.shape[0]):
        if window.playing[seat]:
            window.phases[seat, column] = following(window.phases[seat, column - 1])
    if combine_column(table, window, rules, column):
        return True
    refused = _hold_the_other_foot(table, window, rules, column)
    if combine_column(table, window, rules, column):
        return True
    if rules.ended == ENDED_STOPS:
        _stop_the_ended(table, window, rules, column, refused)
        return combine_column(table, window, rules, column)
    if rules.falls_back:
        _hold_as_appendix_a(table, window, rules, column)
        return combine_column(table, window, rules, column)
    return False


@lean_kernel
def _hold_the_other_foot(table: SequenceTable, window: Window, rules: Rules, column: int) -> int:
    """Hold all whose foot is not that of the first in order of priority; return that foot."""
    leader = -1
    kept = FLIGHT
    for seat in range(window.playing.shape[0]):
        if window.playing[seat] and (leader < 0 or precedes(window, seat, leader)):
            support = support_of(
                table, window.sequence[seat], window.phases[seat, column], rules.ended
            )
            if support in (LEFT, RIGHT):
                leader = seat
                kept = support
    refused = LEFT if kept == RIGHT else RIGHT
    _hold(table, window, rules, column, refused)
    return refused


@lean_kernel
def _hold(table: SequenceTable, window: Window, rules: Rules, column: int, refused: int) -> None:
    """Hold every action that is about to stand on one foot."""
    for seat in range(window.playing.shape[0]):
        if window.playing[seat]:
            support = support_of(
                table, window.sequence[seat], window.phases[seat, column], rules.ended
            )
            if support == refused:
                window.phases[seat, column] = window.phases[seat, column - 1]


@lean_kernel
def _stop_the_ended(
    table: SequenceTable, window: Window, rules: Rules, column: int, refused: int
) -> None:
    """Take those out of the schedule whose last phase, repeated for ever, is the other foot."""
    for seat in range(window.playing.shape[0]):
        if window.playing[seat]:
            sequence = window.sequence[seat]
            phase = window.phases[seat, column]
            last = not table.cyclic[sequence] and phase >= table.phase_count[sequence] - 1
            if last and support_of(table, sequence, phase, rules.ended) == refused:
                window.phases[seat, column] = ABSENT


@lean_kernel
def _hold_as_appendix_a(table: SequenceTable, window: Window, rules: Rules, column: int) -> None:
    """Hold those that do not go with the result of the column before (Appendix A).

    Where that result is a flight, one flight held is enough: that of the last in priority.
    """
    flying = -1
    for seat in range(window.playing.shape[0]):
        if window.playing[seat]:
            before = window.phases[seat, column - 1]
            window.phases[seat, column] = following(before)
            flies = support_of(table, window.sequence[seat], before, rules.ended) == FLIGHT
            if flies and (flying < 0 or precedes(window, flying, seat)):
                flying = seat
    if window.results[column - 1] == FLIGHT:
        window.phases[flying, column] = window.phases[flying, column - 1]
    else:
        refused = LEFT if window.results[column - 1] == RIGHT else RIGHT
        _hold(table, window, rules, column, refused)


@lean_kernel
def enter_next_slot(table: SequenceTable, window: Window, rules: Rules) -> bool:
    """Move the window on by one slot and decide its new last column.

    Returns:
        Whether that column can be played.
    """
    lookahead = window.results.shape[0] - 2
    for column in range(lookahead):
        window.results[column] = window.results[column + 1]
    for seat in range(window.playing.shape[0]):
        if window.playing[seat]:
            for column in range(lookahead):
                window.phases[seat, column] = window.phases[seat, column + 1]
    return synchronize_column(table, window, rules, lookahead)


@lean_kernel
def enter_window(table: SequenceTable, window: Window, rules: Rules, seat: int, entry: int) -> bool:
    """Put an action in at column 0, test all columns, and keep what came of it either way.

    Returns:
        Whether the action can start like this. If not, the window must be restored.
    """
    last = window.results.shape[0] - 1
    if not rules.extends_at_start:
        synchronize_column(table, window, rules, last)
    window.playing[seat] = True
    window.phases[seat, 0] = entry
    if not combine_column(table, window, rules, 0):
        return False
    grounded = window.results[0] != FLIGHT
    for column in range(1, last + 1):
        if rules.extends_at_start:
            playable = synchronize_column(table, window, rules, column)
        else:
            window.phases[seat, column] = following(window.phases[seat, column - 1])
            playable = combine_column(table, window, rules, column)
        if not playable:
            return False
        if window.results[column] != FLIGHT:
            grounded = True
    return grounded or not rules.stays_grounded


@lean_kernel
def try_start(table: SequenceTable, window: Window, rules: Rules, seat: int, entry: int) -> bool:
    """Start an action at a phase if that can be synchronized (section 5.1).

    Column 0 is tested as it stands; from column 1 on, phases are held where the rules allow.

    Args:
        table: All sequences.
        window: The schedule; `sequence`, `priority` and `age` of the seat are already set, and
            `playing` is false there. Changed only if the action starts.
        rules: The rules of the planner.
        seat: The seat of the action.
        entry: The phase with which it enters.

    Returns:
        Whether it started. If not, it may be tried again in the next slot.
    """
    keep_window(window)
    if enter_window(table, window, rules, seat, entry):
        return True
    restore_window(window, seat)
    return False


@lean_kernel
def keep_window(window: Window) -> None:
    """Copy the decided columns to the working memory."""
    for column in range(window.results.shape[0]):
        window.spare_results[column] = window.results[column]
        for seat in range(window.playing.shape[0]):
            window.spare_phases[seat, column] = window.phases[seat, column]


@lean_kernel
def restore_window(window: Window, seat: int) -> None:
    """Take the decided columns back from the working memory, without the action of a seat."""
    window.playing[seat] = False
    for column in range(window.results.shape[0]):
        window.results[column] = window.spare_results[column]
        for other in range(window.playing.shape[0]):
            window.phases[other, column] = window.spare_phases[other, column]
