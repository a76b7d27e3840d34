"""Parameters of a crowd's actions: where they are on their way, and the mixes that follow them.

A mix is worked out anew while a parameter moves, and written over the old one in the crowd's own
shelf. Every clip of it keeps its place: the same share of the same phase (S-17).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.actions import CycleMix
from footfall.arrays import Seconds
from footfall.compilation import kernel
from footfall.engine.action import Action
from footfall.engine.record import SEATS, Character
from footfall.engine.shelf import Shelf
from footfall.engine.sole_keys import sole_keys_of
from footfall.engine.state import EMPTY, RUNNING
from footfall.errors import ArgumentError
from footfall.skeleton.normalized import by_component
from footfall.support import Support, SupportSequence

__all__ = ["FINEST", "Parameters", "Parts", "keep_places"]

ACCELERATION = 1.5
"""How fast a speed follows what is asked for [m/s²]."""

TURNING = 2.5
"""How fast a turn does [rad/s²]."""

FINEST = 1.0 / 60.0
"""Time between two mixes [s]."""

Parts = Sequence[tuple[Shelf, npt.NDArray[Any]]]
"""All characters that an action's parameters move: the library as their body takes it, and their
records, shape (rows,); one body after the other."""


@dataclass(frozen=True, slots=True)
class _Value:
    """The parameters of one action."""

    now: tuple[float, float]
    """Speed [m/s] and turn [rad/s]."""

    asked: tuple[float, float]
    """Where they go."""

    supports: SupportSequence
    """What the action stands on at them."""

    def after(self, dt: float) -> tuple[float, float]:
        """Return the parameters a time [s] later."""
        most = (ACCELERATION * dt, TURNING * dt)
        speed, turn = (
            now + min(max(asked - now, -step), step)
            for now, asked, step in zip(self.now, self.asked, most, strict=True)
        )
        return speed, turn


class Parameters:
    """The speeds and turns of one crowd; all its characters share them."""

    def __init__(self) -> None:
        """Begin with every action as the library has it."""
        self._values: dict[int, _Value] = {}

    @property
    def moving(self) -> bool:
        """Whether a parameter is on its way."""
        return bool(self._values) and any(
            value.now != value.asked for value in self._values.values()
        )

    def of(self, action: Action, index: int) -> tuple[float, float]:
        """Return the speed [m/s] and the turn [rad/s] that an action has now."""
        return self._values[index].now if index in self._values else action.parameters

    def supports(self, action: Action, index: int) -> SupportSequence:
        """Return what an action stands on at its present parameters."""
        return self._values[index].supports if index in self._values else action.supports

    def ask(
        self,
        shelf: Shelf,
        parts: Parts,
        action: Action,
        index: int,
        asked: tuple[float | None, float | None],
    ) -> None:
        """Ask for a speed and a turn; where nobody performs the action, it has them at once.

        Raises:
            ArgumentError: If the action has no parameters, or its clips do not reach one.
        """
        if action.locomotion is None:
            raise ArgumentError(
                f"{action.name!r} is one clip and has no parameters; add_locomotion makes an "
                "action of several"
            )
        value = self._values.get(index) or _Value(
            action.parameters, action.parameters, action.supports
        )
        goal = action.locomotion.checked(*asked, default=value.asked)
        self._values[index] = _Value(value.now, goal, value.supports)
        if not any(
            ((part["action"] == index) & (part["status"] != EMPTY)).any() for _, part in parts
        ):
            self._move(shelf, parts, action, index, goal)

    def advance(self, shelf: Shelf, parts: Parts, actions: Sequence[Action], dt: float) -> None:
        """Let every parameter go on its way for a time [s]."""
        for index, value in list(self._values.items()):
            if value.now != value.asked:
                self._move(shelf, parts, actions[index], index, value.after(dt))

    def write(self, shelf: Shelf, parts: Parts, actions: Sequence[Action]) -> None:
        """Write every mix into a new shelf."""
        for index, value in list(self._values.items()):
            self._move(shelf, parts, actions[index], index, value.now)

    def snapshot(self, shelf: Shelf, actions: Sequence[Action]) -> dict[str, npt.NDArray[Any]]:
        """Return where every parameter is, where it goes, and what its mix stands on.

        Returns:
            "values": speed and turn now, and as asked for, as the library has them where nothing
            was asked for, shape (actions, 4); "supports": of each phase, shape (phases,).
        """
        values = [
            [*self.of(action, index), *(self._values[index].asked if index in self._values else ())]
            for index, action in enumerate(actions)
        ]
        told = [value if len(value) == 4 else 2 * value for value in values]
        return {"values": np.array(told), "supports": np.array(shelf.table.supports)}

    def restore(
        self,
        shelf: Shelf,
        parts: Parts,
        actions: Sequence[Action],
        told: Mapping[str, npt.NDArray[Any]],
    ) -> None:
        """Go back to what `snapshot` told, and write every mix as it was."""
        first = 0
        for index, action in enumerate(actions):
            kinds = told["supports"][first : first + len(action.supports.phases)].tolist()
            first += len(kinds)
            speed, turn, *asked = told["values"][index].tolist()
            if action.locomotion is not None:
                kept = {phase: Support(kind) for phase, kind in enumerate(kinds)}
                mix = action.locomotion.mix(speed, turn, kept=kept)
                self._values[index] = _Value((speed, turn), (asked[0], asked[1]), mix.supports)
                _write_mix(shelf, parts, index, mix)

    def _move(
        self,
        shelf: Shelf,
        parts: Parts,
        action: Action,
        index: int,
        now: tuple[float, float],
    ) -> None:
        assert action.locomotion is not None
        value = self._values[index]
        mix = action.locomotion.mix(*now, kept=_kept(parts, index, value.supports))
        self._values[index] = _Value(now, value.asked, mix.supports)
        old = np.array(value.supports.boundaries)
        _write_mix(shelf, parts, index, mix)
        for _, part in parts:
            keep_places(part, index, old, np.array(mix.supports.boundaries))


def _kept(parts: Parts, index: int, supports: SupportSequence) -> dict[int, Support]:
    """Return the supports of the phases that are being played.

    Of one character: a crowd plays all of them at any time, and each of its characters has the
    support of its present slot in its own record.
    """
    if sum(len(part) for _, part in parts) > 1:
        return {}
    me = parts[0][1][0]
    playing = (me["action"] == index) & (me["playing"] != 0)
    count = len(supports.phases)
    phases = {int(phase) % count for phase in me["phases"][playing, 0]}
    return {phase: supports.phases[phase].support for phase in phases}


def _write_mix(shelf: Shelf, parts: Parts, index: int, mix: CycleMix) -> None:
    """Write a mix over the old one of the same action."""
    entry: Any = shelf.entries[index]
    first, count = int(entry["first_frame"]), int(entry["frame_count"])
    shelf.keys[first : first + count] = by_component(mix.keys, shelf.joints)
    frames = slice(first, first + count)
    for own in (shelf, *(part for part, _ in parts)):
        own.sole_keys[frames] = sole_keys_of(shelf.keys[frames], shelf.joints, own.points)
    shelf.roots[first : first + count] = mix.roots
    entry["duration"] = mix.supports.duration
    entry["fps"] = (count - 1) / mix.supports.duration
    rows = slice(int(entry["phase_first"]), int(entry["phase_first"] + entry["phase_count"]))
    shelf.phase_starts[rows] = mix.supports.boundaries[:-1]
    shelf.table.supports[rows] = [int(phase.support) for phase in mix.supports.phases]
    shelf.table.durations[rows] = [phase.duration for phase in mix.supports.phases]


@kernel
def keep_places(characters: npt.NDArray[Any], action: int, old: Seconds, new: Seconds) -> None:
    """Leave every clip of an action at the same share of the same phase.

    Args:
        characters: Records of `character_type`, shape (rows,).
        action: Which action.
        old: Boundaries of its phases before [s], shape (phases + 1,), from 0 on.
        new: Its boundaries now.
    """
    for row in range(characters.shape[0]):
        me: Character = characters[row]
        for seat in range(SEATS):
            if me.status[seat] < RUNNING or me.action[seat] != action:
                continue
            me.clip_time[seat], pace = _moved(old, new, me.clip_time[seat])
            me.posed_time[seat] = _moved(old, new, me.posed_time[seat])[0]
            me.target[seat] = _moved(old, new, me.target[seat])[0]
            me.rate[seat] *= pace
            me.natural[seat] *= pace
            me.segment[seat, 0] = _moved(old, new, me.segment[seat, 0])[0]
            for end in range(2):
                me.segment[seat, 1 + end] *= pace
            me.unsettled = True


@kernel
def _moved(old: Seconds, new: Seconds, time: float) -> tuple[float, float]:
    """Return the time of the same place in another mix, and how fast time goes there."""
    last = old.shape[0] - 1
    cycle = np.floor(time / old[last])
    within = time - cycle * old[last]
    phase = 0
    while phase < last - 1 and within >= old[phase + 1]:
        phase += 1
    pace = (new[phase + 1] - new[phase]) / (old[phase + 1] - old[phase])
    return cycle * new[last] + new[phase] + pace * (within - old[phase]), pace
