"""A start that has to wait: how long it may, what becomes of it then, and why it waits."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from footfall.engine.library import MotionLibrary
from footfall.engine.planning import copy_window
from footfall.engine.shelf import Shelf
from footfall.engine.state import GIVES_UP, STARTS_MUTED, WAITING
from footfall.errors import ArgumentError
from footfall.sync.refusal import Refusal, foresee
from footfall.sync.search_memory import PlannerMemory
from footfall.sync.tables import Rules

__all__ = ["LATE", "Late", "check_patience", "explain_wait"]

Late = Literal["give up", "mute"]
"""What becomes of a start that has waited too long."""

LATE = {"give up": GIVES_UP, "mute": STARTS_MUTED}


def check_patience(patience: float, late: str) -> None:
    """Check how long a start may wait [s], and what becomes of it then.

    Raises:
        ArgumentError: If it is less than 0 s, or there is no such choice.
    """
    if not patience >= 0.0:
        raise ArgumentError(f"a patience of {patience} s; it must be at least 0")
    if late not in LATE:
        raise ArgumentError(f'late is {late!r}; it must be "give up" or "mute"')


def explain_wait(
    shelf: Shelf,
    character: npt.NDArray[Any],
    search: PlannerMemory,
    rules: Rules,
    library: MotionLibrary,
    action: int,
) -> Refusal:
    """Say why an action waits, and how long.

    Args:
        shelf: The library, packed.
        character: One record of `character_type`.
        search: Any working memory of the planner.
        rules: The rules of the planner.
        library: The library.
        action: Its id in the library.

    Raises:
        ArgumentError: If it does not wait.
    """
    seats = np.flatnonzero((character["action"] == action) & (character["status"] == WAITING))
    if len(seats) == 0:
        name = library.actions[action].name
        raise ArgumentError(f"{name!r} does not wait, so nothing explains why")
    window = copy_window(character, search)
    refusal = foresee(
        shelf.table,
        window,
        rules,
        int(seats[0]),
        [library.actions[int(other)].name for other in character["action"]],
        elapsed=float(character["slot_progress"]),
    )
    return refusal or Refusal("waits for the next slot", float(window.durations[0]), False)
