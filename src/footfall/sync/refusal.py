"""Why an action waits: the sentence behind a refused start."""

from __future__ import annotations

from collections.abc import Sequence

from footfall.support import Support
from footfall.sync.columns import support_of
from footfall.sync.paper import enter_window
from footfall.sync.tables import Rules, SequenceTable, Window

__all__ = ["explain_refusal"]


def explain_refusal(
    table: SequenceTable, window: Window, rules: Rules, seat: int, names: Sequence[str]
) -> str | None:
    """Say why an action cannot start in the slot being played.

    Args:
        table: All sequences.
        window: The schedule, as `footfall.sync.planner.start_action` takes it. Not changed.
        rules: The rules of the planner.
        seat: The seat of the action.
        names: What the action of each seat is called.

    Returns:
        A sentence such as ``waits: L of 'hop' conflicts with R of 'walk'``, or None if it can
        start now.
    """
    sequence = int(window.sequence[seat])
    anywhere = rules.enters_anywhere and bool(table.cyclic[sequence])
    conflict: str | None = None
    flight: str | None = None
    for entry in range(int(table.phase_count[sequence]) if anywhere else 1):
        trial = window.copy()
        if enter_window(table, trial, rules, seat, entry):
            return None
        column = _conflicting_column(trial)
        if column is None:
            slots = trial.results.shape[0]
            flight = f"with {names[seat]!r} no foot would touch the ground for {slots} slots"
        elif conflict is None:
            conflict = _conflict(table, trial, rules, seat, names, column)
    return "waits: " + "; ".join(reason for reason in (conflict, flight) if reason is not None)


def _conflicting_column(trial: Window) -> int | None:
    """Return the first column in conflict; columns after it were not tried."""
    for column, result in enumerate(trial.results):
        if result == Support.CONFLICT:
            return column
    return None


def _conflict(
    table: SequenceTable,
    trial: Window,
    rules: Rules,
    seat: int,
    names: Sequence[str],
    column: int,
) -> str:
    seats = [int(other) for other in trial.playing.nonzero()[0]]
    supports = {
        other: Support(
            support_of(
                table, int(trial.sequence[other]), int(trial.phases[other, column]), rules.ended
            )
        )
        for other in seats
    }
    left = [other for other in seats if supports[other] is Support.LEFT]
    right = [other for other in seats if supports[other] is Support.RIGHT]
    own, against = (left, right) if seat in left else (right, left)
    one = seat if seat in own else own[0]
    when = {0: "", 1: "in the next slot "}.get(column, f"{column} slots later ")
    verb = "would conflict" if column else "conflicts"
    return (
        f"{when}{supports[one].symbol} of {names[one]!r} {verb} with "
        f"{supports[against[0]].symbol} of {names[against[0]]!r}"
    )
