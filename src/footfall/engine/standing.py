"""What a crowd stands on, and where."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.adaptation import AnyGround, Plane, pack_ground
from footfall.adaptation.surfaces import Ground
from footfall.arrays import Indices
from footfall.engine.rows import Rows, check_present, place_characters
from footfall.errors import ArgumentError

__all__ = ["Standing"]


class Standing:
    """The part of a crowd that knows its grounds and its places."""

    _characters: npt.NDArray[Any]
    _ground_of_row: Indices
    _grounds: list[AnyGround]
    _packed_grounds: list[Ground]

    def _stand_on(self, ground: AnyGround) -> int:
        """Return the number of a ground, which becomes one of the crowd if it is not yet."""
        for number, known in enumerate(self._grounds):
            if known is ground:
                return number
        self._grounds.append(ground)
        self._packed_grounds.append(pack_ground(ground))
        return len(self._grounds) - 1

    @property
    def ground(self) -> AnyGround:
        """What they stand on; it may be exchanged at any moment, while they walk.

        Those do who were not spawned on another one.
        """
        return self._grounds[0]

    @ground.setter
    def ground(self, ground: AnyGround) -> None:
        self.exchange_ground(ground)

    @property
    def ground_of_row(self) -> list[AnyGround]:
        """What each row stands on."""
        numbers: list[int] = self._ground_of_row.tolist()
        return [self._grounds[number] for number in numbers]

    def exchange_ground(
        self, ground: AnyGround, *, rise: float = 0.0, instead_of: AnyGround | None = None
    ) -> None:
        """Let them stand on other ground, or on the same one that is higher everywhere.

        Args:
            ground: What they stand on from now on.
            rise: How far it takes those who stand on it with it [m].
            instead_of: Only those who stand on this very one; by default on `Crowd.ground`.

        Raises:
            ArgumentError: If nobody was ever spawned on that one.
        """
        old = self._grounds[0] if instead_of is None else instead_of
        numbers = [number for number, known in enumerate(self._grounds) if known is old]
        if not numbers:
            raise ArgumentError(f"nobody stands on {instead_of}; exchange what somebody stands on")
        packed = pack_ground(ground)
        rows = np.flatnonzero(self._ground_of_row == numbers[0])
        if _kinds(packed) != _kinds(self._packed_grounds[numbers[0]]):
            # The surfaces that feet stood on are gone: they look for others.
            self._characters["surface"][rows] = -1
        self._characters["level"][rows, 0] += rise
        self._characters["ground_below"][rows] += rise
        self._grounds[numbers[0]], self._packed_grounds[numbers[0]] = ground, packed

    def raise_ground(self, height: float) -> None:
        """Put level ground at another height [m]; who stands on level ground is carried along.

        Raises:
            ArgumentError: If the height is not finite.
        """
        known = self.ground
        rise = height - known.height if isinstance(known, Plane) else 0.0
        self.exchange_ground(Plane(height), rise=rise)

    def place(
        self, position: npt.ArrayLike, heading: npt.ArrayLike = 0.0, rows: Rows = None
    ) -> None:
        """Put characters somewhere; footprints are forgotten.

        Args:
            position: x and z [m], shape (2,) or (rows, 2).
            heading: Yaw [rad], 0 facing +z, positive from z towards x.
            rows: Which characters: row numbers, a mask, or None for all.

        Raises:
            ArgumentError: If a row does not exist or a number is not finite.
        """
        rows = check_present(rows, self._characters)
        place_characters(self._characters, rows, position, heading)


def _kinds(ground: Ground) -> list[int]:
    surfaces: Any = ground.surfaces
    return surfaces["kind"].tolist()
