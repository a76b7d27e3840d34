"""The hands, eyes and seat of one character: commands with names instead of numbers."""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy.typing as npt

from footfall.engine.crowd import Crowd
from footfall.engine.goal_setting import Goals
from footfall.engine.reaching import HandState, Side

__all__ = ["Handed"]


class Handed(ABC):
    """The part of a character that meets things of the world after the blend."""

    @property
    @abstractmethod
    def crowd(self) -> Crowd:
        """The crowd of one that this character is."""

    @property
    def goals(self) -> Goals:
        """What its hands, eyes and seat are to meet after the blend.

        Raises:
            ArgumentError: If there is no action yet.
        """
        return self.crowd.goals

    def reach(
        self,
        hand: Side,
        point: npt.ArrayLike,
        *,
        grasp: bool = False,
        fade: float = 0.4,
    ) -> None:
        """Let a hand go for a point in the world [m]; arguments and errors as of `Crowd.reach`."""
        self.crowd.reach(hand, point, grasp=grasp, fade=fade)

    def release(self, hand: Side) -> None:
        """Let a hand go back to its own motion; errors as of `Crowd.release`."""
        self.crowd.release(hand)

    def hand(self, hand: Side) -> HandState:
        """Return what a hand does now; errors as of `Crowd.hand`."""
        return self.crowd.hand(hand)
