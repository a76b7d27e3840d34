"""Why an action waits: the sentence behind a refused start."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from footfall.arrays import Indices
from footfall.support import Support
from footfall.sync.columns import combine_column, support_of
from footfall.sync.events import foresee_start, try_entry
from footfall.sync.impossibility import states_without_ground
from footfall.sync.paper import enter_window
from footfall.sync.planner import ENTERS, NO_ROOM, ON_THE_OTHER_FOOT
from footfall.sync.tables import Rules, SequenceTable
from footfall.sync.window import Window

__all__ = ["Refusal", "explain_refusal", "foresee"]

FARTHEST = 10.0
"""How far a start is foreseen [s]."""


@dataclass(frozen=True, slots=True)
class Refusal:
    """Why an action does not start now, and when it will."""

    reason: str
    """A sentence, such as ``waits for 'walk' R→D, 0.31 s: L of 'hop' conflicts with R of
    'walk'``."""

    seconds: float | None
    """How long it will wait if no other command comes [s]; None if longer than can be foreseen,
    or for ever."""

    impossible: bool
    """Whether it is proved that it can never start beside those that run."""


def foresee(
    table: SequenceTable,
    window: Window,
    rules: Rules,
    seat: int,
    names: Sequence[str],
    *,
    elapsed: float = 0.0,
) -> Refusal | None:
    """Say why an action waits, for what and how long.

    Args:
        table: All sequences.
        window: The schedule, its `remaining` and `durations` from now on. Not changed.
        rules: The rules of the planner.
        seat: The seat of the action.
        names: What the action of each seat is called.
        elapsed: The share of the slot being played that is over.

    Returns:
        The refusal, or None if it can start now.
    """
    reason = explain_refusal(table, window, rules, seat, names, elapsed=elapsed)
    if reason is None:
        return None
    why = reason.removeprefix("waits: ")
    states = states_without_ground(table, window, rules, seat) if rules.replans else None
    if states is not None:
        running = " and ".join(
            repr(names[int(other)]) for other in window.playing.nonzero()[0] if other != seat
        )
        proof = (
            f"impossible beside {running}: in none of their {states} joint phases does anything "
            "touch the ground"
        )
        return Refusal(f"{proof}; {why}", None, True)
    trial = window.copy()
    before = np.zeros(len(trial.playing), dtype=np.int64)
    slots, seconds = foresee_start(table, trial, rules, seat, FARTHEST, before)
    if slots < 0:
        return Refusal(f"waits for more than {FARTHEST:g} s: {why}", None, False)
    change = _change(table, trial, rules, seat, names, before)
    return Refusal(f"waits for {change}, {seconds:.2f} s: {why}", seconds, False)


def _change(
    table: SequenceTable,
    trial: Window,
    rules: Rules,
    seat: int,
    names: Sequence[str],
    before: Indices,
) -> str:
    """Say whose support changed as the action could start, the first in order of priority."""
    order = sorted(range(len(before)), key=lambda other: -float(trial.priority[other]))
    for other in order:
        if other != seat and before[other] >= 0 and trial.phases[other, 0] != before[other]:
            one, after = (
                Support(support_of(table, int(trial.sequence[other]), int(phase), rules.ended))
                for phase in (before[other], trial.phases[other, 0])
            )
            return f"{names[other]!r} {one.symbol}→{after.symbol}"
    return "the next slot"


def explain_refusal(
    table: SequenceTable,
    window: Window,
    rules: Rules,
    seat: int,
    names: Sequence[str],
    *,
    elapsed: float = 0.0,
) -> str | None:
    """Say why an action cannot start in the slot being played.

    Args:
        table: All sequences.
        window: The schedule, as `footfall.sync.planner.start_action` takes it. Not changed.
        rules: The rules of the planner.
        seat: The seat of the action.
        names: What the action of each seat is called.
        elapsed: The share of the slot that is over.

    Returns:
        A sentence such as ``waits: L of 'hop' conflicts with R of 'walk'``, or None if it can
        start now.
    """
    if rules.replans:
        return _explain_plan(table, window, rules, seat, names, elapsed)
    trial = window.copy()
    if enter_window(table, trial, rules, seat, 0):
        return None
    column = _conflicting_column(trial)
    assert column is not None
    return f"waits: {_conflict(table, trial, rules, seat, names, column)}"


def _explain_plan(
    table: SequenceTable,
    window: Window,
    rules: Rules,
    seat: int,
    names: Sequence[str],
    elapsed: float,
) -> str | None:
    """Say why the default planner refuses a start: one reason of each kind."""
    sequence = int(window.sequence[seat])
    reasons: dict[int, str] = {}
    for entry in range(int(table.phase_count[sequence]) if table.cyclic[sequence] else 1):
        trial = window.copy()
        verdict, _ = try_entry(table, trial, rules, seat, entry, elapsed)
        if verdict == ENTERS:
            return None
        if verdict == ON_THE_OTHER_FOOT and verdict not in reasons:
            trial.playing[seat] = True
            trial.phases[seat, 0] = entry
            combine_column(table, trial, rules, 0)
            reasons[verdict] = _conflict(table, trial, rules, seat, names, 0)
        elif verdict == NO_ROOM:
            reasons[verdict] = (
                f"beside {names[seat]!r} somebody would be held too long, or have to run at less "
                "than 0.4 or more than 2.5 times its own speed"
            )
        elif verdict not in reasons:
            reasons[verdict] = f"with {names[seat]!r} no foot would touch the ground"
    return "waits: " + "; ".join(reasons[kind] for kind in sorted(reasons))


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
    against = [
        other
        for other in seats
        if other != seat and int(supports[other]) & int(supports[seat]) == Support.CONFLICT
    ]
    one = seat
    if supports[seat] is Support.FLIGHT or not against:
        one, against = _first_conflict(seats, supports)
    when = {0: "", 1: "in the next slot "}.get(column, f"{column} slots later ")
    verb = "would conflict" if column else "conflicts"
    return (
        f"{when}{supports[one].symbol} of {names[one]!r} {verb} with "
        f"{supports[against[0]].symbol} of {names[against[0]]!r}"
    )


def _first_conflict(seats: Sequence[int], supports: Mapping[int, Support]) -> tuple[int, list[int]]:
    """Return one action on the ground, and those before it that it cannot go with."""
    together = -1
    for place, one in enumerate(seats):
        if supports[one] is not Support.FLIGHT:
            together &= int(supports[one])
            if together == Support.CONFLICT:
                return one, [
                    other for other in seats[:place] if supports[other] is not Support.FLIGHT
                ][-1:]
    raise AssertionError("no conflict")
