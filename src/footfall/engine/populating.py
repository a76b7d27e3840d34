"""Who is in a crowd, with which body, and in how much detail."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from footfall.adaptation import AnyGround
from footfall.arrays import Flags, Indices
from footfall.engine.bodies import Bodies
from footfall.engine.cohorts import Cohort, Span, with_more
from footfall.engine.record import FULL, HALF_RATE, NO_REACHING
from footfall.engine.rows import Rows, check_present, place_characters
from footfall.errors import ArgumentError
from footfall.skeleton import Skeleton

__all__ = ["Detail", "Populating"]

Detail = Literal["full", "no reaching", "half rate"]
"""How much is worked out of a character: everything; legs as the motions have them, whatever the
ground; everything, but in every second frame only."""

DETAILS: dict[str, int] = {"full": FULL, "no reaching": NO_REACHING, "half rate": HALF_RATE}


class Populating(ABC):
    """The part of a crowd that knows who is in it."""

    _characters: npt.NDArray[Any]
    _newborn: npt.NDArray[Any]
    _bodies: Bodies
    _cohorts: tuple[Cohort, ...]
    _body_of_row: Indices
    _ground_of_row: Indices

    @abstractmethod
    def _make_room(self, spans: Sequence[Span]) -> None:
        """Let the arrays have the rows of some spans; nobody is in the new ones."""

    @abstractmethod
    def _stand_on(self, ground: AnyGround) -> int:
        """Return the number of a ground, which becomes one of the crowd if it is not yet."""

    @abstractmethod
    def _empty_hands(self, rows: Indices) -> None:
        """Let characters reach for nothing, and have no goal."""

    @property
    def size(self) -> int:
        """How many rows there are, those of characters that have been removed too."""
        return len(self._characters)

    @property
    def present(self) -> Flags:
        """In which rows there is somebody, shape (rows,)."""
        return self._characters["present"] != 0

    def spawn(
        self,
        count: int,
        position: npt.ArrayLike = (0.0, 0.0),
        heading: npt.ArrayLike = 0.0,
        *,
        body: Skeleton | None = None,
        ground: AnyGround | None = None,
    ) -> Indices:
        """Let more characters come; they do nothing yet.

        Rows of characters that are gone are used first, of that body and on that ground. Where
        there are more, all arrays are made anew: views of them, taken before, no longer follow.

        Those alike are worked on eight at a time: where the last row is of others, up to seven
        rows stay empty before the new ones. Who is spawned together costs least.

        Args:
            count: How many, >= 0.
            position: Where: x and z [m], shape (2,) or (count, 2).
            heading: Yaw [rad], 0 facing +z, shape () or (count,).
            body: Theirs; by default that of the crowd. Of the library's family, or any other one
                that its motions can be retargeted to, which is done when it comes first.
            ground: What they stand on; by default what the crowd does. It is theirs until it is
                exchanged: see `exchange_ground`.

        Returns:
            Their rows, which never change while they are here, shape (count,).

        Raises:
            ArgumentError: If the count is negative or a number is not finite.
            SkeletonError: If the motions cannot be adapted to the body.
        """
        if count < 0:
            raise ArgumentError(f"{count} characters to spawn; it must be at least 0")
        born = np.repeat(self._newborn, count)
        # It is as late for them as for those who are here: ground that moves is where it is.
        born["clock"] = self._characters["clock"][self.present].max(initial=0.0)
        place_characters(born, np.arange(count), position, heading)
        kind = self._bodies.index_of(body)
        floor = 0 if ground is None else self._stand_on(ground)
        alike = (self._body_of_row == kind) & (self._ground_of_row == floor)
        rows = np.flatnonzero(~self.present & alike)[:count]
        if len(rows) < count:
            lacking = count - len(rows)
            spans = with_more([cohort.span for cohort in self._cohorts], kind, floor, lacking)
            self._make_room(spans)
            rows = np.concatenate([rows, self.size + np.arange(-lacking, 0)])
        self._characters[rows] = born
        self._empty_hands(rows)
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
