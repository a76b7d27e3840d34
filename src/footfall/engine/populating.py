"""Who is in a crowd, in how much detail, and all that it remembers as plain arrays."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from footfall.arrays import Flags, Indices, SmallFloats
from footfall.engine.record import FULL, HALF_RATE, NO_REACHING
from footfall.engine.rows import Rows, check_present, place_characters
from footfall.errors import ArgumentError
from footfall.octets import LANES

__all__ = ["Detail", "Populating", "blocks_of"]

Detail = Literal["full", "no reaching", "half rate"]
"""How much is worked out of a character: everything; legs as the motions have them, whatever the
ground; everything, but in every second frame only."""

DETAILS: dict[str, int] = {"full": FULL, "no reaching": NO_REACHING, "half rate": HALF_RATE}


class Populating(ABC):
    """The part of a crowd that knows who is in it."""

    _characters: npt.NDArray[Any]
    _poses: SmallFloats
    _newborn: npt.NDArray[Any]
    _stale: bool

    @abstractmethod
    def _make_room(self, rows: int) -> None:
        """Let the arrays have so many rows; nobody is in the new ones."""

    @property
    def size(self) -> int:
        """How many rows there are, those of characters that have been removed too."""
        return len(self._characters)

    @property
    def present(self) -> Flags:
        """In which rows there is somebody, shape (rows,)."""
        return self._characters["present"] != 0

    def spawn(
        self, count: int, position: npt.ArrayLike = (0.0, 0.0), heading: npt.ArrayLike = 0.0
    ) -> Indices:
        """Let more characters come; they do nothing yet.

        Rows of characters that have been removed are used first. Where there are more, all arrays
        are made anew: views of them, taken before, no longer follow.

        Args:
            count: How many, >= 0.
            position: Where: x and z [m], shape (2,) or (count, 2).
            heading: Yaw [rad], 0 facing +z, shape () or (count,).

        Returns:
            Their rows, which never change while they are here, shape (count,).

        Raises:
            ArgumentError: If the count is negative or a number is not finite.
        """
        if count < 0:
            raise ArgumentError(f"{count} characters to spawn; it must be at least 0")
        rows = np.flatnonzero(~self.present)[:count]
        if len(rows) < count:
            more = self.size + np.arange(count - len(rows))
            self._make_room(self.size + len(more))
            rows = np.concatenate([rows, more])
        born = np.repeat(self._newborn, count)
        # It is as late for them as for those who are here: ground that moves is where it is.
        born["clock"] = self._characters["clock"][self.present].max(initial=0.0)
        place_characters(born, np.arange(count), position, heading)
        self._characters[rows] = born
        return rows

    def remove(self, rows: Rows) -> None:
        """Let characters go; their rows stay empty until somebody is spawned there.

        Raises:
            ArgumentError: If there is nobody in a row.
        """
        self._characters["present"][check_present(rows, self._characters)] = 0

    def set_detail(self, detail: Detail, rows: Rows = None) -> None:
        """Choose how much is worked out of some characters.

        At half rate a character is up to one frame behind; half of the rows are shown in one
        frame, half in the next.

        Raises:
            ArgumentError: If there is nobody in a row, or no such choice.
        """
        if detail not in DETAILS:
            raise ArgumentError(f"detail {detail!r}; there are: {', '.join(DETAILS)}")
        chosen = check_present(rows, self._characters)
        self._characters["detail"][chosen] = DETAILS[detail]
        self._characters["rests"][chosen] = chosen % 2

    def set_synchronized(self, synchronized: bool, rows: Rows = None) -> None:
        """Choose whether the supports of some characters are synchronized, with footprints.

        Raises:
            ArgumentError: If there is nobody in a row, or somebody does something already.
        """
        chosen = check_present(rows, self._characters)
        busy = chosen[self._characters["occupied"][chosen] > 0]
        if len(busy):
            raise ArgumentError(
                f"character {busy[0]} runs actions; synchronization can be chosen only before"
            )
        for field in ("synchronized", "printed"):
            self._characters[field][chosen] = synchronized

    def snapshot(self) -> dict[str, npt.NDArray[Any]]:
        """Return all that the crowd remembers, as plain arrays that can be saved.

        The library, the body and the ground are not in it.
        """
        names = self._characters.dtype.names or ()
        arrays = {name: np.array(self._characters[name]) for name in names}
        return {**arrays, "poses": self._poses.copy()}

    def restore(self, snapshot: Mapping[str, npt.NDArray[Any]]) -> None:
        """Go back to what the crowd, or one of the same library, size and look-ahead, remembered.

        Raises:
            ArgumentError: If an array is missing or has another shape.
        """
        own = self.snapshot()
        for name, array in own.items():
            if name not in snapshot or snapshot[name].shape != array.shape:
                found = snapshot[name].shape if name in snapshot else "nothing"
                raise ArgumentError(
                    f"a snapshot with {found} for {name!r}; this crowd needs {array.shape}"
                )
        for name in own:
            if name != "poses":
                self._characters[name] = snapshot[name]
        self._poses[:] = snapshot["poses"]
        self._stale = True


def blocks_of(rows: int) -> int:
    """Return how many blocks of eight so many rows fill."""
    return -(-rows // LANES)
