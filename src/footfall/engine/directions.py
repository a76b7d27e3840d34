"""Actions that travel, each its own way: which of them, mixed, go in a direction."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from footfall.arrays import Floats, Indices, Weights
from footfall.engine.library import MotionLibrary
from footfall.engine.shelf import Shelf
from footfall.errors import ArgumentError
from footfall.geometry.ground_path import wrapped

__all__ = ["Directions"]

SHORTEST = 0.05
"""An action that gets less far than this in a cycle stays where it is [m]."""

ALIKE = math.radians(15.0)
"""Two actions that go the same way but for this cannot both be chosen from [rad]."""

WIDEST = math.radians(170.0)
"""Between two directions that are farther apart than this, nothing can be mixed [rad]."""

PURE = math.radians(6.0)
"""What is off the direction of an action by less than this is not mixed: it goes there alone."""


@dataclass(frozen=True, eq=False)
class Directions:
    """Where some actions go, as seen from the body."""

    actions: Indices
    """Ids in the library, by direction from right to left, shape (actions,)."""

    ways: Floats
    """How far each goes to its left and ahead in one phase [m], shape (actions, 2). A phase, since
    phases are what motions share when they are mixed."""

    speed: float
    """How fast the fastest of them goes by itself [m/s]."""

    @classmethod
    def of(
        cls, library: MotionLibrary, shelf: Shelf, leg_length: float, names: Sequence[str] | None
    ) -> Directions:
        """Measure where actions go, on a body whose legs are so long [m].

        Args:
            library: Where they are.
            shelf: The same as the kernels take it.
            leg_length: Of the body [m].
            names: Which; None: all that are cyclic and travel.

        Raises:
            ArgumentError: If there is none, one is not cyclic or stays where it is, or two go the
                same way.
            UnknownNameError: If there is no action of a name.
        """
        chosen = range(len(library.actions)) if names is None else map(library.index, names)
        found: list[tuple[float, int, Floats, float]] = []
        for action in dict.fromkeys(chosen):
            entry: Any = shelf.entries[action]
            first, last = (
                shelf.roots[int(entry["first_frame"]) + frame]
                for frame in (0, int(entry["frame_count"]) - 1)
            )
            x, z = leg_length * (last[:2] - first[:2])
            cyclic = bool(entry["cyclic"])
            if not cyclic or math.hypot(x, z) < SHORTEST:
                if names is None:
                    continue
                why = "stays where it is" if cyclic else "is not cyclic"
                raise ArgumentError(
                    f"{library.actions[action].name!r} {why}; a path needs walks and side steps"
                )
            # As seen from the body in the middle of its turn, where it turns.
            yaw = math.atan2(x, z) - 0.5 * (first[2] + last[2])
            way = math.hypot(x, z) * np.array([math.sin(yaw), math.cos(yaw)])
            speed = math.hypot(x, z) / float(entry["duration"])
            found.append((wrapped(yaw), action, way / int(entry["phase_count"]), speed))
        found.sort(key=lambda one: one[0])
        if not found:
            raise ArgumentError("no action that travels; a path needs a cyclic walk at least")
        _check_apart([(yaw, library.actions[action].name) for yaw, action, _, _ in found])
        return cls(
            np.array([action for _, action, _, _ in found]),
            np.array([way for _, _, way, _ in found]),
            max(speed for _, _, _, speed in found),
        )

    def shares(self, aim: float) -> Weights:
        """Return the shares of the two whose mix goes towards a direction, shape (actions,).

        Where it lies between no two, or hardly off one, the nearest has it all.

        Args:
            aim: Where to, as seen from the body [rad], 0 ahead, to the left.
        """
        yaws = self._yaws
        shares = np.zeros(len(yaws))
        beyond = np.remainder(yaws - aim, math.tau)
        left, right, between = self._neighbors(aim)
        if between > WIDEST:
            shares[int(np.abs(np.remainder(beyond + math.pi, math.tau) - math.pi).argmin())] = 1.0
            return shares
        off = (math.tau - float(beyond[right]) - PURE) / (between - 2.0 * PURE)
        aim = float(yaws[right]) + min(max(off, 0.0), 1.0) * between
        wanted = np.array([math.sin(aim), math.cos(aim)])
        parts = np.maximum(np.linalg.solve(self.ways[[left, right]].T, wanted), 0.0)
        shares[[left, right]] = parts / parts.sum()
        return shares

    def reach(self, aim: float) -> bool:
        """Return whether a direction lies between two that can be mixed."""
        return self._neighbors(aim)[2] <= WIDEST

    @property
    def _yaws(self) -> Floats:
        return np.arctan2(self.ways[:, 0], self.ways[:, 1])

    def _neighbors(self, aim: float) -> tuple[int, int, float]:
        """Return which actions go next to the left and to the right, and the angle between them."""
        beyond = np.remainder(self._yaws - aim, math.tau)
        left, right = int(beyond.argmin()), int(beyond.argmax())
        if left == right:
            return left, right, math.tau
        return left, right, math.tau - float(beyond[right]) + float(beyond[left])

    def direction(self, shares: Weights) -> float:
        """Return where a mix goes as seen from the body [rad], 0 ahead, to the left."""
        x, z = shares @ self.ways
        return math.atan2(x, z)


def _check_apart(found: list[tuple[float, str]]) -> None:
    for (yaw, name), (other_yaw, other) in zip(found, found[1:] + found[:1], strict=True):
        if name != other and abs(wrapped(other_yaw - yaw)) < ALIKE:
            raise ArgumentError(
                f"{name!r} and {other!r} go the same way, {round(math.degrees(yaw))}° to the left; "
                "name one of them"
            )
