"""What a character's hands, eyes and seat are to meet after the blend: `Character.goals`."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
import numpy.typing as npt

from footfall.adaptation.goal_body import goal_body_of
from footfall.adaptation.goals import (
    GAZE,
    HANDS,
    SEAT,
    GoalMemory,
    meet_goals,
)
from footfall.arrays import Positions, Rotations
from footfall.errors import ArgumentError, UnknownNameError
from footfall.skeleton import Anatomy, Skeleton

__all__ = ["Goals", "Hand", "Unreached"]

Hand = Literal["left", "right"]
"""Which hand."""

NAMES = ("left hand", "right hand", "gaze", "seat")
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


class Goals:
    """The goals of one character. Each fades in when it is set, and out when it is dropped.

    To follow something that moves, set the goal again before every advance.
    """

    def __init__(self, skeleton: Skeleton, anatomy: Anatomy) -> None:
        """Begin without goals.

        Args:
            skeleton: The character's body.
            anatomy: What its joints are.
        """
        self._body = goal_body_of(skeleton, anatomy)
        self._memory = GoalMemory.empty()

    def reach(
        self, hand: Hand, place: npt.ArrayLike, *, weight: float = 1.0, fade: float = 0.3
    ) -> None:
        """Let a hand reach for a place: its wrist comes there.

        Args:
            hand: "left" or "right".
            place: In the world [m], shape (3,).
            weight: How much of the way it goes, 0 to 1.
            fade: How long until it is there [s], >= 0.

        Raises:
            UnknownNameError: If there is no such hand.
            ArgumentError: If the body has no such arm, or a number is out of range.
        """
        side = self._side(hand)
        self._memory.together[0] = -1.0
        self._set(HANDS[side], _place(f"the goal of the {hand} hand", place), weight, fade)

    def join_hands(self, apart: float = 0.05, *, weight: float = 1.0, fade: float = 0.3) -> None:
        """Let both hands come to each other, in the middle between where they are.

        Args:
            apart: How far apart the wrists are then [m], >= 0; change it to applaud.
            weight: How much of the way they go, 0 to 1.
            fade: How long until they are there [s], >= 0.

        Raises:
            ArgumentError: If the body has not two arms, or a number is out of range.
        """
        for hand in get_args(Hand):
            self._side(hand)
        if not (math.isfinite(apart) and apart >= 0.0):
            raise ArgumentError(f"hands {apart} m apart; it must be finite and >= 0")
        memory = self._memory
        if memory.together[0] < 0.0:
            reaching = bool(memory.progress[list(HANDS)].any())
            memory.together[1] = float(reaching)
            if not reaching:
                memory.lags[list(HANDS)] = 0.0
        for goal in HANDS:
            self._fade_in(goal, weight, fade)
        memory.together[0] = apart

    def look_at(self, place: npt.ArrayLike, *, weight: float = 1.0, fade: float = 0.3) -> None:
        """Let the face look at a place; arguments and errors as of `reach`."""
        if self._body.head < 0:
            raise ArgumentError("a gaze for a body without a head; it has none to turn")
        self._set(GAZE, _place("the goal of the gaze", place), weight, fade)

    def sit(self, height: float, *, weight: float = 1.0, fade: float = 0.3) -> None:
        """Keep the hips at a height, the feet where they are.

        Args:
            height: Of the hip joints in the world [m].
            weight: How much of the way they go, 0 to 1.
            fade: How long until they are there [s], >= 0.

        Raises:
            ArgumentError: If a number is out of range.
        """
        self._set(SEAT, _place("the height of the seat", (0.0, height, 0.0)), weight, fade)

    def drop(self, name: str, *, fade: float = 0.3) -> None:
        """Let a goal fade out.

        Args:
            name: "left hand", "right hand", "gaze" or "seat".
            fade: How long until it is gone [s], >= 0.

        Raises:
            UnknownNameError: If there is no goal of this name.
            ArgumentError: If the fade is out of range.
        """
        if name not in NAMES:
            raise UnknownNameError("goal", name, list(NAMES))
        _check_fade(fade)
        goal = NAMES.index(name)
        if fade == 0.0:
            self._memory.progress[goal] = 0.0
        self._memory.fades[goal] = -fade

    @property
    def unreached(self) -> tuple[Unreached, ...]:
        """The goals that the last pose does not meet, and by how much."""
        return tuple(
            Unreached(NAMES[goal], float(missed))
            for goal, missed in enumerate(self._memory.missed)
            if missed > NEAR
        )

    def meet(self, heading: float, dt: float, rotations: Rotations, positions: Positions) -> None:
        """Change a finished pose so that the goals are met; for `Character.advance`.

        Args:
            heading: Where the body faces [rad].
            dt: Time since the last pose [s].
            rotations: Joints in the world, shape (joints, 4); rewritten.
            positions: Likewise [m], shape (joints, 3).
        """
        memory = self._memory
        if memory.progress.any() or (memory.fades > 0.0).any():
            meet_goals(self._body, memory, heading, dt, rotations, positions)

    def _side(self, hand: str) -> int:
        if hand not in get_args(Hand):
            raise UnknownNameError("hand", hand, list(get_args(Hand)))
        side = get_args(Hand).index(hand)
        if self._body.arms.limbs[side, 0] < 0:
            raise ArgumentError(f"a goal for the {hand} hand of a body without that arm")
        return side

    def _set(self, goal: int, place: Positions, weight: float, fade: float) -> None:
        memory = self._memory
        self._fade_in(goal, weight, fade)
        moved = memory.targets[goal] - place
        if memory.progress[goal] > 0.0 and np.linalg.norm(moved) > JUMP:
            memory.lags[goal] += moved
        elif memory.progress[goal] == 0.0:
            memory.lags[goal] = 0.0
        memory.targets[goal] = place

    def _fade_in(self, goal: int, weight: float, fade: float) -> None:
        _check_fade(fade)
        if not 0.0 <= weight <= 1.0:
            raise ArgumentError(f"a goal with a weight of {weight}; it must be within 0..1")
        memory = self._memory
        memory.wanted[goal] = weight
        if memory.progress[goal] == 0.0:
            memory.weights[goal] = weight
        if fade == 0.0:
            memory.progress[goal] = 1.0
        memory.fades[goal] = fade


def _check_fade(fade: float) -> None:
    if not (math.isfinite(fade) and fade >= 0.0):
        raise ArgumentError(f"a goal that fades in {fade} s; it must be finite and >= 0")


def _place(label: str, place: npt.ArrayLike) -> Positions:
    found = np.array(place, dtype=np.float64)
    if found.shape != (3,) or not np.isfinite(found).all():
        raise ArgumentError(f"{label} is {place}; it must be three finite numbers")
    return found
