"""What a crowd stands on, and where."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.adaptation import (
    AnyGround,
    BuiltGround,
    Plane,
    check_ground,
    pack_ground,
    sample_ground,
)
from footfall.adaptation.surface_record import Ground as PackedGround
from footfall.arrays import Indices
from footfall.engine.library import MotionLibrary
from footfall.engine.pipeline import LONGEST_STEP
from footfall.engine.rows import Rows, check_present, place_characters
from footfall.engine.state import EMPTY
from footfall.errors import ArgumentError, GroundError

__all__ = ["Standing"]


class Standing:
    """The part of a crowd that knows its grounds and its places."""

    _characters: npt.NDArray[Any]
    _ground_of_row: Indices
    _grounds: list[AnyGround]
    _packed_grounds: list[PackedGround]
    library: MotionLibrary

    def _stand_on(self, ground: AnyGround) -> int:
        """Return the number of a ground, which becomes one of the crowd if it is not yet."""
        for number, known in enumerate(self._grounds):
            if known is ground:
                return number
        self._packed_grounds.append(self._packed(ground, np.zeros(0, dtype=np.int64), 0.0)[0])
        self._grounds.append(ground)
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
    def packed_ground(self) -> PackedGround:
        """The same as the kernels take it."""
        return self._packed_grounds[0]

    def packed_ground_of(self, row: int) -> PackedGround:
        """Return what a row stands on, as the kernels take it."""
        return self._packed_grounds[int(self._ground_of_row[row])]

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
            ArgumentError: If it is no ground, or nobody was ever spawned on that one.
            GroundError: If it is a program's own, and fails; nothing is exchanged then.
        """
        old = self._grounds[0] if instead_of is None else instead_of
        numbers = [number for number, known in enumerate(self._grounds) if known is old]
        if not numbers:
            raise ArgumentError(f"nobody stands on {instead_of}; exchange what somebody stands on")
        rows = np.flatnonzero(self._ground_of_row == numbers[0])
        packed = self._packed(ground, rows, 0.0)[0]
        if _kinds(packed) != _kinds(self._packed_grounds[numbers[0]]):
            # The surfaces that feet stood on are gone: they look for others.
            self._characters["surface"][rows] = -1
        self._characters["level"][rows, 0] += rise
        self._characters["ground_below"][rows] += rise
        self._grounds[numbers[0]], self._packed_grounds[numbers[0]] = ground, packed

    def _sampled_grounds(self, dt: float) -> list[list[PackedGround]]:
        """Return all grounds as the kernels take them, for each step of a time [s].

        Those of a program's own are asked for all steps before the first one is made, so that
        nothing has moved if one fails.
        """
        ways: list[list[PackedGround]] = []
        for number, ground in enumerate(self._grounds):
            if isinstance(ground, BuiltGround):
                ways.append([self._packed_grounds[number]])
                continue
            ways.append(self._packed(ground, np.flatnonzero(self._ground_of_row == number), dt))
        steps = max(len(way) for way in ways)
        return [[way[min(step, len(way) - 1)] for way in ways] for step in range(steps)]

    def _packed(self, ground: AnyGround, rows: Indices, dt: float) -> list[PackedGround]:
        """Return a ground under some rows as the kernels take it, for each step of a time [s]."""
        if isinstance(ground, BuiltGround):
            return [pack_ground(ground)]
        check_ground(ground)
        here = rows[self._characters["present"][rows] != 0]
        people = self._characters[here]
        if not len(here):
            return [pack_ground(Plane())]
        clock, steps = float(people["clock"].max()), max(1, math.ceil(dt / LONGEST_STEP - 1e-9))
        times: list[float] = (clock + dt * np.arange(steps + 1) / steps).tolist()
        try:
            return [
                sample_ground(ground, people["root"][:, :2], span, dt)
                for span in itertools.pairwise(times)
            ]
        except GroundError as error:
            raise GroundError(f"{error} ({self._who(here)})") from error.__cause__

    def _who(self, rows: Indices) -> str:
        """Return who stands there and what they do, for a message."""
        people = self._characters[rows]
        running: list[int] = np.unique(people["action"][people["status"] != EMPTY]).tolist()
        names = ", ".join(repr(self.library.actions[action].name) for action in running)
        who = f"character {rows[0]}" if len(rows) == 1 else f"{len(rows)} characters"
        return f"under {who}, {names or 'standing'}"

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


def _kinds(ground: PackedGround) -> list[int]:
    surfaces: Any = ground.surfaces
    return surfaces["kind"].tolist()
