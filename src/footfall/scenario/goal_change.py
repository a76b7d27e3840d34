"""What a cue asks of hands, eyes and seat, after the blend: a goal that comes, or one that goes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from footfall.engine.goal_setting import Goals, Hand

__all__ = ["GOAL_KINDS", "GoalChange", "GoalKind"]

GoalKind = Literal["reach", "join_hands", "look_at", "sit", "drop"]
"""What is asked for, each a method of `Goals`."""

GOAL_KINDS: tuple[GoalKind, ...] = get_args(GoalKind)
"""All of them."""


@dataclass(frozen=True, slots=True)
class GoalChange:
    """One goal that is set or dropped; what its kind does not need is left as it is."""

    kind: GoalKind
    """What is asked for."""

    hand: Hand = "left"
    """Which hand reaches."""

    point: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """What is reached for or looked at, in the world of the first motion [m]."""

    apart: float = 0.05
    """How far apart hands that join are held [m]."""

    height: float = 0.0
    """Of the hips that sit, in that world [m]."""

    goal: str = ""
    """Which goal is dropped: one of `GOAL_NAMES`."""

    weight: float = 1.0
    """How much of the way is gone, 0 to 1."""

    fade: float = 0.3
    """How long until the goal is met, or gone [s]."""

    def give(self, goals: Goals) -> None:
        """Set or drop the goal of a character alone.

        Raises:
            ArgumentError: If its body has not what the goal needs.
        """
        if self.kind == "reach":
            goals.reach(self.hand, self.point, weight=self.weight, fade=self.fade)
        elif self.kind == "join_hands":
            goals.join_hands(self.apart, weight=self.weight, fade=self.fade)
        elif self.kind == "look_at":
            goals.look_at(self.point, weight=self.weight, fade=self.fade)
        elif self.kind == "sit":
            goals.sit(self.height, weight=self.weight, fade=self.fade)
        else:
            goals.drop(self.goal, fade=self.fade)
