"""A sequence of support phases: what a clip stands on, from its start to its end.

The text form is the command line's contract: ``R L D -`` separated by blanks, each with its
seconds if wanted (``R.38``), ``*`` at the end for a cyclic sequence. Where hands or front legs
carry too, ``+`` and their letters follow that of the feet: ``D+lr`` is on all fours, ``L+r`` a
trot's diagonal, ``+lr`` a handstand; ``p`` and ``s`` are middle legs (`LIMBS`).
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import accumulate, pairwise

import numpy as np

from footfall.arrays import Seconds, Supports
from footfall.errors import SupportSequenceError
from footfall.support.algebra import Support

__all__ = ["SupportPhase", "SupportSequence", "merge_equal_neighbors"]

_TOKEN = re.compile(r"([RLD-]|[RLD]?\+(?=[lrps])l?r?p?s?)(\d+\.?\d*|\.\d+)?")


@dataclass(frozen=True, slots=True)
class SupportPhase:
    """A support that lasts: an element of the paper's sequence S_i."""

    support: Support
    """What carries the body; never CONFLICT."""

    duration: float = 1.0
    """How long it lasts at the clip's own speed [s]; 1 where only the order matters."""


@dataclass(frozen=True, slots=True)
class SupportSequence:
    """The support phases of one motion, and what follows the last of them.

    Two neighbors always differ: a phase ends when, and only when, its support changes.

    Raises:
        SupportSequenceError: If there is no phase, if two neighbors (in a cycle of more than
            one phase, also the last and the first) have the same support, if a phase is
            CONFLICT, if it does not last longer than zero, or if `start` is later than the
            first frame or so early that the first phase would already be over there.
    """

    phases: tuple[SupportPhase, ...]
    """In the order of the clip."""

    cyclic: bool = False
    """Whether the motion starts over after its last phase, or stays clamped on it."""

    start: float = 0.0
    """Clip time at which phase 0 begins [s], <= 0: below zero where the loop of a cyclic clip
    was cut in the middle of a phase."""

    def __post_init__(self) -> None:
        if not self.phases:
            raise SupportSequenceError("a sequence needs at least one phase, such as R.38")
        for index, phase in enumerate(self.phases):
            if phase.support is Support.CONFLICT:
                raise SupportSequenceError(f"phase {index} is CONFLICT, which no clip can be")
            if not (phase.duration > 0.0 and math.isfinite(phase.duration)):
                raise SupportSequenceError(
                    f"phase {index} lasts {phase.duration} s; it must last longer than zero"
                )
        self._check_neighbors()
        if not -self.phases[0].duration < self.start <= 0.0:
            raise SupportSequenceError(
                f"phase 0 starts at {self.start} s; it must start at or before the first frame "
                f"and still last there, so within (-{self.phases[0].duration:g}, 0]"
            )
        if self.start < 0.0 and not self.cyclic:
            raise SupportSequenceError(
                f"phase 0 starts at {self.start} s, before the first frame; "
                "only a cyclic sequence may"
            )

    def _check_neighbors(self) -> None:
        for index, (one, other) in enumerate(pairwise(self.phases)):
            if one.support is other.support:
                raise SupportSequenceError(
                    f"phases {index} and {index + 1} are both {one.support.name}; "
                    "merge them into one"
                )
        last = len(self.phases) - 1
        if self.cyclic and last > 0 and self.phases[0].support is self.phases[last].support:
            raise SupportSequenceError(
                f"phases {last} and 0, neighbors in the cycle, are both "
                f"{self.phases[0].support.name}; merge them into one"
            )

    @classmethod
    def parse(cls, text: str, *, cyclic: bool | None = None) -> SupportSequence:
        """Read the text form, such as ``"R.38 D.12 L.38 D.12*"``.

        Args:
            text: Supports separated by blanks, each with its seconds if wanted.
            cyclic: Overrides what the ``*`` at the end says.

        Returns:
            The sequence; a phase without seconds lasts 1.

        Raises:
            SupportSequenceError: If a word is no support, or the sequence breaks a rule of
                `SupportSequence`.
        """
        body = text.strip()
        starred = body.endswith("*")
        phases: list[SupportPhase] = []
        for token in body.removesuffix("*").split():
            match = _TOKEN.fullmatch(token)
            if match is None:
                raise SupportSequenceError(
                    f"{token!r} in {text!r} is no support phase; write R, L, D or -, "
                    "with its seconds if wanted, such as R.38, and * at the very end for a cycle"
                )
            seconds = float(match[2]) if match[2] else 1.0
            phases.append(SupportPhase(Support.from_symbol(match[1]), seconds))
        return cls(tuple(phases), starred if cyclic is None else cyclic)

    def at(self, k: int) -> SupportPhase:
        """Return phase `k`, however far past the end (section 4.3, figure 6)."""
        return self.phases[k % len(self.phases) if self.cyclic else min(k, len(self.phases) - 1)]

    @property
    def duration(self) -> float:
        """How long all phases last together [s]."""
        return math.fsum(phase.duration for phase in self.phases)

    @property
    def boundaries(self) -> tuple[float, ...]:
        """Clip times at which the phases begin, and the last one ends [s]; one more than phases."""
        return tuple(accumulate((phase.duration for phase in self.phases), initial=self.start))

    def index_at(self, clip_time: float) -> int:
        """Return the index of the phase that a clip time [s] falls in, past the ends too."""
        bounds = self.boundaries
        if self.cyclic:
            clip_time = bounds[0] + (clip_time - bounds[0]) % self.duration
        for index, end in enumerate(bounds[1:]):
            if clip_time < end:
                return index
        return len(self.phases) - 1

    def support_at(self, clip_time: float) -> Support:
        """Return the support at a clip time [s], past the ends too."""
        return self.phases[self.index_at(clip_time)].support

    def supports_at(self, clip_times: Seconds) -> Supports:
        """Return the support at each of many clip times [s], shape (n,): see `support_at`."""
        bounds = np.array(self.boundaries)
        if self.cyclic:
            clip_times = bounds[0] + (clip_times - bounds[0]) % self.duration
        indices = np.searchsorted(bounds[1:], clip_times, side="right")
        symbols = np.array([phase.support for phase in self.phases], dtype=np.int64)
        return symbols[np.minimum(indices, len(self.phases) - 1)]

    def __str__(self) -> str:
        """Return the text form, with seconds to the millisecond (finer below half of one)."""
        words = " ".join(f"{p.support.symbol}{_seconds(p.duration)}" for p in self.phases)
        return words + ("*" if self.cyclic else "")


def _seconds(duration: float) -> str:
    decimals = 3 if duration >= 0.0005 else 3 - math.floor(math.log10(duration))
    return f"{duration:.{decimals}f}".rstrip("0").rstrip(".").removeprefix("0")


def merge_equal_neighbors(phases: Iterable[SupportPhase]) -> tuple[SupportPhase, ...]:
    """Join neighbors of the same support, adding their durations (not across a cycle's wrap)."""
    merged: list[SupportPhase] = []
    for phase in phases:
        if merged and merged[-1].support is phase.support:
            merged[-1] = SupportPhase(phase.support, merged[-1].duration + phase.duration)
        else:
            merged.append(phase)
    return tuple(merged)
