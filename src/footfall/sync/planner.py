"""The default planner: the paper's rule, mended.

Its differences from `footfall.sync.paper` are flags of `Rules`: an ended action is neutral, a
conflict hidden by somebody's flight counts, and a start that would leave nothing but flight is
refused. What needs more than a flag is here: a cyclic action enters at the phase that costs
least, and everything but the slot being played is decided anew at each event.

Another planner takes the place of these four functions: `start_action`, `release_action`,
`reconsider` and `footfall.sync.paper.enter_next_slot`.
"""

from __future__ import annotations

import math
from typing import cast

import numpy as np

from footfall.compilation import kernel
from footfall.support import Support
from footfall.sync.columns import combine_column, has_ended, recombine, support_of
from footfall.sync.paper import (
    enter_window,
    keep_window,
    restore_window,
    synchronize_column,
    try_start,
)
from footfall.sync.shares import column_share, natural_duration
from footfall.sync.tables import Rules, SequenceTable, Window

__all__ = ["REFUSED", "reconsider", "release_action", "start_action", "window_cost"]

REFUSED = -1
"""What `start_action` returns where no entry can be synchronized."""

# A typed number: a literal would have everything that it is passed to compiled twice.
FIRST = cast(int, np.int64(0))
FLIGHT = int(Support.FLIGHT)
LEFT_FOOT = int(Support.LEFT) & ~int(Support.RIGHT)
RIGHT_FOOT = int(Support.RIGHT) & ~int(Support.LEFT)

FLIGHT_PRICE = 3.0
"""A flight cannot be stretched without breaking the laws of motion, so it costs more."""

SAME_COST = 1e-9
"""Costs closer than this are equal, and the first entry is taken."""


@kernel
def start_action(
    table: SequenceTable, window: Window, rules: Rules, seat: int, elapsed: float
) -> int:
    """Start an action now, if it can be synchronized.

    Args:
        table: All sequences.
        window: The schedule; `sequence`, `priority`, `age` and `weight` of the seat are already
            set, and `playing` is false there. Changed only if the action starts; then
            `remaining` of the seat is set too.
        rules: The rules of the planner.
        seat: The seat of the action.
        elapsed: The share of column 0 that is over, in [0, 1); a cyclic action that may enter
            anywhere is taken to enter its phase at the same share.

    Returns:
        The phase with which it entered, or `REFUSED`.
    """
    sequence = window.sequence[seat]
    if not (rules.enters_anywhere and table.cyclic[sequence]):
        if not try_start(table, window, rules, seat, FIRST):
            return REFUSED
        window.remaining[seat] = natural_duration(table, sequence, 0)
        return 0
    best = REFUSED
    least_held = math.inf
    least_stretch = math.inf
    keep_window(window)
    for entry in range(table.phase_count[sequence]):
        if enter_window(table, window, rules, seat, entry):
            own = natural_duration(table, sequence, entry)
            window.remaining[seat] = (1.0 - elapsed) * own
            held, stretch = window_cost(table, window, rules)
            if held < least_held - SAME_COST or (
                held < least_held + SAME_COST and stretch < least_stretch - SAME_COST
            ):
                best, least_held, least_stretch = entry, held, stretch
        restore_window(window, seat)
    if best != REFUSED:
        enter_window(table, window, rules, seat, best)
        window.remaining[seat] = (1.0 - elapsed) * natural_duration(table, sequence, best)
    return best


@kernel
def release_action(table: SequenceTable, window: Window, rules: Rules, seat: int) -> bool:
    """Take an action out, when its leg weight has reached zero; return as `reconsider`."""
    window.playing[seat] = False
    return reconsider(table, window, rules)


@kernel
def reconsider(table: SequenceTable, window: Window, rules: Rules) -> bool:
    """Take note of an event: a priority, an age or a set of running actions has changed.

    The default planner decides columns 1 and later anew; in paper mode the decisions stay and
    only the results follow.

    Returns:
        Whether all decided columns can be played.
    """
    if not rules.replans:
        return recombine(table, window, rules)
    playable = combine_column(table, window, rules, 0)
    for column in range(1, window.results.shape[0] - 1):
        if not synchronize_column(table, window, rules, column):
            playable = False
    return playable


@kernel
def window_cost(table: SequenceTable, window: Window, rules: Rules) -> tuple[float, float]:
    """Return what the decided columns cost: holds first, then stretch and disagreement.

    Holds are counted in shares of the leg weight. The second number is a mean over the columns:
    the weighted |log2| of how much longer or shorter each phase gets than at its clip's own
    speed, plus, for each foot, 4 a (1 - a), where the share a of the weight plants it. Flights
    count `FLIGHT_PRICE` times in both.
    """
    columns = window.results.shape[0] - 1
    held = 0.0
    stretch = 0.0
    for column in range(columns):
        total, clock = _votes(table, window, column)
        if total <= 0.0:
            continue
        left = 0.0
        right = 0.0
        for seat in range(window.playing.shape[0]):
            phase = window.phases[seat, column]
            if not window.playing[seat] or has_ended(table, window.sequence[seat], phase):
                continue
            weight = window.weight[seat] / total
            support = support_of(table, window.sequence[seat], phase, rules.ended)
            price = weight * FLIGHT_PRICE if support == FLIGHT else weight
            own = column_share(table, window, seat, column)
            stretch += price * abs(math.log2(clock / own))
            left += weight if support & LEFT_FOOT else 0.0
            right += weight if support & RIGHT_FOOT else 0.0
            if column > 0 and phase == window.phases[seat, column - 1]:
                held += price
        stretch += 4.0 * (left * (1.0 - left) + right * (1.0 - right))
    return held, stretch / columns


@kernel
def _votes(table: SequenceTable, window: Window, column: int) -> tuple[float, float]:
    """Return the weight of all who have not ended in a column, and how long it lasts (eq. 6)."""
    total = 0.0
    duration = 0.0
    for seat in range(window.playing.shape[0]):
        if window.playing[seat] and not has_ended(
            table, window.sequence[seat], window.phases[seat, column]
        ):
            total += window.weight[seat]
            duration += window.weight[seat] * column_share(table, window, seat, column)
    return total, duration / total if total > 0.0 else 0.0
