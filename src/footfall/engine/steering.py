"""What can be changed of a crowd's actions while they play: priorities and parameters."""

from __future__ import annotations

from collections.abc import Mapping

from footfall.engine.library import MotionLibrary
from footfall.engine.parameters import Parameters
from footfall.engine.priorities import parse_priority
from footfall.engine.rows import Rows, check_rows
from footfall.engine.shelf import Shelf
from footfall.engine.standing import Standing
from footfall.engine.state import EMPTY
from footfall.errors import ArgumentError
from footfall.support import SupportSequence

__all__ = ["Steering"]


class Steering(Standing):
    """The part of a crowd that steers what plays."""

    library: MotionLibrary
    _shelf: Shelf
    _parameters: Parameters

    def _refresh(self) -> None:
        """Take in what has been added to the library."""
        raise NotImplementedError

    def _check_action(self, action: int) -> int:
        if not 0 <= action < len(self.library.actions):
            raise ArgumentError(
                f"action {action}; the library has 0..{len(self.library.actions) - 1}"
            )
        self._refresh()
        return action

    def set_priority(
        self, action: int, priority: float | Mapping[str, float], rows: Rows = None
    ) -> None:
        """Change the priority of a running or waiting action.

        Args:
            action: Its id in the library.
            priority: As in `MotionLibrary.add`.
            rows: Which characters: row numbers, a mask, or None for all.

        Raises:
            ArgumentError: If the action or a row does not exist, or a number is out of range.
            UnknownNameError: If a body part is unknown.
        """
        action = self._check_action(action)
        values = parse_priority(priority)
        for row in check_rows(rows, self.size):
            seats = (self._characters["action"][row] == action) & (
                self._characters["status"][row] != EMPTY
            )
            self._characters["priorities"][row, seats] = values
            self._characters["priority"][row, seats] = values[0]
            self._characters["unsettled"][row] = True

    def set_parameters(
        self, action: int, *, speed: float | None = None, turn: float | None = None
    ) -> None:
        """Ask a locomotion for another speed or turn; it changes on the way there, in a while.

        Args:
            action: Its id in the library.
            speed: Forward [m/s]; None: as it is.
            turn: To the left [rad/s]; None: as it is.

        Raises:
            ArgumentError: If the action does not exist or is no locomotion, or its clips do not
                reach the speed or the turn.
        """
        action = self._check_action(action)
        self._parameters.ask(
            self._shelf, self._characters, self.library.actions[action], action, (speed, turn)
        )

    def parameters_of(self, action: int) -> tuple[float, float]:
        """Return the speed [m/s] and the turn [rad/s] that a locomotion has by now.

        Raises:
            ArgumentError: If the action does not exist.
        """
        action = self._check_action(action)
        return self._parameters.of(self.library.actions[action], action)

    def supports_of(self, action: int) -> SupportSequence:
        """Return what an action stands on, a locomotion at its present parameters.

        Raises:
            ArgumentError: If the action does not exist.
        """
        action = self._check_action(action)
        return self._parameters.supports(self.library.actions[action], action)
