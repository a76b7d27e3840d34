"""A character whose clips are kept in step by somebody else's method.

Everything but the time of its clips is the engine's unsynchronized cross-fade: the same poses, the
same fades, the same weighted root motion.
"""

from __future__ import annotations

import math

import numpy as np

from footfall.baselines.pacing import Pacing, Playing
from footfall.engine import Character, Frame
from footfall.engine.pipeline import LONGEST_STEP
from footfall.engine.record import SEATS
from footfall.engine.state import RUNNING
from footfall.skeleton import BodyPart, Skeleton

__all__ = ["PacedCharacter"]


class PacedCharacter(Character):
    """A character that cross-fades its motions, their clips driven by a `Pacing`."""

    def __init__(self, skeleton: Skeleton, pacing: Pacing, **options: object) -> None:
        """Prepare a character.

        Args:
            skeleton: Its body.
            pacing: Where its clips are.
            options: As of `Character`, but for `synchronized` and `footprints`.
        """
        options |= {"synchronized": False, "footprints": False}
        super().__init__(skeleton, **options)  # pyright: ignore[reportArgumentType]
        self._pacing = pacing
        self._entered = np.zeros(SEATS, dtype=np.int64)

    def advance(self, dt: float) -> Frame:
        """Let time pass; as `Character.advance`."""
        steps = max(1, math.ceil(dt / LONGEST_STEP - 1e-9)) if 0.0 < dt < math.inf else 0
        for _ in range(steps - 1):
            self._step(dt / steps)
        return self._step(dt / steps) if steps else super().advance(dt)

    def _step(self, dt: float) -> Frame:
        me = self.crowd.characters[0]
        seats = sorted(
            (seat for seat in range(SEATS) if me["status"][seat] >= RUNNING),
            key=lambda seat: me["age"][seat],
        )
        actions = self.library.actions
        playing = [
            Playing(
                actions[int(me["action"][seat])].supports,
                float(me["clip_time"][seat]),
                float(me["weights"][seat, BodyPart.LEGS]),
                bool(self._entered[seat] != me["age"][seat]),
            )
            for seat in seats
        ]
        times = self._pacing.clip_times(playing, dt)
        for seat, one, time in zip(seats, playing, times, strict=True):
            self._entered[seat] = me["age"][seat]
            if one.entering:
                me["posed_time"][seat] = max(time - dt, 0.0)
            # The engine lets every clip that is at its own speed go on by `dt` itself.
            me["clip_time"][seat] = time - dt
            me["rate"][seat] = 1.0
        frame = super().advance(dt)
        for seat, one, time in zip(seats, playing, times, strict=True):
            if one.supports.cyclic:
                me["rate"][seat] = 1.0 if one.entering else (time - one.clip_time) / dt
        return frame
