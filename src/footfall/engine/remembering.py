"""All that a crowd remembers as plain arrays, and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.adaptation.goals import goal_type
from footfall.engine.cohorts import Layout
from footfall.engine.hand_record import hand_type
from footfall.engine.meeting import Meeting
from footfall.errors import ArgumentError

__all__ = ["Remembering"]

HAND, GOAL, GAIT = "hand_", "goal_", "gait_"
"""What the names of arrays begin with that tell of hands, of goals and of gaits."""

Snapshot = Mapping[str, npt.NDArray[Any]]


class Remembering(Meeting):
    """The part of a crowd that can be kept, and gone back to."""

    _layout: Layout
    _stale: bool

    def snapshot(self) -> dict[str, npt.NDArray[Any]]:
        """Return all that the crowd remembers, as plain arrays that can be saved.

        The library, the bodies themselves and the grounds are not in it.
        """
        arrays = _fields("", self._characters)
        arrays["poses"] = self._layout.poses.copy()
        arrays["cohorts"] = np.array([cohort.span for cohort in self._cohorts])
        arrays["leg_lengths"] = np.array([body.rig.leg_length for body in self._bodies.all])
        for number, one in enumerate(self._bodies.repertoires):
            told = one.parameters.snapshot(one.shelf, one.library.actions)
            arrays |= {f"{GAIT}{name}_{number}": array for name, array in told.items()}
        if self._hands is not None:
            arrays |= _fields(HAND, self._hands)
        if self._goals is not None:
            arrays |= _fields(GOAL, self._goals.memory)
        return arrays

    def restore(self, snapshot: Snapshot) -> None:
        """Go back to what the crowd, or one of the same library, bodies and look-ahead, remembered.

        Hands and goals that a snapshot does not tell of are free, and none.

        Raises:
            ArgumentError: If an array is missing or has another shape, or rows have other bodies.
        """
        self._refresh()
        own, rows = self.snapshot(), len(self._body_of_row)
        needed = {name: array.shape for name, array in own.items() if not _optional(name)}
        for kind, layout, shape in (
            (HAND, hand_type, (rows, 2)),
            (GOAL, goal_type, (rows,)),
        ):
            if any(name.startswith(kind) for name in snapshot):
                fields = {name: layout[name].shape for name in layout.names or ()}
                needed |= {kind + name: (*shape, *inner) for name, inner in fields.items()}
        _check(snapshot, needed)
        if any((snapshot[name] != own[name]).any() for name in ("cohorts", "leg_lengths")):
            raise ArgumentError(
                "a snapshot of rows of other bodies or grounds; first spawn the same ones in the "
                "same order"
            )
        _write("", self._characters, snapshot)
        self._layout.poses[:] = snapshot["poses"]
        for number, one in enumerate(self._bodies.repertoires):
            told = {name: snapshot[f"{GAIT}{name}_{number}"] for name in ("values", "supports")}
            one.parameters.restore(one.shelf, self._parts(one), one.library.actions, told)
        self._empty_hands(np.arange(rows))
        if HAND + "task" in needed:
            _write(HAND, self._make_hands(), snapshot)
        if GOAL + "targets" in needed:
            _write(GOAL, self.goals.memory, snapshot)
        self._stale = True


def _optional(name: str) -> bool:
    return name.startswith((HAND, GOAL))


def _fields(kind: str, records: npt.NDArray[Any]) -> dict[str, npt.NDArray[Any]]:
    return {kind + name: np.array(records[name]) for name in records.dtype.names or ()}


def _write(kind: str, records: Any, snapshot: Snapshot) -> None:
    for name in records.dtype.names or ():
        records[name] = snapshot[kind + name]


def _check(snapshot: Snapshot, needed: Mapping[str, tuple[int, ...]]) -> None:
    for name, shape in needed.items():
        if name not in snapshot or snapshot[name].shape != shape:
            found = snapshot[name].shape if name in snapshot else "nothing"
            raise ArgumentError(f"a snapshot with {found} for {name!r}; this crowd needs {shape}")
