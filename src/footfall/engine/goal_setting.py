"""What hands, eyes and seats are to meet after the blend: `Crowd.goals` and `Character.goals`."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, get_args

import numpy as np
import numpy.typing as npt

from footfall.adaptation.goal_body import GoalBody
from footfall.adaptation.goals import GAZE, HANDS, SEAT, meet_goals, new_goals
from footfall.arrays import Floats, Indices, Positions, Rotations
from footfall.engine.goal_checks import check_fading, heights_of, places_of
from footfall.engine.rows import Rows, check_present
from footfall.errors import ArgumentError, UnknownNameError

__all__ = ["GOAL_NAMES", "Goals", "Hand", "Unreached"]

Hand = Literal["left", "right"]
"""Which hand."""

GOAL_NAMES = ("left hand", "right hand", "gaze", "seat")
"""What the goals are called, in the order of `GoalMemory`."""

JUMP = 0.05
"""A target that moves further than this from one call to the next has jumped [m]: it is gone
after smoothly, while one that moves by less is followed as it moves."""

NEAR = 0.005
"""A goal missed by no more than this is reached [m] or [rad]."""


@dataclass(frozen=True, slots=True)
class Unreached:
    """A goal that the last pose does not meet."""

    name: str
    """ "left hand", "right hand", "gaze" or "seat"."""

    missed: float
    """By how much [m], of the gaze [rad]."""

    row: int = 0
    """Whose goal: the row of the crowd."""


class Goals:
    """The goals of characters. Each fades in when it is set, and out when it is dropped.

    To follow something that moves, set the goal again before every advance. `rows` are row
    numbers, a mask, or None for all: a character alone needs none.
    """

    def __init__(self) -> None:
        """Begin without characters: see `make_room`."""
        self.memory: npt.NDArray[Any] = new_goals(0)
        """All that is remembered: records of `GoalMemory`, shape (rows,)."""

    def make_room(
        self, characters: npt.NDArray[Any], bodies: Sequence[GoalBody], body_of_row: Indices
    ) -> None:
        """Take over more characters; the new ones have no goal.

        Args:
            characters: Records of all of them, shape (rows,).
            bodies: What of each body meets goals.
            body_of_row: Which body each character has, shape (rows,).
        """
        memory = new_goals(len(characters))
        memory[: len(self.memory)] = self.memory
        self.memory, self._characters = memory, characters
        self._bodies, self._body_of_row = bodies, body_of_row

    def forget(self, rows: Indices) -> None:
        """Take all goals from some rows, at once."""
        self.memory[rows] = new_goals(1)[0]

    def reach(
        self,
        hand: Hand,
        place: npt.ArrayLike,
        rows: Rows = None,
        *,
        weight: float = 1.0,
        fade: float = 0.3,
    ) -> None:
        """Let a hand reach for a place: its wrist comes there.

        Args:
            hand: "left" or "right".
            place: In the world [m], shape (3,) or (rows, 3).
            rows: Which characters.
            weight: How much of the way it goes, 0 to 1.
            fade: How long until it is there [s], >= 0.

        Raises:
            UnknownNameError: If there is no such hand.
            ArgumentError: If a body has no such arm, a row does not exist, or a number is out of
                range.
        """
        chosen = self._chosen(rows)
        side = self._side(hand, chosen)
        places = places_of(f"the goal of the {hand} hand", place, len(chosen))
        self._set(HANDS[side], places, chosen, weight, fade)
        self.memory["together"][chosen, 0] = -1.0

    def join_hands(
        self, apart: float = 0.05, rows: Rows = None, *, weight: float = 1.0, fade: float = 0.3
    ) -> None:
        """Let both hands come to each other, in the middle between where they are.

        Args:
            apart: How far apart the wrists are then [m], >= 0; change it to applaud.
            rows: Which characters.
            weight: How much of the way they go, 0 to 1.
            fade: How long until they are there [s], >= 0.

        Raises:
            ArgumentError: If a body has not two arms, a row does not exist, or a number is out of
                range.
        """
        chosen = self._chosen(rows)
        for hand in get_args(Hand):
            self._side(hand, chosen)
        if not (math.isfinite(apart) and apart >= 0.0):
            raise ArgumentError(f"hands {apart} m apart; it must be finite and >= 0")
        check_fading(weight, fade)
        begin = chosen[self.memory["together"][chosen, 0] < 0.0]
        reaching = self.memory["progress"][begin][:, HANDS].any(axis=1)
        self.memory["together"][begin, 1] = reaching
        for goal in HANDS:
            self.memory["lags"][begin[~reaching], goal] = 0.0
            self._fade_in(goal, chosen, weight, fade)
        self.memory["together"][chosen, 0] = apart

    def look_at(
        self, place: npt.ArrayLike, rows: Rows = None, *, weight: float = 1.0, fade: float = 0.3
    ) -> None:
        """Let the face look at a place; arguments and errors as of `reach`."""
        chosen = self._chosen(rows)
        if any(body.head < 0 for body in self._bodies_of(chosen)):
            raise ArgumentError("a gaze for a body without a head; it has none to turn")
        places = places_of("the goal of the gaze", place, len(chosen))
        self._set(GAZE, places, chosen, weight, fade)

    def sit(
        self, height: npt.ArrayLike, rows: Rows = None, *, weight: float = 1.0, fade: float = 0.3
    ) -> None:
        """Keep the hips at a height, the feet where they are.

        Args:
            height: Of the hip joints in the world [m], shape () or (rows,).
            rows: Which characters.
            weight: How much of the way they go, 0 to 1.
            fade: How long until they are there [s], >= 0.

        Raises:
            ArgumentError: If a row does not exist or a number is out of range.
        """
        chosen = self._chosen(rows)
        places = heights_of("the height of the seat", height, len(chosen))
        self._set(SEAT, places, chosen, weight, fade)

    def drop(self, name: str, rows: Rows = None, *, fade: float = 0.3) -> None:
        """Let a goal fade out.

        Args:
            name: "left hand", "right hand", "gaze" or "seat".
            rows: Which characters.
            fade: How long until it is gone [s], >= 0.

        Raises:
            UnknownNameError: If there is no goal of this name.
            ArgumentError: If a row does not exist or the fade is out of range.
        """
        if name not in GOAL_NAMES:
            raise UnknownNameError("goal", name, list(GOAL_NAMES))
        chosen = self._chosen(rows)
        check_fading(1.0, fade)
        goal = GOAL_NAMES.index(name)
        if fade == 0.0:
            self.memory["progress"][chosen, goal] = 0.0
        self.memory["fades"][chosen, goal] = -fade

    @property
    def missed(self) -> Floats:
        """By how much the last pose misses each goal [m], of the gaze [rad]: a view, (rows, 4)."""
        return self.memory["missed"]

    @property
    def unreached(self) -> tuple[Unreached, ...]:
        """The goals that the last pose does not meet, and by how much."""
        far = np.argwhere((self.missed > NEAR) & (self._characters["present"] != 0)[:, np.newaxis])
        places: list[list[int]] = far.tolist()
        return tuple(
            Unreached(GOAL_NAMES[goal], float(self.missed[row, goal]), row) for row, goal in places
        )

    def meet(self, rows: slice, rotations: Rotations, positions: Positions, dt: float) -> None:
        """Change finished poses so that the goals are met; for `Crowd.advance`.

        Args:
            rows: Rows side by side that have one body.
            rotations: Their joints in the world, shape (rows, joints, 4); rewritten.
            positions: Likewise [m], shape (rows, joints, 3).
            dt: Time since the last pose [s].
        """
        body = self._bodies[int(self._body_of_row[rows.start])]
        headings = self._characters["root"][rows, 2].copy()
        meet_goals(body, self.memory[rows], headings, dt, rotations, positions)

    def _chosen(self, rows: Rows) -> Indices:
        return check_present(rows, self._characters)

    def _bodies_of(self, chosen: Indices) -> list[GoalBody]:
        return [self._bodies[index] for index in np.unique(self._body_of_row[chosen]).tolist()]

    def _side(self, hand: str, chosen: Indices) -> int:
        if hand not in get_args(Hand):
            raise UnknownNameError("hand", hand, list(get_args(Hand)))
        side = get_args(Hand).index(hand)
        if any(body.arms.limbs[side, 0] < 0 for body in self._bodies_of(chosen)):
            raise ArgumentError(f"a goal for the {hand} hand of a body without that arm")
        return side

    def _set(
        self, goal: int, places: Positions, chosen: Indices, weight: float, fade: float
    ) -> None:
        check_fading(weight, fade)
        memory = self.memory
        seen = memory["progress"][chosen, goal] > 0.0
        moved = memory["targets"][chosen, goal] - places
        jumped = seen & (np.linalg.norm(moved, axis=-1) > JUMP)
        memory["lags"][chosen[jumped], goal] += moved[jumped]
        memory["lags"][chosen[~seen], goal] = 0.0
        memory["targets"][chosen, goal] = places
        self._fade_in(goal, chosen, weight, fade)

    def _fade_in(self, goal: int, chosen: Indices, weight: float, fade: float) -> None:
        memory = self.memory
        memory["wanted"][chosen, goal] = weight
        unseen = chosen[memory["progress"][chosen, goal] == 0.0]
        memory["weights"][unseen, goal] = weight
        if fade == 0.0:
            memory["progress"][chosen, goal] = 1.0
        memory["fades"][chosen, goal] = fade
