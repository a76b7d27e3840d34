"""Between the engine and the planner: what is left of every phase, and what to make of a plan."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import numpy.typing as npt

from footfall.compilation import inlined_kernel, inner_kernel
from footfall.engine.durations import rebuild_warps, set_target, update_weights
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf, phase_end
from footfall.sync.columns import has_ended
from footfall.sync.planner import plan
from footfall.sync.search_memory import PlannerMemory
from footfall.sync.tables import Rules
from footfall.sync.window import Window

__all__ = ["copy_window", "follow_plan", "measure_remaining", "replan", "window_of"]

# A typed number: a literal would have everything that it is passed to compiled twice.
PRESENT = cast(int, np.int64(0))

SHORTEST_REST = 1e-3
"""The least that is taken to be left of a phase [s]."""


@inner_kernel
def window_of(me: Character, search: PlannerMemory) -> Window:
    """Return the synchronizer's window on one character, without a copy.

    The slices make plain arrays of a record's own, so that what is compiled for the engine is
    also what Python calls.
    """
    return Window(
        me.playing[:],
        me.action[:],
        me.priority[:],
        me.age[:],
        me.weight[:],
        me.remaining[:],
        me.held[:],
        me.muted[:],
        me.phases[:],
        me.results[:],
        me.durations[:],
        me.pace[:],
        me.slot_offset[:],
        me.steady[:],
        search.search,
        search.spare_phases,
        search.spare_results,
    )


def copy_window(character: npt.NDArray[Any], search: PlannerMemory) -> Window:
    """Return a copy of the synchronizer's window on one character, as it is now.

    Args:
        character: One record of `character_type`.
        search: Any working memory of the planner.
    """
    shared = search._asdict()
    renamed = {"offset": "slot_offset", "sequence": "action"}
    fields = [
        shared[name] if name in shared else character[renamed.get(name, name)]
        for name in Window._fields
    ]
    window = Window._make(fields).copy()
    left = (1.0 - float(character["slot_progress"])) * float(character["slot_duration"])
    window.durations[0] = left
    return window


@inner_kernel
def measure_remaining(shelf: Shelf, me: Character, column: int) -> None:
    """Set what is left of the phases of a column, and find the phase that a muted action is in.

    Args:
        shelf: The library.
        me: The character.
        column: 0 in the middle of a slot, 1 where the next one is about to be entered.
    """
    if column == PRESENT:
        # What has passed since the last plan is over.
        rest = (1.0 - me.slot_progress) * me.slot_duration
        me.steady[0] += max(me.durations[0] - rest, 0.0)
        me.durations[0] = rest
    for seat in range(SEATS):
        if not me.playing[seat]:
            continue
        entry = shelf.entries[me.action[seat]]
        if me.muted[seat]:
            phase = me.phases[seat, 0]
            while (
                not has_ended(shelf.table, me.action[seat], phase)
                and phase_end(entry, shelf.phase_starts, phase) <= me.clip_time[seat]
            ):
                phase += 1
            me.phases[seat, column] = phase
        phase = me.phases[seat, column]
        if not has_ended(shelf.table, me.action[seat], phase):
            left = phase_end(entry, shelf.phase_starts, phase) - me.clip_time[seat]
            me.remaining[seat] = max(left, SHORTEST_REST)


@inner_kernel
def follow_plan(shelf: Shelf, me: Character) -> None:
    """Let every clip go as far in this slot as has been decided."""
    me.slot_offset[0] /= 1.0 - me.slot_progress
    for seat in range(SEATS):
        if me.playing[seat]:
            set_target(shelf, me, seat)
    update_weights(me)
    rebuild_warps(shelf, me)


@inlined_kernel
def replan(shelf: Shelf, me: Character, search: PlannerMemory, rules: Rules) -> None:
    """Decide anew after a stop or a change of priority; in paper mode all stays as decided."""
    me.unsettled = False
    update_weights(me)
    if rules.replans and me.synchronized and me.slot_progress < 1.0:
        measure_remaining(shelf, me, PRESENT)
        plan(shelf.table, window_of(me, search), rules)
        follow_plan(shelf, me)
