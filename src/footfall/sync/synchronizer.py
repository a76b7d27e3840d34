"""Synchronizer: start, stop and step through the slots of one character, without a clock.

It drives the kernels of the real-time engine on sequences alone, for texts, tests and traces.
"""

from __future__ import annotations

from collections.abc import Sequence

from footfall.errors import ArgumentError
from footfall.support import Support, SupportSequence
from footfall.sync.columns import own_phase
from footfall.sync.events import enter_next_slot, reconsider, release_action, start_action
from footfall.sync.history import PlayedSlot, present_slot, trace_of
from footfall.sync.planner import REFUSED
from footfall.sync.refusal import Refusal, explain_refusal, foresee
from footfall.sync.schedule import Schedule
from footfall.sync.shares import spend_slot
from footfall.sync.tables import (
    ABSENT,
    Ended,
    Planner,
    SequenceTable,
    StartPolicy,
    check_limbs,
    check_registration,
    rules_of,
)
from footfall.sync.window import Window

__all__ = ["Synchronizer"]


class Synchronizer:
    """The schedule of some actions, each known by its index.

    Slot 0 is being played from the beginning, by nobody.

    Raises:
        ArgumentError: If there is no sequence, a count does not match, or an option is unknown.
        SupportSequenceError: If a sequence cannot be synchronized with any other.
    """

    def __init__(
        self,
        sequences: Sequence[SupportSequence],
        priorities: Sequence[float] | None = None,
        *,
        names: Sequence[str] | None = None,
        lookahead: int = 5,
        planner: Planner = "footfall",
        start_policy: StartPolicy = "extend",
        ended: Ended | None = None,
        falls_back: bool = False,
    ) -> None:
        if not sequences:
            raise ArgumentError("no sequence; a synchronizer needs at least one")
        for sequence in sequences:
            check_registration(sequence)
        check_limbs(sequences, planner)
        count = len(sequences)
        ranks = [float(count - i) for i in range(count)] if priorities is None else priorities
        self.names = tuple(names) if names is not None else tuple(str(i) for i in range(count))
        if len(ranks) != count or len(self.names) != count:
            raise ArgumentError(
                f"{count} sequences, {len(ranks)} priorities and {len(self.names)} names; "
                "give one of each for every action"
            )
        self._table = SequenceTable.of(sequences)
        self._window = Window.empty(count, lookahead)
        self._window.sequence[:] = range(count)
        self._window.priority[:] = ranks
        self._window.weight[:] = ranks
        self._rules = rules_of(
            planner, start_policy=start_policy, ended=ended, falls_back=falls_back
        )
        self._waiting: dict[int, str] = {}
        self._activations = 0
        self._past: list[PlayedSlot] = []

    @property
    def slot(self) -> int:
        """The number of the slot being played."""
        return len(self._past)

    @property
    def result(self) -> Support:
        """What the blend stands on in the slot being played."""
        return Support(int(self._window.results[0]))

    @property
    def playing(self) -> tuple[int, ...]:
        """The actions that take part in the schedule."""
        return tuple(int(action) for action in self._window.playing.nonzero()[0])

    @property
    def muted(self) -> tuple[int, ...]:
        """Those of `playing` that play beside the schedule, for want of room (S-19)."""
        return tuple(action for action in self.playing if self._window.muted[action])

    @property
    def waiting(self) -> dict[int, str]:
        """Each action whose start is delayed, oldest command first, and why it waits."""
        return dict(self._waiting)

    def start(self, action: int) -> bool:
        """Command an action to start; what cannot start now is tried again in every slot.

        Returns:
            Whether it started now. A running or waiting action is left as it is.
        """
        self._check(action)
        if self._window.playing[action]:
            return True
        return action not in self._waiting and self._try(action)

    def foresee(self, action: int) -> Refusal | None:
        """Say for what a waiting action waits and how long; None if it does not wait."""
        self._check(action)
        if action not in self._waiting:
            return None
        return foresee(self._table, self._window, self._rules, action, self.names)

    def stop(self, action: int) -> None:
        """Take an action out of the schedule now, or cancel its waiting start."""
        self._check(action)
        self._waiting.pop(action, None)
        if self._window.playing[action]:
            release_action(self._table, self._window, self._rules, action)

    def set_priority(self, action: int, priority: float) -> None:
        """Change a priority; the default planner decides all coming slots anew."""
        self._check(action)
        self._window.priority[action] = priority
        self._window.weight[action] = priority
        reconsider(self._table, self._window, self._rules)

    def next_slot(self) -> Support:
        """Enter the next slot, then try the waiting starts again, oldest command first.

        Returns:
            What the blend stands on there; CONFLICT if the rule failed.

        Raises:
            ArgumentError: If the rule failed in the slot before.
        """
        if self.result is Support.CONFLICT:
            raise ArgumentError(
                f"the rule failed in slot {self.slot}, so no slot follows it; "
                "stop an action that has ended"
            )
        self._past.append(self._present())
        spend_slot(self._table, self._window)
        enter_next_slot(self._table, self._window, self._rules)
        self._deactivate_the_ended()
        if self._window.results[0] != Support.CONFLICT:
            for action in tuple(self._waiting):
                self._try(action)
        return self.result

    @property
    def schedule(self) -> Schedule:
        """The slot being played and those already decided after it."""
        return Schedule.of_window(self._table, self._window, self._rules, self.names)

    @property
    def trace(self) -> Schedule:
        """All slots from 0 to the one being played, with all that was decided in them."""
        priorities = [float(priority) for priority in self._window.priority]
        slots = [*self._past, self._present()]
        return trace_of(self._table, self._rules, self.names, priorities, slots)

    def _present(self) -> PlayedSlot:
        return present_slot(self._table, self._window, self._rules, self._waiting)

    def _try(self, action: int) -> bool:
        table, window, rules = self._table, self._window, self._rules
        window.age[action] = self._activations
        if start_action(table, window, rules, action, 0.0) == REFUSED:
            self._waiting[action] = str(explain_refusal(table, window, rules, action, self.names))
            return False
        self._waiting.pop(action, None)
        self._activations += 1
        return True

    def _deactivate_the_ended(self) -> None:
        table, window, rules = self._table, self._window, self._rules
        for action in self.playing:
            if own_phase(table, action, int(window.phases[action, 0]), rules.ended) == ABSENT:
                release_action(table, window, rules, action)

    def _check(self, action: int) -> None:
        if not 0 <= action < len(self.names):
            raise ArgumentError(f"no action {action}; there are 0 to {len(self.names) - 1}")
