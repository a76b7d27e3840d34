"""Goals of a crowd: what hands, eyes and seats are to meet after the blend."""

from __future__ import annotations

from footfall.arrays import Indices
from footfall.engine.goal_setting import Goals
from footfall.engine.hand_record import new_hands
from footfall.engine.reaching import Reaching

__all__ = ["Meeting"]


class Meeting(Reaching):
    """The part of a crowd that meets goals."""

    _goals: Goals | None = None

    @property
    def goals(self) -> Goals:
        """What hands, eyes and seats are to meet after the blend, row by row."""
        if self._goals is None:
            self._goals = Goals()
            self._make_goals_room()
        return self._goals

    def _make_goals_room(self) -> None:
        """Let as many characters have goals; the new ones have none."""
        if self._goals is not None:
            bodies = [body.goals for body in self._bodies.all]
            self._goals.make_room(self._characters, bodies, self._body_of_row)

    def _empty_hands(self, rows: Indices) -> None:
        """Let characters reach for nothing, and have no goal."""
        if self._hands is not None:
            self._hands[rows] = new_hands(1)[0]
        if self._goals is not None:
            self._goals.forget(rows)

    def _meet_goals(self, dt: float) -> None:
        """Turn poses that have just been worked out towards the goals."""
        if self._goals is not None:
            for cohort in self._cohorts:
                self._goals.meet(
                    slice(cohort.span.first, cohort.span.end),
                    cohort.world_rotations,
                    cohort.world_positions,
                    dt,
                )
