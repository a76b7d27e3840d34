"""The contact bands of a clip: what is dragged, split and deleted, and what comes of it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from footfall.detection import Contacts, Interval, contact_supports
from footfall.errors import ArgumentError
from footfall.support import SupportSequence

__all__ = ["SHORTEST", "Bands"]

SHORTEST = 0.01
"""A band, and a gap between two, lasts at least this long [s]."""

Foot = tuple[Interval, ...]


@dataclass(frozen=True, eq=False)
class Bands:
    """When each foot of a clip carries, as its user wants it.

    On a cycle a band begins in [0, duration) and may end beyond it.
    """

    feet: tuple[Foot, Foot]
    """Of the left and of the right foot, in order, apart from each other."""

    duration: float
    """Of the clip [s]."""

    cyclic: bool
    """Whether the last band is followed by the first."""

    @classmethod
    def of(cls, sequence: SupportSequence, duration: float) -> Bands:
        """Return the bands that a support sequence says."""
        bounds = sequence.boundaries
        feet: list[Foot] = []
        for left in (True, False):
            found: list[Interval] = []
            for index, phase in enumerate(sequence.phases):
                if not (phase.support.left if left else phase.support.right):
                    continue
                start, end = bounds[index], bounds[index + 1]
                if found and abs(found[-1].end - start) < 1e-9:
                    found[-1] = replace(found[-1], end=end)
                else:
                    found.append(Interval(start, end))
            feet.append(_on_cycle(found, duration) if sequence.cyclic else tuple(found))
        return cls((feet[0], feet[1]), duration, sequence.cyclic)

    def sequence(self, contacts: Contacts) -> SupportSequence:
        """Return the support sequence that the bands say.

        Args:
            contacts: Those of the clip; only their times are replaced.
        """
        return contact_supports(replace(contacts, intervals=self.feet), min_duration=0.0)

    def with_edge(self, foot: int, band: int, side: str, time: float) -> Bands:
        """Return the bands with one edge moved as near to a time [s] as its neighbors let it.

        Raises:
            ArgumentError: If there is no such band, or the time is not finite.
        """
        self._check(foot, band, time)
        row = list(self.feet[foot])
        one = row[band]
        low, high = self._room(foot, band)
        if self.cyclic:
            # The edge is moved the short way round.
            near = one.start if side == "start" else one.end
            time += self.duration * round((near - time) / self.duration)
        if side == "start":
            row[band] = replace(one, start=float(np.clip(time, low, one.end - SHORTEST)))
        else:
            row[band] = replace(one, end=float(np.clip(time, one.start + SHORTEST, high)))
        return self._with(foot, row)

    def with_split(self, foot: int, time: float) -> Bands:
        """Return the bands with the one at a time [s] cut in two, a short gap between them.

        Raises:
            ArgumentError: If no band is there, or it is too short to be cut.
        """
        band, time = self._at(foot, time)
        one = self.feet[foot][band]
        half = min(0.03, 0.25 * one.duration)
        first = replace(one, end=time - half)
        second = replace(one, start=time + half)
        if min(first.duration, second.duration) < SHORTEST:
            raise ArgumentError(
                f"a band cannot be split {min(time - one.start, one.end - time):.3f} s from its "
                f"edge; each part must last {SHORTEST + half:.3f} s"
            )
        row = [*self.feet[foot][:band], first, second, *self.feet[foot][band + 1 :]]
        return self._with(foot, row)

    def without(self, foot: int, band: int) -> Bands:
        """Return the bands with one deleted.

        Raises:
            ArgumentError: If there is no such band.
        """
        self._check(foot, band, 0.0)
        return self._with(foot, [*self.feet[foot][:band], *self.feet[foot][band + 1 :]])

    def with_band(self, foot: int, start: float, end: float) -> Bands:
        """Return the bands with one more, as far as the others leave it room [s].

        Raises:
            ArgumentError: If there is no room, or a time is not finite.
        """
        if foot not in (0, 1) or not (np.isfinite(start) and np.isfinite(end)):
            raise ArgumentError(f"foot {foot} from {start} to {end} s; foot 0 or 1 is needed")
        start, end = sorted((float(start), float(end)))
        start, end = max(start, 0.0), min(end, self.duration)
        for other in self._copies(self.feet[foot]):
            if other.start < end and other.end > start:
                if other.start <= start:
                    start = other.end + SHORTEST
                else:
                    end = other.start - SHORTEST
        if end - start < SHORTEST:
            raise ArgumentError("there is no room for another band here")
        return self._with(foot, [*self.feet[foot], Interval(start, end)])

    def _with(self, foot: int, row: list[Interval]) -> Bands:
        row = list(_on_cycle(row, self.duration)) if self.cyclic else row
        row.sort(key=lambda one: one.start)
        feet = list(self.feet)
        feet[foot] = tuple(row)
        return replace(self, feet=(feet[0], feet[1]))

    def _room(self, foot: int, band: int) -> tuple[float, float]:
        """Return the earliest start and the latest end that one band may have [s]."""
        row = self.feet[foot]
        low, high = 0.0, self.duration
        if self.cyclic:
            before = row[band - 1].end - (self.duration if band == 0 else 0.0)
            after = row[(band + 1) % len(row)].start
            after += self.duration if band == len(row) - 1 else 0.0
            low, high = before + SHORTEST, after - SHORTEST
            if len(row) == 1:
                # All the way round: it may close on itself.
                low, high = row[0].end - self.duration, row[0].start + self.duration
            return low, high
        if band > 0:
            low = row[band - 1].end + SHORTEST
        if band < len(row) - 1:
            high = row[band + 1].start - SHORTEST
        return low, high

    def _at(self, foot: int, time: float) -> tuple[int, float]:
        for turn in (0.0, self.duration) if self.cyclic else (0.0,):
            for index, one in enumerate(self.feet[foot]):
                if one.start <= time + turn <= one.end:
                    return index, time + turn
        raise ArgumentError(f"no band at {time:.3f} s; split one where it is")

    def _copies(self, row: Foot) -> list[Interval]:
        turns = (-self.duration, 0.0, self.duration) if self.cyclic else (0.0,)
        return [one.later(turn) for turn in turns for one in row]

    def _check(self, foot: int, band: int, time: float) -> None:
        if foot not in (0, 1) or not 0 <= band < len(self.feet[foot]) or not np.isfinite(time):
            raise ArgumentError(f"no band {band} of foot {foot} to move to {time} s")


def _on_cycle(row: list[Interval], duration: float) -> Foot:
    """Return bands that begin in [0, duration), those that meet over the end joined."""
    moved = [one.later(-duration * np.floor(one.start / duration)) for one in row]
    moved.sort(key=lambda one: one.start)
    if len(moved) > 1 and abs(moved[-1].end - duration - moved[0].start) < 1e-9:
        last = moved.pop()
        moved[0] = Interval(last.start, moved[0].end + duration)
        moved.sort(key=lambda one: one.start)
    return tuple(moved)
