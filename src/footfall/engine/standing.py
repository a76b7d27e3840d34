"""What a crowd stands on, and where."""

from __future__ import annotations

import math
from typing import Any

import numpy.typing as npt

from footfall.adaptation import AnyGround, Plane, pack_ground
from footfall.adaptation.surfaces import Ground
from footfall.engine.rows import Rows, check_present, place_characters
from footfall.errors import ArgumentError

__all__ = ["Standing"]


class Standing:
    """The part of a crowd that knows its ground and its places."""

    _characters: npt.NDArray[Any]
    _ground: AnyGround
    _packed_ground: Ground = pack_ground(Plane())

    @property
    def ground(self) -> AnyGround:
        """What they stand on; it may be exchanged at any moment, while they walk."""
        return self._ground

    @ground.setter
    def ground(self, ground: AnyGround) -> None:
        self.exchange_ground(ground)

    def exchange_ground(self, ground: AnyGround, *, rise: float = 0.0) -> None:
        """Let them stand on other ground, or on the same one that is higher everywhere.

        Args:
            ground: What they stand on from now on.
            rise: How far it takes those who stand on it with it [m].
        """
        packed = pack_ground(ground)
        if _kinds(packed) != _kinds(self._packed_ground):
            # The surfaces that feet stood on are gone: they look for others.
            self._characters["surface"] = -1
        self._characters["level"][:, 0] += rise
        self._characters["ground_below"] += rise
        self._ground, self._packed_ground = ground, packed

    def raise_ground(self, height: float) -> None:
        """Put level ground at another height [m]; who stands on level ground is carried along.

        Raises:
            ArgumentError: If the height is not finite.
        """
        known = self._ground
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

    def place_of(self, row: int) -> tuple[float, float, float]:
        """Return where a character is: x, z [m] and heading [rad], 0 facing +z.

        Raises:
            ArgumentError: If there is nobody in the row.
        """
        x, z, heading = self._characters["root"][check_present([row], self._characters)[0]].tolist()
        return x, z, heading

    def clock_of(self, row: int) -> float:
        """Return the clock time of a character [s]; errors as of `place_of`."""
        return float(self._characters["clock"][check_present([row], self._characters)[0]])

    def steer(self, turning: float | None, rows: Rows = None) -> None:
        """Let characters turn as fast as they are told to, whatever their motions do.

        Planted feet stay as they are, and swinging ones get ahead of the body.

        Args:
            turning: To the left [rad/s]; None: as their motions turn.
            rows: Which characters: row numbers, a mask, or None for all.

        Raises:
            ArgumentError: If a row does not exist, or the number is not finite.
        """
        chosen = check_present(rows, self._characters)
        if turning is not None and not math.isfinite(turning):
            raise ArgumentError(f"turning is {turning} rad/s; it must be finite")
        self._characters["steered"][chosen] = turning is not None
        self._characters["steer"][chosen] = turning or 0.0


def _kinds(ground: Ground) -> list[int]:
    surfaces: Any = ground.surfaces
    return surfaces["kind"].tolist()
