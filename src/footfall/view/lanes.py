"""A schedule in clock time, as the timeline draws it: lanes of phases, weights and commands."""

from __future__ import annotations

from dataclasses import dataclass

from footfall.arrays import Floats
from footfall.errors import ArgumentError
from footfall.view.palette import SUPPORT_COLORS

__all__ = ["ActionLane", "CueMark", "LanePhase", "Timeline"]


@dataclass(frozen=True, slots=True)
class LanePhase:
    """A support phase as it was played."""

    symbol: str
    """One of ``R L D -``."""

    start: float
    """Clock time at which it began [s]."""

    end: float
    """Clock time at which it ended [s]."""

    stretch: float = 1.0
    """Clock seconds over clip seconds: above one it was held."""


@dataclass(frozen=True, slots=True)
class CueMark:
    """A command to start or stop an action, and when that came about."""

    kind: str
    """``"start"`` or ``"stop"``."""

    commanded: float
    """Clock time of the command [s]."""

    actual: float | None = None
    """Clock time at which it was followed [s]; None if never."""


@dataclass(frozen=True, eq=False)
class ActionLane:
    """What one action played."""

    name: str
    phases: tuple[LanePhase, ...]
    """In order of time."""
    weights: Floats
    """Its share in each frame, 0 to 1, shape (frames,)."""
    cues: tuple[CueMark, ...] = ()


@dataclass(frozen=True, eq=False)
class Timeline:
    """A schedule in clock time.

    Raises:
        ArgumentError: If a lane's weights are not one a frame, or a symbol is unknown.
    """

    fps: float
    """Frames per second of weights and supports."""

    supports: str
    """What the result stands on: one of ``R L D -`` a frame."""

    lanes: tuple[ActionLane, ...]
    """The action of the highest priority first."""

    def __post_init__(self) -> None:
        unknown = set(self.supports) - set(SUPPORT_COLORS)
        for lane in self.lanes:
            unknown |= {phase.symbol for phase in lane.phases} - set(SUPPORT_COLORS)
            if lane.weights.shape != (len(self.supports),):
                raise ArgumentError(
                    f"the weights of {lane.name!r} have shape {lane.weights.shape}; "
                    f"{len(self.supports)} frames need ({len(self.supports)},)"
                )
        if unknown:
            raise ArgumentError(f"no support is written {sorted(unknown)}; there are R, L, D and -")

    @property
    def duration(self) -> float:
        """How long it is [s]."""
        return len(self.supports) / self.fps
