"""Some actions of one character, mixed by hand: each has a share that may change at will."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from footfall.arrays import Weights
from footfall.engine.crowd import Crowd
from footfall.engine.priorities import PART_NAMES
from footfall.engine.state import EMPTY, RUNNING, WAITING

__all__ = ["MixedActions"]

STARTS, ENDS = 0.05, 0.02
"""Share from which an action is started, and below which it is stopped."""

FINE = 0.005
"""By how much a share has to differ to be set anew."""

SINGLE_PARTS = {name: parts for name, parts in PART_NAMES.items() if len(parts) == 1}
"""The body parts, each by its name."""


class MixedActions:
    """Starts, stops and weighs some actions of a character."""

    def __init__(self, crowd: Crowd, row: int, actions: Sequence[int]) -> None:
        """Begin with nothing known of them.

        Args:
            crowd: The crowd.
            row: Which of its characters.
            actions: Ids in its library.
        """
        self._crowd, self._row, self._actions = crowd, row, actions
        self._shares: Weights = np.full(len(actions), -1.0)

    @property
    def present(self) -> bool:
        """Whether one of them runs, waits or fades out."""
        status = self._status()
        return any(action in status for action in self._actions)

    def stop(self) -> None:
        """Stop all of them."""
        for action in self._actions:
            self._crowd.stop(action, [self._row])

    def weigh(self, shares: Weights, most: float) -> None:
        """Start, stop and weigh the actions.

        Args:
            shares: What each should have, summing to one, shape (actions,).
            most: By how much a share may change at once.
        """
        crowd, rows, status = self._crowd, [self._row], self._status()
        runs = any(
            share >= ENDS and status.get(action) == RUNNING
            for action, share in zip(self._actions, shares.tolist(), strict=True)
        )
        for place, action in enumerate(self._actions):
            share, there = float(shares[place]), status.get(action) in (WAITING, RUNNING)
            if share < ENDS:
                # Nothing is stopped before what comes instead is there.
                if runs and there:
                    crowd.stop(action, rows)
                continue
            if not there and share >= STARTS:
                crowd.start(action, rows)
                self._shares[place], there = -1.0, True
            known = float(self._shares[place])
            share = share if known < 0.0 else min(max(share, known - most), known + most)
            if there and abs(share - known) > FINE:
                crowd.set_priority(action, self._priority(action, share), rows, fade=0.0)
                self._shares[place] = share

    def _priority(self, action: int, share: float) -> dict[str, float]:
        """Return the priorities of an action, by body part, that has a share of the way."""
        own = self._crowd.library.actions[action].priority
        return {name: share * float(own[parts[0]]) for name, parts in SINGLE_PARTS.items()}

    def _status(self) -> dict[int, int]:
        """Return what every action does that has a seat."""
        me = self._crowd.characters[self._row]
        pairs = zip(me["action"].tolist(), me["status"].tolist(), strict=True)
        return {action: status for action, status in pairs if status != EMPTY}
