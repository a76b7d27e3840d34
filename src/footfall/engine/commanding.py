"""The commands of a crowd: they are given for many rows at once, and carried out in a kernel."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.arrays import Indices, Seconds
from footfall.engine.bodies import Bodies, Repertoire
from footfall.engine.cohorts import Cohort
from footfall.engine.commands import (
    NOBODY,
    catch_up_rows,
    prioritize_rows,
    row_without_seat,
    start_rows,
    stop_rows,
)
from footfall.engine.library import MotionLibrary
from footfall.engine.parameters import Parts
from footfall.engine.priorities import parse_priority
from footfall.engine.record import SEATS
from footfall.engine.refusals import LATE, Late, check_patience, explain_wait
from footfall.engine.rows import Rows, check_present
from footfall.engine.shelf import Shelf
from footfall.engine.state import Workspace
from footfall.engine.workers import Workers
from footfall.errors import ArgumentError
from footfall.skeleton.rig import Rig
from footfall.sync.refusal import Refusal
from footfall.sync.search_memory import PlannerMemory
from footfall.sync.tables import Rules

__all__ = ["Commanding"]


BY_ITSELF = -1.0
"""Stands for a change of priority that takes as long as the action's fade in."""


class Commanding:
    """The part of a crowd that is told what to do."""

    library: MotionLibrary
    _characters: npt.NDArray[Any]
    _rules: Rules
    _bodies: Bodies
    _cohorts: tuple[Cohort, ...]
    _body_of_row: Indices
    _workers: Workers

    def _refresh(self) -> None:
        """Take over actions that the library has learned since."""
        if self._bodies.repertoires[0].behind:
            self._bodies.learn()
            for repertoire in self._bodies.repertoires:
                repertoire.write(self._parts(repertoire))

    def _parts(self, repertoire: Repertoire) -> Parts:
        """Return all who perform some motions, cohort by cohort."""
        bodies = self._bodies.all
        return [
            (bodies[cohort.span.body].shelf, cohort.characters)
            for cohort in self._cohorts
            if bodies[cohort.span.body].repertoire is repertoire
        ]

    def _by_shelf(self, chosen: Indices) -> list[tuple[Shelf, Indices]]:
        """Return the library as each body takes it, and which of some rows have that body."""
        bodies = self._bodies.all
        if len(bodies) == 1:
            return [(bodies[0].shelf, np.arange(len(chosen)))]
        kinds = self._body_of_row[chosen]
        return [(body.shelf, np.flatnonzero(kinds == index)) for index, body in enumerate(bodies)]

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
        ahead: npt.ArrayLike = 0.0,
    ) -> npt.NDArray[np.bool_]:
        """Start an action, or let it wait for its moment.

        Args:
            action: Its id in the library.
            rows: Which characters: row numbers, a mask, or None for all.
            patience: How long it waits at most [s], >= 0; for ever by default.
            late: What becomes of it then: "give up", or "mute" to go on without its legs.
            ahead: How long ago it began [s], >= 0, so that a crowd does not march in step: one
                number or one a row. Only for characters that have shown nothing yet.

        Returns:
            Whether it runs now, for each of the rows; where not, it waits for its moment.

        Raises:
            ArgumentError: If an argument is out of range, or a character has its hands full;
                then nobody starts.
        """
        check_patience(patience, late)
        action = self._check_action(action)
        chosen = check_present(rows, self._characters)
        seconds = self._check_ahead(ahead, chosen)
        shelves = self._by_shelf(chosen)
        for shelf, places in shelves:
            full = row_without_seat(shelf, self._characters, chosen[places], action)
            if full != NOBODY:
                raise ArgumentError(
                    f"character {full} already has {SEATS} actions running, waiting or fading; "
                    "stop one first"
                )
        started = np.zeros(len(chosen), dtype=np.bool_)
        for shelf, places in shelves:
            told = shelf, self._characters, self.search, self._rules
            runs, waits = np.zeros(len(places), dtype=np.bool_), (float(patience), LATE[late])
            start_rows(*told, chosen[places], action, *waits, runs)
            started[places] = runs
            early = places[runs & (seconds[places] > 0.0)]
            if len(early):
                catch_up_rows(*told, chosen[early], seconds[early])
        return started

    def _check_ahead(self, ahead: npt.ArrayLike, chosen: npt.NDArray[np.int64]) -> Seconds:
        seconds = np.array(np.broadcast_to(np.asarray(ahead, dtype=np.float64), chosen.shape))
        wrong = ~(np.isfinite(seconds) & (seconds >= 0.0))
        if wrong.any():
            raise ArgumentError(f"ahead is {seconds[wrong][0]} s; it must be finite and >= 0")
        shown = chosen[(seconds > 0.0) & (self._characters["fresh"][chosen] == 0)]
        if len(shown):
            raise ArgumentError(
                f"character {shown[0]} has been shown already; only one that has not can be ahead"
            )
        return seconds

    def refusal(self, action: int, row: int) -> Refusal:
        """Say why an action of one character waits, and when it will start.

        Raises:
            ArgumentError: If it does not wait, or does not exist.
        """
        chosen = check_present([row], self._characters)
        me = self._characters[chosen[0]]
        action = self._check_action(action)
        shelf = next(shelf for shelf, places in self._by_shelf(chosen) if len(places))
        return explain_wait(shelf, me, self.search, self._rules, self.library, action)

    def stop(self, action: int, rows: Rows = None) -> None:
        """Let an action fade out, or cancel its waiting start.

        Args:
            action: Its id in the library.
            rows: Which characters: row numbers, a mask, or None for all.

        Raises:
            ArgumentError: If the action or a row does not exist.
        """
        action = self._check_action(action)
        chosen = check_present(rows, self._characters)
        for shelf, places in self._by_shelf(chosen):
            stop_rows(shelf, self._characters, chosen[places], action)

    def set_priority(
        self,
        action: int,
        priority: float | Mapping[str, float],
        rows: Rows = None,
        *,
        fade: float | None = None,
    ) -> None:
        """Change the priority of a running or waiting action; its weights come to it smoothly.

        Args:
            action: Its id in the library.
            priority: As in `MotionLibrary.add`. It may be given in every frame: weights follow.
            rows: Which characters: row numbers, a mask, or None for all.
            fade: In what time [s], >= 0, 0 being at once; None: in that of the action's fade in.
                Weights of the legs wait as in fades, at most as long again.

        Raises:
            ArgumentError: If the action or a row does not exist, or a number is out of range.
            UnknownNameError: If a body part is unknown.
        """
        action = self._check_action(action)
        values = parse_priority(priority)
        chosen = check_present(rows, self._characters)
        if fade is not None and not (0.0 <= fade < math.inf):
            raise ArgumentError(f"fade is {fade} s; it must be finite and >= 0")
        seconds = BY_ITSELF if fade is None else float(fade)
        for shelf, places in self._by_shelf(chosen):
            prioritize_rows(shelf, self._characters, chosen[places], action, values, seconds)

    @property
    def shelf(self) -> Shelf:
        """The library as the kernels take it, for the body of the first cohort."""
        self._refresh()
        return self._bodies.all[0].shelf

    @property
    def search(self) -> PlannerMemory:
        """Memory of the planner."""
        return self._workers.search

    def kernel_body_of(self, row: int) -> tuple[Shelf, Rig, Workspace]:
        """Return the library as the kernels take it for the body of a row, the body, and memory."""
        body = self._bodies.all[int(self._body_of_row[row])]
        return body.shelf, body.rig, self._workers.workspaces(body.skeleton.count)[0]

    @property
    def rules(self) -> Rules:
        """The rules of the planner."""
        return self._rules
