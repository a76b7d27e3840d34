"""Hundreds of characters that are started and stopped in groups."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Indices, Positions, Rotations
from footfall.engine import Crowd, MotionLibrary
from footfall.scenario.cue_sheet import ActionEntry
from footfall.scenario.motions import Motion
from footfall.scenario.preparation import add_action
from footfall.skeleton import Anatomy, Skeleton, find_anatomy

__all__ = ["GROUP_NAMES", "CrowdStage"]

GROUP_NAMES = ("A", "B", "C", "D", "E")
"""Of the groups: stripes of the field, from left to right."""

SPACING = 1.5
"""Between neighbors at the beginning [m]."""

RATE = 30.0
"""Frames per second."""

PALETTE = np.array(
    [[120, 134, 150], [59, 143, 208], [230, 145, 42], [53, 164, 122], [155, 110, 190],
     [214, 93, 120], [90, 170, 180], [178, 150, 60], [110, 120, 200],
     [141, 110, 85]], dtype=np.float64,
)  # fmt: skip
"""Of nothing, and of each action in turn."""


class CrowdStage:
    """A crowd of the engine on an endless field: who leaves it on one side enters on the other."""

    def __init__(
        self, entries: list[ActionEntry], motions: tuple[Motion, ...], size: int, *, seed: int = 7
    ) -> None:
        """Let a crowd stand in rows.

        Args:
            entries: Actions that can be started.
            motions: The motion of each.
            size: How many characters, >= 1.
            seed: Of their places and headings.
        """
        library = MotionLibrary()
        for entry, motion in zip(entries, motions, strict=True):
            add_action(library, entry, motion)
        self.names = tuple(entry.name for entry in entries)
        self.size = size
        self._crowd = Crowd(library, size)
        columns = int(np.ceil(np.sqrt(size)))
        self.width = columns * SPACING
        random = np.random.default_rng(seed)
        rows = np.arange(size)
        grid = np.stack([rows // columns, rows % columns], axis=-1) - 0.5 * (columns - 1)
        places = SPACING * grid + random.uniform(-0.35, 0.35, (size, 2))
        self._crowd.place(places, random.uniform(-0.2, 0.2, size))
        self.group: Indices = np.minimum(
            (rows // columns) * len(GROUP_NAMES) // columns, len(GROUP_NAMES) - 1
        )
        self._random = random
        self._pending: list[tuple[int, int, int]] = []
        self.frame = 0
        self._crowd.advance(0.0)

    @property
    def skeleton(self) -> Skeleton:
        """Of every body."""
        return self._crowd.skeleton

    @property
    def anatomy(self) -> Anatomy:
        """Of every body."""
        return find_anatomy(self._crowd.skeleton)

    @property
    def positions(self) -> Positions:
        """Joints in the world [m], shape (size, joints, 3)."""
        return self._crowd.world_positions

    @property
    def rotations(self) -> Rotations:
        """Joints in the world, shape (size, joints, 4)."""
        return self._crowd.world_rotations

    def start(self, name: str, group: int) -> None:
        """Start an action in a group, each member within half a second: no two march in step."""
        rows = np.flatnonzero(self.group == group)
        delays = self._random.integers(0, int(0.5 * RATE), len(rows))
        action = self.names.index(name)
        for row, delay in zip(rows.tolist(), delays.tolist(), strict=True):
            self._pending.append((self.frame + delay, action, row))
        self._pending.sort()

    def stop(self, name: str, group: int) -> None:
        """Stop an action in a group."""
        action = self.names.index(name)
        rows = set(np.flatnonzero(self.group == group).tolist())
        self._pending = [one for one in self._pending if one[1] != action or one[2] not in rows]
        self._crowd.stop(action, sorted(rows))

    def advance(self) -> None:
        """Let one frame pass."""
        while self._pending and self._pending[0][0] <= self.frame:
            _, action, row = self._pending.pop(0)
            self._crowd.start(action, [row])
        self._crowd.advance(1.0 / RATE)
        self.frame += 1

    def shifts(self) -> Positions:
        """Return how far each body is drawn beside where it is, onto the field, (size, 3)."""
        places = self.positions[:, 0]
        shifts = -self.width * np.floor(places / self.width + 0.5)
        shifts[:, 1] = 0.0
        return shifts

    def shares(self) -> Floats:
        """Return the leg weight of each action in each body, the rest first, (size, actions + 1).

        The rest is the neutral motion's.
        """
        states = self._crowd.characters
        shares = np.zeros((self.size, len(self.names) + 1))
        rows = np.arange(self.size)
        seats = states["action"].shape[1]
        for seat in range(seats):
            plays = states["status"][:, seat] >= 2
            shares[rows[plays], states["action"][plays, seat] + 1] += states["weights"][
                plays, seat, 0
            ]
        shares[:, 0] = np.clip(1.0 - shares[:, 1:].sum(axis=1), 0.0, 1.0)
        return shares

    def colors(self, shares: Floats) -> Floats:
        """Return the color of each body: that of what it does, mixed by weight, (size, 3)."""
        return shares @ PALETTE[np.arange(shares.shape[1]) % len(PALETTE)]

    def table(self, shares: Floats) -> list[list[float]]:
        """Return the mean share of each action in each group, the rest first."""
        return [
            [round(float(share), 3) for share in shares[self.group == group].mean(axis=0)]
            if (self.group == group).any()
            else [0.0] * shares.shape[1]
            for group in range(len(GROUP_NAMES))
        ]
