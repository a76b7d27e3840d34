"""A gait that follows a speed and a turn: several cycles laid over each other, phase by phase.

How much there is of each cycle says `stride_shares`. Durations are weighted means too; where a walk
becomes a run the double support is a length that goes below zero, and there becomes a flight.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from footfall.actions.cycle_poses import (
    channel_clocks,
    posed,
    root_steps,
    root_way,
    root_ways,
    turned_steps,
)
from footfall.actions.cycles import ONE_FOOT, GaitCycle, aligned_to, check_distinct
from footfall.actions.foot_times import (
    event_times,
    foot_events,
    left_shares,
    mapped_times,
    mixed_phases,
)
from footfall.actions.stride_shares import Strides, stride_shares
from footfall.arrays import Floats, Indices, Seconds, SmallFloats, Weights
from footfall.errors import ArgumentError
from footfall.geometry import continuous
from footfall.support import Support, SupportPhase, SupportSequence

__all__ = ["CycleMix", "Locomotion"]

SHORTEST = 0.04
"""A double support or a flight that goes through zero is never shorter [s]."""

STRETCH = (0.8, 1.25)
"""A mix is played at most so much slower or faster for its speed to be the one asked for."""

SLACK = 0.02
"""How far a value may be beyond the clips' [m/s, rad/s]: rounding in the caller's numbers."""


class CycleMix(NamedTuple):
    """The cycle that belongs to one speed and turn."""

    keys: SmallFloats
    """Normalized poses, shape (frames, channels); the last frame is the first one again."""

    roots: Floats
    """x and z in leg lengths, heading [rad], shape (frames, 3)."""

    supports: SupportSequence
    """What it stands on, from time zero on."""

    shares: Weights
    """How much of each clip is in it, summing to one, shape (clips,)."""


class Locomotion:
    """Several cyclic clips that become one another by speed and turn."""

    def __init__(self, cycles: Sequence[GaitCycle], leg_sides: Indices, leg_length: float) -> None:
        """Lay the cycles over each other.

        Args:
            cycles: At least one, of one body; at different speeds or turns.
            leg_sides: Which leg each joint of the body belongs to, as in `Rig`, shape (joints,).
            leg_length: Of the body [m].

        Raises:
            ArgumentError: If there is none, they step differently, or two are alike.
        """
        if not cycles:
            raise ArgumentError("a locomotion of no clip; it needs at least one")
        self.cycles: tuple[GaitCycle, ...] = (
            cycles[0],
            *(aligned_to(cycles[0], other) for other in cycles[1:]),
        )
        ways, turns = np.array([cycle.stride for cycle in self.cycles]).T
        durations = np.array([cycle.duration for cycle in self.cycles])
        self._strides = Strides(ways * leg_length, turns, durations)
        self.speeds = self._strides.ways / durations
        self.turns = turns / durations
        order: list[int] = np.lexsort((self.turns, self.speeds)).tolist()
        check_distinct(
            [(cycles[i].name, float(self.speeds[i]), float(self.turns[i])) for i in order]
        )
        mixed = mixed_phases(self.cycles)
        self._events = [foot_events(self.cycles[0].supports, mixed, side) for side in range(2)]
        self._legs, self._leg_length = channel_clocks(leg_sides), leg_length
        longest = max(cycle.duration * cycle.fps for cycle in self.cycles)
        self.frames = round(longest) + 1

    def checked(
        self,
        speed: float | None,
        turn: float | None,
        default: tuple[float, float] | None = None,
    ) -> tuple[float, float]:
        """Return a speed [m/s] and a turn [rad/s] that the clips reach.

        Args:
            speed: As asked for; None: the default.
            turn: Likewise.
            default: By default those of the first clip.

        Raises:
            ArgumentError: If one is beyond the clips, or not finite.
        """
        own = (float(self.speeds[0]), float(self.turns[0])) if default is None else default
        speed, turn = own[0] if speed is None else speed, own[1] if turn is None else turn
        for label, value, unit, own in (
            ("speed", speed, "m/s", self.speeds),
            ("turn", turn, "rad/s", self.turns),
        ):
            least, most = float(own.min()), float(own.max())
            if not least - SLACK <= value <= most + SLACK:
                raise ArgumentError(
                    f"{label} is {value} {unit}; the clips go from {least:.2f} to {most:.2f} {unit}"
                )
        return float(speed), float(turn)

    def shares(self, speed: float, turn: float) -> Weights:
        """Return how much of each clip belongs to a speed [m/s] and a turn [rad/s], (clips,)."""
        return stride_shares(self._strides, speed, turn)

    def mix(self, speed: float, turn: float, kept: Mapping[int, Support] | None = None) -> CycleMix:
        """Return the cycle of a speed and a turn.

        Args:
            speed: Forward [m/s].
            turn: To the left [rad/s].
            kept: What must stay as it is, by phase: a phase that is being played does not change
                its support before its end (S-17).
        """
        shares = self.shares(speed, turn)
        kinds, starts, begin = self._phases(shares, {} if kept is None else kept)
        times: Seconds = np.linspace(0.0, float(starts[-1]), self.frames)
        middles: Seconds = 0.5 * (times[1:] + times[:-1])
        keys, roots = self._poses(shares, times, begin, left_shares(middles, kinds, starts))
        natural = self._leg_length * float(root_ways(roots)[:, 1].sum()) / starts[-1]
        if abs(natural) > 0.1 and natural * speed > 0.0:
            starts = starts / np.clip(speed / natural, *STRETCH)
        phases = zip(kinds, np.diff(starts).tolist(), strict=True)
        sequence = SupportSequence(tuple(SupportPhase(k, d) for k, d in phases), cyclic=True)
        return CycleMix(keys, roots, sequence, shares)

    def _phases(
        self, shares: Weights, kept: Mapping[int, Support]
    ) -> tuple[list[Support], Seconds, float]:
        """Return what the phases stand on, their boundaries [s], and when the first one begins.

        Boundaries count from that moment; it counts from the mean of the cycles' own first ones.
        """
        kinds = list(self.cycles[0].supports)
        own = np.stack([cycle.starts - cycle.starts[0] for cycle in self.cycles])
        starts = shares @ own
        period = float(starts[-1])
        for phase in range(len(kinds)):
            if all(cycle.supports[phase] in ONE_FOOT for cycle in self.cycles):
                continue
            signs = [1.0 if c.supports[phase] is Support.DOUBLE else -1.0 for c in self.cycles]
            middle = float(shares @ (0.5 * (own[:, phase] + own[:, phase + 1])))
            length = float(shares @ (np.array(signs) * (own[:, phase + 1] - own[:, phase])))
            kinds[phase] = Support.DOUBLE if length > 0.0 else Support.FLIGHT
            if phase in kept and kept[phase] is not kinds[phase]:
                kinds[phase], length = kept[phase], SHORTEST
            half = 0.5 * max(abs(length), SHORTEST)
            starts[phase], starts[phase + 1] = middle - half, middle + half
        # The last phase may have moved the beginning of the first one, a cycle later.
        begin = float(starts[-1]) - period
        starts[0] = begin
        return kinds, starts - begin, begin

    def _clocks(self, shares: Weights, begin: float, times: Seconds) -> list[Floats]:
        """Return the frames of each cycle at some times of the mix, shape (3, times) each.

        Those of the left leg, of the right leg, and of the rest of the body: between the legs. A
        foot comes down when the feet of the cycles do on average, whatever the phases are called:
        so that nothing jumps where a double support becomes a flight.
        """
        clocks: list[list[Floats]] = [[] for _ in self.cycles]
        for events in self._events:
            moments = np.array([event_times(events, c.supports, c.starts) for c in self.cycles])
            firsts = np.array([[cycle.starts[0]] for cycle in self.cycles])
            knots = shares @ (moments - firsts) - begin
            for rows, moment in zip(clocks, moments, strict=True):
                rows.append(mapped_times(times, knots, moment))
        return [
            np.clip(
                np.array([*rows, 0.5 * (rows[0] + rows[1])]) * cycle.fps, 0.0, len(cycle.keys) - 1.0
            )
            for cycle, rows in zip(self.cycles, clocks, strict=True)
        ]

    def _poses(
        self, shares: Weights, times: Seconds, begin: float, lead: Floats
    ) -> tuple[SmallFloats, Floats]:
        """Return poses and roots at some times of the mix.

        Args:
            shares: Of the cycles, shape (cycles,).
            times: Of the mix [s].
            begin: Where on average the first phases begin, from where that of the mix does [s].
            lead: How much the left foot leads between each two times, shape (times - 1,).
        """
        clocks = self._clocks(shares, begin, times)
        lead = lead[:, np.newaxis]
        heaviest = int(shares.argmax())
        order = [heaviest, *(i for i in range(len(self.cycles)) if i != heaviest)]
        turned = lengths = steps = first = np.zeros(0)
        for index in order:
            share = float(shares[index])
            if share <= 0.0:
                continue
            cycle, clock = self.cycles[index], clocks[index]
            rotations, effectors = posed(cycle.keys, clock, self._legs)
            # The root goes as it does while the foot that carries is at this place: so that stays.
            way = lead * root_steps(cycle.roots, clock[0]) + (1.0 - lead) * root_steps(
                cycle.roots, clock[1]
            )
            if index == heaviest:
                first = rotations
                turned, lengths, steps = share * rotations, share * effectors, share * way
                continue
            same = np.einsum("fji,fji->fj", rotations, first) >= 0.0
            turned = turned + share * np.where(same[..., np.newaxis], rotations, -rotations)
            lengths, steps = lengths + share * effectors, steps + share * way
        turned /= np.linalg.norm(turned, axis=-1, keepdims=True)
        keys = np.concatenate([continuous(turned).reshape(len(times), -1), lengths], axis=1)
        carrying = lead * lengths[:-1, [1, 3]] + (1.0 - lead) * lengths[:-1, [4, 6]]
        turn = self._turn_along(shares, float(steps[:, 1].sum()) * self._leg_length)
        return keys.astype(np.float32), root_way(turned_steps(steps, carrying, turn))

    def _turn_along(self, shares: Weights, way: float) -> float:
        """Return how far a mix turns on its way [m]: as far as its strides do on theirs [rad].

        The mix goes with one foot's times, then with the other's, and so misses some of either.
        """
        turn, own = float(shares @ self._strides.turns), float(shares @ self._strides.ways)
        return turn * way / own if own * way > 0.0 else turn
