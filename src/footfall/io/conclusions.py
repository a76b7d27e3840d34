"""What was concluded about a file, each with its reason: nothing is guessed silently."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Generic, NamedTuple, TypeVar

from footfall.io.units import Unit

__all__ = ["Conclusion", "Conclusions", "LegNames"]

Value = TypeVar("Value")


@dataclass(frozen=True, slots=True)
class Conclusion(Generic[Value]):
    """One decision."""

    value: Value
    """What was decided."""

    reason: str
    """Why, in a sentence that also names the value."""


class LegNames(NamedTuple):
    """The joints of one leg."""

    hip: str
    """The upper end of the thigh."""

    knee: str
    """The upper end of the shank."""

    ankle: str
    """The lower end of the shank."""

    toe: str
    """The joint that the foot's fore point moves with; the ankle, where there is no toe joint."""


@dataclass(frozen=True, slots=True)
class Conclusions:
    """Everything that a reader decided, in the order in which `footfall info` tells it."""

    unit: Conclusion[Unit]
    """The unit of length of the file."""

    up: Conclusion[str]
    """The axis of the file that points up, ``"y"`` or ``"z"``."""

    root: Conclusion[str]
    """The joint that became joint 0, the pelvis."""

    bones: Conclusion[float]
    """How far a joint strays at most from its bone of fixed length [m]."""

    frames: Conclusion[int]
    """How many frames there are."""

    fps: Conclusion[float]
    """Frames per second."""

    feet: Conclusion[tuple[LegNames, LegNames] | None]
    """The left and the right leg; None where none were found."""

    first_frame: Conclusion[bool]
    """Whether the first frame is an outlier, such as a T-pose before the motion."""

    floor: Conclusion[float]
    """How high the floor is, measured where the lowest foot point rests [m]."""

    cyclic: Conclusion[bool]
    """Whether the last frame is the first one again, so that the clip can be looped."""

    def sentences(self) -> tuple[tuple[str, str], ...]:
        """Return the name and the reason of each conclusion."""
        return tuple(
            (field.name.replace("_", " "), getattr(self, field.name).reason)
            for field in fields(self)
        )
