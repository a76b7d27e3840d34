"""Gaits steered by hand, and what of it the take must say: the stage's part for speed and turn."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Literal

from footfall.scenario.cue_sheet import Cue
from footfall.studio.card import Card
from footfall.studio.performer import Performer
from footfall.studio.take import Take

__all__ = ["StageGaits"]

GAIT: tuple[Literal["speed"], Literal["turn"]] = ("speed", "turn")
"""What is steered of a gait, in the order of its parameters."""


class StageGaits(ABC):
    """The part of a stage that steers its gaits."""

    cards: list[Card]
    begun: bool
    take: Take
    _asked_gaits: dict[str, tuple[float, float]]
    """What each action was asked for in this take; where it is missing, nothing was."""

    @abstractmethod
    def pair(self) -> tuple[Performer, Performer]:
        """Return the character and its ghost; there must be a motion."""

    def steer(self, card: Card, speed: float, turn: float) -> None:
        """Let a gait go at another speed [m/s] and turn [rad/s].

        Raises:
            ArgumentError: If it is one motion, or its motions do not reach them.
        """
        self.pair()[0].check_gait(card.action, speed, turn)
        card.gait = (speed, turn)
        if self.begun:
            self._tell_gait(card)

    def gait(self, card: Card) -> dict[str, float]:
        """Return the speed [m/s] and the turn [rad/s] that a gait was last asked for."""
        asked = card.gait or self.pair()[0].gait(card.action)
        return dict(zip(GAIT, asked, strict=True))

    def _tell_gait(self, card: Card) -> None:
        """Ask the action of a card for the gait of the card, unless it was asked for it before."""
        if card.gait is None:
            return
        asked = self._asked_gaits.get(card.action, self.pair()[0].gait(card.action))
        self._asked_gaits[card.action] = card.gait
        for kind, old, new in zip(GAIT, asked, card.gait, strict=True):
            if new == old:
                continue
            for one in self.pair():
                one.steer(card.action, kind, new)
            at = self.pair()[0].clock
            self.take = self.take.with_cue(Cue(at, kind, card.action, parameter=new))

    def _keep_in_reach(self) -> None:
        """Ask no gait for what another body, or other motions, no longer reach."""
        for card in self.cards:
            spans = self.pair()[0].reach(card.action)
            if spans is None or card.gait is None:
                card.gait = None
                continue
            (slow, fast), (right, left) = spans
            speed, turn = card.gait
            card.gait = min(max(speed, slow), fast), min(max(turn, right), left)
