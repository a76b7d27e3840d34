"""One column of the schedule: what each action stands on, and what all of them stand on."""

from __future__ import annotations

from footfall.compilation import lean_kernel, small_kernel
from footfall.support import Support
from footfall.sync.tables import ABSENT, ENDED_NEUTRAL, Rules, SequenceTable
from footfall.sync.window import Window

__all__ = ["combine_column", "following", "has_ended", "own_phase", "recombine", "support_of"]

FLIGHT = int(Support.FLIGHT)
CONFLICT = int(Support.CONFLICT)


@small_kernel
def support_of(table: SequenceTable, sequence: int, phase: int, ended: int) -> int:
    """Return the support of a sequence at an absolute phase index (section 4.3, figure 6).

    Args:
        table: All sequences.
        sequence: The row of one.
        phase: Absolute index, past the end too, or `ABSENT`.
        ended: What a clamped sequence does after its last phase, as in `Rules`.

    Returns:
        A value of `Support`; for `ABSENT` the neutral one, `SequenceTable.whole`.
    """
    own = own_phase(table, sequence, phase, ended)
    return int(table.supports[table.first[sequence] + own]) if own >= 0 else table.whole


@small_kernel
def own_phase(table: SequenceTable, sequence: int, phase: int, ended: int) -> int:
    """Return an absolute phase index as an index into the sequence's own list.

    Returns:
        The index, or `ABSENT` where the action does not play: it has left the schedule, or it
        has ended and is neutral.
    """
    count = int(table.phase_count[sequence])
    if phase < 0:
        return ABSENT
    if table.cyclic[sequence]:
        return phase % count
    if phase < count:
        return phase
    return ABSENT if ended == ENDED_NEUTRAL else count - 1


@small_kernel
def has_ended(table: SequenceTable, sequence: int, phase: int) -> bool:
    """Return whether a clamped sequence is past its last phase, or has left the schedule."""
    return phase < 0 or (not table.cyclic[sequence] and phase >= table.phase_count[sequence])


@small_kernel
def following(phase: int) -> int:
    """Return the absolute phase index after another one; nothing follows `ABSENT`."""
    return phase + 1 if phase >= 0 else ABSENT


@lean_kernel
def combine_column(table: SequenceTable, window: Window, rules: Rules, column: int) -> bool:
    """Combine the supports of one column (eq. 2) into `window.results`.

    Returns:
        Whether it can be played (eq. 3): whether it is not CONFLICT.
    """
    everybody = table.whole
    on_the_ground = table.whole
    for seat in range(window.playing.shape[0]):
        if window.playing[seat] and not window.muted[seat]:
            support = support_of(
                table, window.sequence[seat], window.phases[seat, column], rules.ended
            )
            everybody &= support
            if support != FLIGHT:
                on_the_ground &= support
    if rules.conflicts_in_flight and on_the_ground == CONFLICT:
        everybody = CONFLICT
    window.results[column] = everybody
    return everybody != CONFLICT


@lean_kernel
def recombine(table: SequenceTable, window: Window, rules: Rules) -> bool:
    """Combine every decided column as it stands; return whether all can be played."""
    playable = True
    for column in range(window.results.shape[0] - 1):
        if not combine_column(table, window, rules, column):
            playable = False
    return playable
