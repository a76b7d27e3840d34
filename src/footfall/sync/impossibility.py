"""Whether an action can ever start beside those that run: all joint states are explored.

A state is the phase of every action; from one to the next any of them may go on. If no state in
which the new action could enter leads to one in which anything touches the ground, no planner
and no patience help: right hop and left hop (section 6).
"""

from __future__ import annotations

from itertools import product

from footfall.support import Support
from footfall.sync.columns import has_ended, support_of
from footfall.sync.tables import Rules, SequenceTable
from footfall.sync.window import Window

__all__ = ["states_without_ground"]

MOST_STATES = 20_000
"""More joint states than this are not explored: nothing is proved then."""

State = tuple[int, ...]


def states_without_ground(
    table: SequenceTable, window: Window, rules: Rules, seat: int
) -> int | None:
    """Return how many joint states prove that an action can never start, or None if it may.

    Args:
        table: All sequences.
        window: The schedule.
        rules: The rules of the default planner.
        seat: The seat of the action, which does not play.
    """
    seats = [
        int(other)
        for other in window.playing.nonzero()[0]
        if other != seat and not window.muted[other]
    ]
    sequences = [int(window.sequence[other]) for other in (*seats, seat)]
    ending = any(not table.cyclic[sequence] for sequence in sequences[:-1])
    counts = [int(table.phase_count[sequence]) for sequence in sequences]
    states = 1
    for count in counts:
        states *= count
    if not seats or ending or states > MOST_STATES:
        return None
    entries = range(counts[-1] if table.cyclic[sequences[-1]] else 1)
    reached: set[State] = {
        (*phases, entry)
        for phases in product(*(range(count) for count in counts[:-1]))
        for entry in entries
        if _blend(table, rules, sequences, (*phases, entry)) is not Support.CONFLICT
    }
    waiting = list(reached)
    while waiting:
        state = waiting.pop()
        if _blend(table, rules, sequences, state) is not Support.FLIGHT:
            return None
        for following in _next_states(table, sequences, state):
            playable = _blend(table, rules, sequences, following) is not Support.CONFLICT
            if playable and following not in reached:
                reached.add(following)
                waiting.append(following)
    return states


def _next_states(table: SequenceTable, sequences: list[int], state: State) -> list[State]:
    """Return what may follow a state: each action goes on or waits."""
    choices = [
        (phase, _after(table, sequence, phase))
        for sequence, phase in zip(sequences, state, strict=True)
    ]
    return [following for following in product(*choices) if following != state]


def _after(table: SequenceTable, sequence: int, phase: int) -> int:
    if has_ended(table, sequence, phase):
        return phase
    return (phase + 1) % int(table.phase_count[sequence]) if table.cyclic[sequence] else phase + 1


def _blend(table: SequenceTable, rules: Rules, sequences: list[int], state: State) -> Support:
    """Return what a state stands on; CONFLICT also where somebody's flight hides one (S-6)."""
    supports = [
        support_of(table, sequence, phase, rules.ended)
        for sequence, phase in zip(sequences, state, strict=True)
    ]
    grounded = int(table.whole)
    for support in supports:
        if support != Support.FLIGHT:
            grounded &= support
    if grounded == Support.CONFLICT:
        return Support.CONFLICT
    return Support.FLIGHT if Support.FLIGHT in supports else Support(grounded)
