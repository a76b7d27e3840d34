"""One schedule problem played from its first slot to its last, in one compiled call."""

from __future__ import annotations

import math

from footfall.arrays import Flags, Indices, Seconds, Supports, Weights
from footfall.compilation import kernel
from footfall.support import Support
from footfall.sync.columns import own_phase
from footfall.sync.events import enter_next_slot, release_action, start_action
from footfall.sync.planner import REFUSED
from footfall.sync.shares import natural_duration, spend_slot
from footfall.sync.tables import ABSENT, Rules, SequenceTable
from footfall.sync.window import Window
from footfall.timing.weights import slot_duration

__all__ = ["play_commands"]

CONFLICT = int(Support.CONFLICT)
NOT_STARTED = -1


@kernel
def play_commands(
    table: SequenceTable,
    window: Window,
    rules: Rules,
    order: Indices,
    commands: Indices,
    started: Indices,
    rows: Indices,
    muted: Flags,
    results: Supports,
    durations: Seconds,
    shares: Weights,
    natural: Seconds,
) -> int:
    """Play the start commands of a problem, one slot after the other.

    Args:
        table: The sequences; that of action i is row i, and its seat is seat i.
        window: An empty window with the sequences, priorities and weights of the seats.
        rules: The rules of the planner.
        order: The actions, oldest command first, shape (actions,).
        commands: The slot of each start command, shape (actions,).
        started: The slot in which each action started, or -1; written, shape (actions,).
        rows: Each action's phase as an index into its own list, `ABSENT` while it does not
            play; written, shape (actions, slots).
        muted: Whether it is muted there; written, shape (actions, slots).
        results: The combined support of each slot; written, shape (slots,).
        durations: How long each slot lasts; NaN where nobody votes or the
            rule failed; written, shape (slots,).
        shares: Working memory, shape (actions,).
        natural: Working memory, shape (actions,).

    Returns:
        How many slots were played; fewer than asked for if the last of them is a conflict.
    """
    activations = 0
    for slot in range(results.shape[0]):
        if slot > 0:
            spend_slot(table, window)
            enter_next_slot(table, window, rules)
            _release_the_ended(table, window, rules)
        if window.results[0] != CONFLICT:
            for rank in range(order.shape[0]):
                seat = int(order[rank])
                if commands[seat] <= slot and started[seat] == NOT_STARTED:
                    window.age[seat] = activations
                    if start_action(table, window, rules, seat, 0.0) != REFUSED:
                        started[seat] = slot
                        activations += 1
        results[slot] = window.results[0]
        for seat in range(order.shape[0]):
            rows[seat, slot] = _own_index(table, window, rules, seat)
            muted[seat, slot] = window.playing[seat] and window.muted[seat]
        if window.results[0] == CONFLICT:
            durations[slot] = math.nan
            return slot + 1
        durations[slot] = _duration(table, window, rules, shares, natural)
    return results.shape[0]


@kernel
def _own_index(table: SequenceTable, window: Window, rules: Rules, seat: int) -> int:
    if not window.playing[seat]:
        return ABSENT
    return own_phase(table, window.sequence[seat], window.phases[seat, 0], rules.ended)


@kernel
def _release_the_ended(table: SequenceTable, window: Window, rules: Rules) -> None:
    for seat in range(window.playing.shape[0]):
        if window.playing[seat]:
            phase = window.phases[seat, 0]
            if own_phase(table, window.sequence[seat], phase, rules.ended) == ABSENT:
                release_action(table, window, rules, seat)


@kernel
def _duration(
    table: SequenceTable, window: Window, rules: Rules, shares: Weights, natural: Seconds
) -> float:
    """Return how long the slot being played lasts, NaN if nobody says so.

    The default planner has decided it. In paper mode it is the weighted mean (eq. 6), for which
    a phase votes with all of its duration in every slot that it covers.
    """
    if rules.replans:
        return window.durations[0] if window.durations[0] > 0.0 else math.nan
    voters = 0
    for seat in range(window.playing.shape[0]):
        if window.playing[seat]:
            natural[voters] = natural_duration(table, window.sequence[seat], window.phases[seat, 0])
            shares[voters] = window.weight[seat]
            voters += 1
    return slot_duration(shares, natural, voters) if voters > 0 else math.nan
