"""What a character is doing, as plain values: for viewers and for tests. It changes nothing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from footfall.engine.planning import copy_window
from footfall.engine.record import SEATS
from footfall.engine.state import EMPTY, LEAVING, RUNNING, WAITING
from footfall.skeleton import BodyPart
from footfall.support import Support
from footfall.sync.schedule import Schedule

if TYPE_CHECKING:
    from footfall.engine.crowd import Crowd

__all__ = [
    "ActionState",
    "Activity",
    "PlannedSlot",
    "action_states",
    "planned_slots",
    "present_schedule",
]

Activity = Literal["idle", "waiting", "fading in", "running", "fading out"]
"""What an action does."""


@dataclass(frozen=True, slots=True)
class ActionState:
    """What one action of a character does now."""

    activity: Activity
    """Whether it plays, waits or fades."""

    weights: tuple[float, ...] = (0.0,) * len(BodyPart)
    """Its share of each body part, in the order of `BodyPart`."""

    progress: float = 0.0
    """How far its present fade is on the legs, 0 to 1; 1 where none is on."""

    clip_time: float = 0.0
    """Where its clip is, past its end too [s]."""

    rate: float = 0.0
    """Clip time per clock time."""

    phase: int | None = None
    """Absolute index of the phase it plays; None while it is not synchronized."""

    support: Support | None = None
    """What that phase stands on; None while it is not synchronized."""

    held: bool = False
    """Whether that phase goes on in the next slot, so that it is made to wait."""

    reason: str = ""
    """What it waits for; empty unless it does."""


@dataclass(frozen=True, slots=True)
class PlannedSlot:
    """A slot that is decided."""

    start: float
    """Clock time at which it begins at the present weights; of the first one, began [s]."""

    duration: float
    """How long it lasts at the present weights [s]."""

    result: Support
    """What the blend stands on."""

    supports: tuple[Support | None, ...]
    """What each action of the library stands on; None where it does not play."""

    held: tuple[bool, ...]
    """Whether each action repeats there the phase of the slot before."""


def action_states(crowd: Crowd, row: int = 0) -> tuple[ActionState, ...]:
    """Return what each action of the library does, for one character of a crowd."""
    return tuple(_state(crowd, row, action) for action in range(len(crowd.library.actions)))


def present_schedule(crowd: Crowd, row: int = 0) -> Schedule:
    """Return the decided slots of one character: a printable copy (figures 7 to 9)."""
    me: Any = crowd.characters[row]
    actions = crowd.library.actions
    names = [actions[int(me["action"][seat])].name for seat in range(SEATS)]
    return Schedule.of_window(crowd.shelf.table, copy_window(me, crowd.search), crowd.rules, names)


def planned_slots(crowd: Crowd, row: int = 0) -> tuple[PlannedSlot, ...]:
    """Return the decided slots of one character, with their times at the present weights.

    The present slot lasts what it lasts; those to come the weighted mean of what their phases
    last by themselves (eq. 6), a phase that is held being split over its slots.
    """
    me: Any = crowd.characters[row]
    seats = [seat for seat in range(SEATS) if me["playing"][seat]]
    if not seats or not me["slot_duration"] > 0.0:
        return ()
    first = float(me["slot_duration"])
    start = float(me["clock"]) - float(me["slot_progress"]) * first
    slots: list[PlannedSlot] = []
    for column in range(len(me["results"]) - 1):
        duration = _natural_duration(crowd, me, seats, column) if column else first
        supports: list[Support | None] = [None] * len(crowd.library.actions)
        held = [False] * len(supports)
        for seat in seats:
            action, phase = int(me["action"][seat]), int(me["phases"][seat, column])
            supports[action] = _support(crowd, action, phase)
            held[action] = column > 0 and phase == int(me["phases"][seat, column - 1])
        result = Support(int(me["results"][column]))
        slots.append(PlannedSlot(start, duration, result, tuple(supports), tuple(held)))
        start += duration
    return tuple(slots)


def _state(crowd: Crowd, row: int, action: int) -> ActionState:
    me: Any = crowd.characters[row]
    mine = (me["action"] == action) & (me["status"] != EMPTY)
    seats = np.flatnonzero(mine)
    if not len(seats):
        return ActionState("idle")
    # An ended action may still fade out beside its new start: the latest tells what it does.
    seat = int(seats[me["age"][seats].argmax()])
    status, progress = int(me["status"][seat]), float(me["fade_progress"][seat, 0])
    if status == WAITING:
        return ActionState("waiting", reason=crowd.refusal(action, row).reason)
    fading: Activity = "fading in" if progress < 1.0 else "running"
    phase = int(me["phases"][seat, 0]) if me["playing"][seat] else None
    return ActionState(
        activity="fading out" if status == LEAVING else fading,
        weights=tuple(me["weights"][seats[me["status"][seats] >= RUNNING]].sum(axis=0).tolist()),
        progress=min(progress, 1.0),
        clip_time=float(me["clip_time"][seat]),
        rate=float(me["rate"][seat]),
        phase=phase,
        support=None if phase is None else _support(crowd, action, phase),
        held=phase is not None and phase == int(me["phases"][seat, 1]),
    )


def _support(crowd: Crowd, action: int, phase: int) -> Support | None:
    """Return the support of an absolute phase index; None where the action has ended."""
    supports = crowd.supports_of(action)
    if phase < 0 or (not supports.cyclic and phase >= len(supports.phases)):
        return None
    return supports.at(phase).support


def _natural_duration(crowd: Crowd, me: Any, seats: list[int], column: int) -> float:
    """Return the weighted mean of what the phases of a column last by themselves [s]."""
    total = shared = 0.0
    for seat in seats:
        action, phase = int(me["action"][seat]), int(me["phases"][seat, column])
        if _support(crowd, action, phase) is None:
            continue
        columns = int((me["phases"][seat, :-1] == phase).sum())
        own = crowd.supports_of(action).at(phase).duration / columns
        weight = max(float(me["weights"][seat, BodyPart.LEGS]), 1e-6)
        total, shared = total + weight * own, shared + weight
    return total / shared if shared > 0.0 else 0.1
