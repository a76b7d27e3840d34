"""A crowd: many characters of one body, and the arrays of commands that drive them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.adaptation import AnyGround, Plane
from footfall.arrays import Positions, Rotations, Supports
from footfall.engine.commands import NO_SEAT, start_row, stop_row
from footfall.engine.flight import Flight, flight_of
from footfall.engine.library import MotionLibrary
from footfall.engine.parameters import FINEST, Parameters
from footfall.engine.pipeline import advance_rows
from footfall.engine.reaching import Reaching
from footfall.engine.record import SEATS
from footfall.engine.refusals import LATE, Late, check_patience, explain_wait
from footfall.engine.rows import Rows, check_rows
from footfall.engine.shelf import Shelf
from footfall.engine.state import new_characters, new_workspace
from footfall.errors import ArgumentError, SkeletonError
from footfall.skeleton import Skeleton
from footfall.sync.refusal import Refusal
from footfall.sync.search_memory import SearchMemories
from footfall.sync.tables import Planner, Rules, rules_of

__all__ = ["Crowd"]


class Crowd(Reaching):
    """Characters that share a motion library and a body. One character is a crowd of one.

    Same commands, same bits: nothing here reads a clock or rolls dice.
    """

    def __init__(
        self,
        library: MotionLibrary,
        size: int = 1,
        *,
        skeleton: Skeleton | None = None,
        ground: AnyGround | None = None,
        planner: Planner = "footfall",
        lookahead: int = 5,
        synchronized: bool = True,
        footprints: bool = True,
        flight: Flight = "played",
    ) -> None:
        """Place characters at the origin, facing +z, doing nothing.

        Args:
            library: Its actions can be started, also those that are added later.
            size: How many characters, >= 1.
            skeleton: Their body, its joints in any order; by default the library's.
            ground: What they stand on; by default a plane at height 0.
            planner: "footfall", or "paper" for the rule as printed.
            lookahead: How many slots ahead phases are synchronized, >= 1.
            synchronized: Whether supports are synchronized at all; if not, motions are
                cross-faded as they are, joint by joint.
            footprints: Whether planted feet are held where they came down.
            flight: What happens while nothing carries: motions are "played" as they are; weights
                are "frozen" as they were at take-off; or the body is "ballistic" too, it falls
                freely however long the flight is made (S-27).

        Raises:
            ArgumentError: If a number is out of range, or the flight is unknown.
            SkeletonError: If the skeleton has other joints than the library's.
        """
        if size < 1:
            raise ArgumentError(f"a crowd of {size}; it needs at least 1 character")
        if lookahead < 1:
            raise ArgumentError(f"a look-ahead of {lookahead} slots; it must be at least 1")
        if skeleton is not None and not skeleton.same_family(library.skeleton):
            raise SkeletonError(
                f"a body of {skeleton.count} joints cannot perform motions of "
                f"{library.skeleton.count}; joint names and parents must be the same"
            )
        self.library = library
        self.size = size
        self.skeleton = (skeleton or library.skeleton).ordered_like(library.skeleton)
        self._planner: Planner = planner
        self._rules = rules_of(planner, ended="stop" if planner == "paper" else None)
        self._rig = library.rig(self.skeleton)
        self._shelf = library.shelf(planner)
        self._known = len(library.actions)
        self._parameters = Parameters()
        self._work = new_workspace(self.skeleton.count)
        self._characters = new_characters(size, lookahead)
        self._characters["synchronized"] = synchronized
        self._characters["printed"] = footprints and synchronized
        self._characters["flight"] = flight_of(flight)
        self.ground = Plane() if ground is None else ground
        self._world_positions = np.zeros((size, self.skeleton.count, 3))
        self._world_rotations = np.zeros((size, self.skeleton.count, 4))

    def _refresh(self) -> None:
        if len(self.library.actions) != self._known:
            self._shelf = self.library.shelf(self._planner)
            self._known = len(self.library.actions)
            self._parameters.write(self._shelf, self._characters, self.library.actions)

    def start(
        self,
        action: int,
        rows: Rows = None,
        *,
        patience: float = math.inf,
        late: Late = "give up",
    ) -> npt.NDArray[np.bool_]:
        """Start an action, or let it wait for its moment.

        Args:
            action: Its id in the library.
            rows: Which characters: row numbers, a mask, or None for all.
            patience: How long it waits at most [s], >= 0; for ever by default.
            late: What becomes of it then: "give up", or "mute" to go on without its legs.

        Returns:
            Whether it runs now, for each of the rows; where not, it waits for its moment.

        Raises:
            ArgumentError: If an argument is out of range, or a character has its hands full.
        """
        check_patience(patience, late)
        action = self._check_action(action)
        chosen = check_rows(rows, self.size)
        started = np.zeros(len(chosen), dtype=np.bool_)
        search, patience, then = self._work.search, float(patience), LATE[late]
        for place, row in enumerate(chosen):
            code = start_row(
                self._shelf, self._characters, search, self._rules, int(row), action, patience, then
            )
            if code == NO_SEAT:
                raise ArgumentError(
                    f"character {row} already has {SEATS} actions running, waiting or fading; "
                    "stop one first"
                )
            started[place] = code > 0
        return started

    def refusal(self, action: int, row: int) -> Refusal:
        """Say why an action of one character waits, and when it will start.

        Raises:
            ArgumentError: If it does not wait, or does not exist.
        """
        me, action = self._characters[check_rows([row], self.size)[0]], self._check_action(action)
        return explain_wait(self._shelf, me, self._work.search, self._rules, self.library, action)

    def stop(self, action: int, rows: Rows = None) -> None:
        """Let an action fade out, or cancel its waiting start.

        Args:
            action: Its id in the library.
            rows: Which characters: row numbers, a mask, or None for all.

        Raises:
            ArgumentError: If the action or a row does not exist.
        """
        action = self._check_action(action)
        for row in check_rows(rows, self.size):
            stop_row(self._shelf, self._characters, int(row), action)

    def advance(self, dt: float) -> None:
        """Let time pass for everybody.

        Args:
            dt: How much [s], >= 0 and finite; 0 only works out the poses.

        Raises:
            ArgumentError: If `dt` is negative or not finite.
        """
        if not (0.0 <= dt < float("inf")):
            raise ArgumentError(f"dt is {dt} s; it must be finite and >= 0")
        self._refresh()
        while self._parameters.moving and dt > 0.0:
            step = min(dt, FINEST)
            self._parameters.advance(self._shelf, self._characters, self.library.actions, step)
            self._advance(step)
            dt -= step
            if dt <= 0.0:
                return
        self._advance(dt)

    def _advance(self, dt: float) -> None:
        advance_rows(
            self._shelf,
            self._packed_ground,
            self._rig,
            self._characters,
            self._work,
            self._rules,
            self._world_rotations,
            self._world_positions,
            float(dt),
        )
        self._move_hands(self._world_rotations, self._world_positions, dt)

    @property
    def shelf(self) -> Shelf:
        """The library as the kernels take it."""
        self._refresh()
        return self._shelf

    @property
    def search(self) -> SearchMemories:
        """Memory of the planner."""
        return self._work.search

    @property
    def rules(self) -> Rules:
        """The rules of the planner."""
        return self._rules

    @property
    def characters(self) -> npt.NDArray[Any]:
        """Everything the crowd remembers: records of `Character`, shape (rows,); a view."""
        return self._characters

    @property
    def world_positions(self) -> Positions:
        """Joints in the world [m], shape (rows, joints, 3); a view that advance overwrites."""
        return self._world_positions

    @property
    def world_rotations(self) -> Rotations:
        """Joints in the world, shape (rows, joints, 4); a view that advance overwrites."""
        return self._world_rotations

    @property
    def supports(self) -> Supports:
        """What carries each character, values of `Support`, shape (rows,)."""
        return self._characters["support"]
