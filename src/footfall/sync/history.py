"""What a synchronizer has played, slot after slot: from it the trace is made."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from footfall.sync.schedule import Schedule
from footfall.sync.shares import slot_seconds
from footfall.sync.tables import ABSENT, Rules, SequenceTable
from footfall.sync.window import Window

__all__ = ["PlayedSlot", "present_slot", "trace_of"]


@dataclass(frozen=True, slots=True)
class PlayedSlot:
    """One slot as it was played; every tuple has one entry an action."""

    phases: tuple[int, ...]
    """Absolute phase index; `ABSENT` while it does not play."""

    result: int
    """What the blend stands on, a value of `Support`."""

    seconds: float | None
    """How long the slot lasts; None where nobody is left who could say."""

    muted: tuple[bool, ...]
    """Whether it plays beside the schedule."""

    waits: tuple[str, ...]
    """Why its start waits; empty unless it does."""


def present_slot(
    table: SequenceTable, window: Window, rules: Rules, waiting: Mapping[int, str]
) -> PlayedSlot:
    """Return the slot being played; action i has seat i, and `waiting` says why some wait."""
    actions = range(len(window.playing))
    return PlayedSlot(
        phases=tuple(int(window.phases[i, 0]) if window.playing[i] else ABSENT for i in actions),
        result=int(window.results[0]),
        seconds=slot_seconds(table, window, rules),
        muted=tuple(bool(window.playing[i] and window.muted[i]) for i in actions),
        waits=tuple(waiting.get(i, "") for i in actions),
    )


def trace_of(
    table: SequenceTable,
    rules: Rules,
    names: Sequence[str],
    priorities: Sequence[float],
    slots: Sequence[PlayedSlot],
) -> Schedule:
    """Return the slots that were played, counted from 0."""
    return Schedule.of(
        table,
        rules,
        range(len(names)),
        names,
        priorities,
        np.array([slot.phases for slot in slots], dtype=np.int64).T,
        np.array([slot.result for slot in slots], dtype=np.int64),
        seconds=[slot.seconds for slot in slots],
        muted=list(zip(*(slot.muted for slot in slots), strict=True)),
        waits=list(zip(*(slot.waits for slot in slots), strict=True)),
        first_slot=0,
    )
