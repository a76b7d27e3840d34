"""Reach and grasp: the commands for the hands of a crowd, and what has become of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from footfall.arrays import Positions
from footfall.engine.hand_record import FREE, HOLDS, REACHES, new_hands
from footfall.engine.hands import CLOSE, move_hands
from footfall.engine.rows import Rows, check_present
from footfall.engine.steering import Steering
from footfall.errors import ArgumentError, SkeletonError

__all__ = ["HandState", "Reaching", "Side"]

Side = Literal["left", "right"]
"""Which hand."""

SIDES: tuple[Side, Side] = ("left", "right")


@dataclass(frozen=True, slots=True)
class HandState:
    """What one hand does now."""

    task: Literal["free", "reaches", "holds"]
    """Whether it goes its own way, goes for a point, or carries what it took there."""

    weight: float
    """How much the reach rather than the motion moves the arm, 0 to 1."""

    palm: tuple[float, float, float]
    """Where the palm is in the world [m]; where it was, while it has never reached."""

    object: tuple[float, float, float]
    """Where what it reaches for, or carries, is in the world [m]."""

    missing: float
    """How far the arm is too short for the point [m]; millimeters where it is nearly straight."""

    @property
    def problem(self) -> str:
        """What keeps it from its point, in words; empty where nothing does."""
        if self.task != "reaches" or self.missing < CLOSE:
            return ""
        x, y, z = self.object
        return f"({x:.2f}, {y:.2f}, {z:.2f}) is {self.missing:.2f} m out of reach"


class Reaching(Steering):
    """The part of a crowd that moves hands."""

    _hands: npt.NDArray[Any] | None = None

    def reach(
        self,
        hand: Side,
        point: npt.ArrayLike,
        rows: Rows = None,
        *,
        grasp: bool = False,
        fade: float = 0.4,
    ) -> None:
        """Let a hand go for a point; one that already does follows the new one smoothly.

        It takes no part in the schedule: legs go on as they do.

        Args:
            hand: Which one.
            point: Where in the world [m], shape (3,) or (rows, 3).
            rows: Which characters: row numbers, a mask, or None for all.
            grasp: Whether it closes on what is there, and then carries it along.
            fade: How long it takes to get there, and back [s], > 0.

        Raises:
            ArgumentError: If the hand or a row does not exist, or a number is out of range.
            SkeletonError: If the body has no such arm.
        """
        side = self._side(hand)
        chosen = check_present(rows, self._characters)
        points = np.broadcast_to(np.asarray(point, dtype=np.float64), (len(chosen), 3))
        if not np.isfinite(points).all():
            raise ArgumentError(f"the point of a reach is {point}; it must be finite")
        if not 0.0 < fade < float("inf"):
            raise ArgumentError(f"the fade of a reach is {fade} s; it must be finite and > 0")
        kinds: list[int] = np.unique(self._body_of_row[chosen]).tolist()
        for kind in kinds:
            if self._bodies.all[kind].palms.arms.limbs[side, 2] < 0:
                raise SkeletonError(
                    f"the skeleton has no {hand} arm that is known by its names; it cannot reach"
                )
        hands = self._make_hands()
        for row, place in zip(chosen, points, strict=True):
            one = hands[row, side]
            if one["progress"] <= 0.0:
                one["aim"], one["aim_velocity"] = place, 0.0
            one["point"], one["held"] = place, place
            one["task"], one["closes"], one["fade"] = REACHES, grasp, fade

    def release(self, hand: Side, rows: Rows = None) -> None:
        """Let a hand go back to its own motion; what it carries stays where it is now.

        Raises:
            ArgumentError: If the hand or a row does not exist.
        """
        side, chosen = self._side(hand), check_present(rows, self._characters)
        if self._hands is not None:
            self._hands["task"][chosen, side] = FREE

    def hand(self, hand: Side, row: int = 0) -> HandState:
        """Return what a hand of one character does now.

        Raises:
            ArgumentError: If the hand or the row does not exist.
        """
        side, row = self._side(hand), int(check_present([row], self._characters)[0])
        if self._hands is None:
            return HandState("free", 0.0, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0)
        one = self._hands[row, side]
        tasks: dict[int, Literal["free", "reaches", "holds"]] = {REACHES: "reaches", HOLDS: "holds"}
        progress = float(one["progress"])
        return HandState(
            tasks.get(int(one["task"]), "free"),
            progress * progress * (3.0 - 2.0 * progress),
            _triple(one["palm"]),
            _triple(one["held"]),
            float(one["missing"]),
        )

    def _move_hands(self, dt: float) -> None:
        """Turn the arms of poses that have just been worked out."""
        if self._hands is None:
            return
        for cohort in self._cohorts:
            move_hands(
                self._bodies.all[cohort.span.body].palms,
                cohort.characters,
                self._hands[cohort.span.first : cohort.span.end],
                cohort.world_rotations,
                cohort.world_positions,
                dt,
            )

    def _make_hands(self) -> npt.NDArray[Any]:
        """Return the hands of everybody; until one is needed there are none."""
        if self._hands is None:
            self._hands = new_hands(len(self._characters))
        return self._hands

    def _make_hands_room(self, rows: int) -> None:
        """Let as many characters have hands; those of the new ones are free."""
        if self._hands is not None:
            hands = new_hands(rows)
            hands[: len(self._hands)] = self._hands
            self._hands = hands

    def _side(self, hand: Side) -> int:
        if hand not in SIDES:
            raise ArgumentError(f"no hand {hand!r}; there are left and right")
        return SIDES.index(hand)


def _triple(place: Positions) -> tuple[float, float, float]:
    x, y, z = place.tolist()
    return x, y, z
