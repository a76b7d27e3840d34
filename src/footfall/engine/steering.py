"""What can be changed of a crowd's gaits while they play: their parameters."""

from __future__ import annotations

from footfall.engine.layering import Layering
from footfall.engine.parameters import Parameters
from footfall.support import SupportSequence

__all__ = ["Steering"]


class Steering(Layering):
    """The part of a crowd that steers what plays."""

    _parameters: Parameters

    def _refresh(self) -> None:
        known = self._known
        super()._refresh()
        if self._known != known:
            self._parameters.write(self._shelf, self._characters, self.library.actions)

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
