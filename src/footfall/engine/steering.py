"""What can be changed of a crowd's gaits while they play: their parameters."""

from __future__ import annotations

from footfall.engine.layering import Layering
from footfall.support import SupportSequence

__all__ = ["Steering"]


class Steering(Layering):
    """The part of a crowd that steers what plays."""

    def _steered(self) -> bool:
        """Return whether a parameter is on its way."""
        # A loop, since this is asked in every frame: a generator takes longer than the answer.
        for one in self._bodies.repertoires:  # noqa: SIM110
            if one.parameters.moving:
                return True
        return False

    def _steer(self, dt: float) -> None:
        """Let every parameter go on its way for a time [s]."""
        for one in self._bodies.repertoires:
            one.parameters.advance(one.shelf, self._parts(one), one.library.actions, dt)

    def set_parameters(
        self, action: int, *, speed: float | None = None, turn: float | None = None
    ) -> None:
        """Ask a locomotion for another speed or turn; it changes on the way there, in a while.

        Args:
            action: Its id in the library.
            speed: Forward, of the library's own body [m/s]; None: as it is. Others go as many
                of their leg lengths in the same time.
            turn: To the left [rad/s]; None: as it is.

        Raises:
            ArgumentError: If the action does not exist or is no locomotion, or its clips do not
                reach the speed or the turn.
        """
        action = self._check_action(action)
        own, *others = self._bodies.repertoires
        own.ask(self._parts(own), action, speed, turn)
        for other in others:
            reached = None if speed is None else own.speed_of(other, action, speed)
            other.ask(self._parts(other), action, reached, turn)

    def parameters_of(self, action: int) -> tuple[float, float]:
        """Return the speed [m/s] and the turn [rad/s] that a locomotion has by now.

        Raises:
            ArgumentError: If the action does not exist.
        """
        action = self._check_action(action)
        own = self._bodies.repertoires[0]
        return own.parameters.of(self.library.actions[action], action)

    def supports_of(self, action: int) -> SupportSequence:
        """Return what an action stands on, a locomotion at its present parameters.

        Raises:
            ArgumentError: If the action does not exist.
        """
        action = self._check_action(action)
        own = self._bodies.repertoires[0]
        return own.parameters.supports(self.library.actions[action], action)
