"""A crowd: many characters of one body, and the arrays of commands that drive them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.adaptation import AnyGround, Plane
from footfall.arrays import Positions, Rotations, Supports
from footfall.engine.commands import NO_SEAT, start_row, stop_row
from footfall.engine.library import MotionLibrary
from footfall.engine.pipeline import advance_blocks
from footfall.engine.placing import world_poses_of
from footfall.engine.priorities import parse_priority
from footfall.engine.record import SEATS
from footfall.engine.refusals import LATE, Late, check_patience, explain_wait
from footfall.engine.rows import Rows, check_rows
from footfall.engine.shelf import Shelf
from footfall.engine.standing import Standing
from footfall.engine.state import EMPTY, new_characters, new_workspace
from footfall.errors import ArgumentError, SkeletonError
from footfall.octets import LANES
from footfall.skeleton import Skeleton
from footfall.skeleton.octet_poses import PLACEMENT
from footfall.sync.refusal import Refusal
from footfall.sync.search_memory import SearchMemories
from footfall.sync.tables import Planner, Rules, rules_of

__all__ = ["Crowd"]


class Crowd(Standing):
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

        Raises:
            ArgumentError: If a number is out of range.
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
        self._work = new_workspace(self.skeleton.count)
        self._characters = new_characters(size, lookahead)
        self._characters["synchronized"] = synchronized
        self._characters["printed"] = footprints and synchronized
        self.ground = Plane() if ground is None else ground
        joints = self.skeleton.count
        self._poses = np.zeros((-(-size // LANES), joints, PLACEMENT, LANES), dtype=np.float32)
        self._stale = False
        self._world_positions = np.zeros((size, self.skeleton.count, 3))
        self._world_rotations = np.zeros((size, self.skeleton.count, 4))

    def _refresh(self) -> None:
        if len(self.library.actions) != self._known:
            self._shelf = self.library.shelf(self._planner)
            self._known = len(self.library.actions)

    def _check_action(self, action: int) -> int:
        if not 0 <= action < len(self.library.actions):
            raise ArgumentError(
                f"action {action}; the library has 0..{len(self.library.actions) - 1}"
            )
        self._refresh()
        return action

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

    def set_priority(
        self, action: int, priority: float | Mapping[str, float], rows: Rows = None
    ) -> None:
        """Change the priority of a running or waiting action.

        Args:
            action: Its id in the library.
            priority: As in `MotionLibrary.add`.
            rows: Which characters: row numbers, a mask, or None for all.

        Raises:
            ArgumentError: If the action or a row does not exist, or a number is out of range.
            UnknownNameError: If a body part is unknown.
        """
        action = self._check_action(action)
        values = parse_priority(priority)
        for row in check_rows(rows, self.size):
            seats = (self._characters["action"][row] == action) & (
                self._characters["status"][row] != EMPTY
            )
            self._characters["priorities"][row, seats] = values
            self._characters["priority"][row, seats] = values[0]
            self._characters["unsettled"][row] = True

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
        advance_blocks(
            self._shelf,
            self._packed_ground,
            self._rig,
            self._characters,
            self._work,
            self._rules,
            self._poses,
            float(dt),
            0,
            len(self._poses),
        )
        self._stale = True

    def _in_world(self) -> None:
        if self._stale:
            world_poses_of(
                self._characters, self._poses, self._world_rotations, self._world_positions
            )
            self._stale = False

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
        self._in_world()
        return self._world_positions

    @property
    def world_rotations(self) -> Rotations:
        """Joints in the world, shape (rows, joints, 4); a view that advance overwrites."""
        self._in_world()
        return self._world_rotations

    @property
    def supports(self) -> Supports:
        """What carries each character, values of `Support`, shape (rows,)."""
        return self._characters["support"]
