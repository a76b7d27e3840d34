"""What hands, eyes and seat of the live character are to meet: the stage's part for goals."""

from __future__ import annotations

from abc import ABC, abstractmethod

from footfall.scenario.entries import Cue
from footfall.scenario.goal_change import GoalChange
from footfall.studio.performer import Performer
from footfall.studio.take import Take

__all__ = ["StageGoals"]


class StageGoals(ABC):
    """The part of a stage that sets goals."""

    begun: bool
    take: Take
    _asked_goals: list[GoalChange]
    """What was asked for before the take begins."""

    @abstractmethod
    def pair(self) -> tuple[Performer, Performer]:
        """Return the character and its ghost; there must be a motion."""

    def meet(self, change: GoalChange) -> None:
        """Set or drop a goal, now or as soon as the take begins.

        Raises:
            ArgumentError: If the body has not what the goal needs.
        """
        if not self.begun:
            self._asked_goals.append(change)
            return
        for one in self.pair():
            one.meet(change)
        self.take = self.take.with_cue(Cue(self.pair()[0].clock, change.kind, goal=change))

    def _tell_goals(self) -> None:
        """Set the goals that were asked for before."""
        asked, self._asked_goals = self._asked_goals, []
        for change in asked:
            self.meet(change)
