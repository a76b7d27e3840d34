"""What a character stands on: planes, ramps, stairs, grids of heights, platforms that move.

Each kind is a frozen value. `Terrain` puts several together; where they lie above each other the
highest counts.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from footfall.adaptation.height_field import HeightField, check_finite, check_positive
from footfall.adaptation.own_ground import Ground
from footfall.errors import ArgumentError

__all__ = ["AnyGround", "BuiltGround", "Plane", "Platform", "Ramp", "Stairs", "Terrain"]

STEEPEST = math.tan(math.radians(60.0))
"""Greatest rise per meter of a plane or a ramp."""


@dataclass(frozen=True, slots=True)
class Plane:
    """Ground without end, level or tilted.

    Raises:
        ArgumentError: If a number is not finite, or it is steeper than 60 degrees.
    """

    height: float = 0.0
    """Where it lies at the origin, y [m]."""

    slope: tuple[float, float] = (0.0, 0.0)
    """Rise per meter towards +x and towards +z."""

    def __post_init__(self) -> None:
        check_finite("ground at height", self.height)
        check_finite("ground with a slope of", *self.slope)
        if math.hypot(*self.slope) > STEEPEST:
            raise ArgumentError(
                f"ground with slopes {self.slope}; nobody stands where it is steeper than 60°"
            )


@dataclass(frozen=True, slots=True)
class Ramp:
    """An even slope of some length and width.

    Raises:
        ArgumentError: If a number is not finite or a size not positive.
    """

    place: tuple[float, float, float]
    """The middle of its lower end: x, y, z [m]."""

    length: float
    """Along the ground [m]."""

    rise: float
    """From end to end [m]; negative leads down."""

    width: float = 4.0
    """[m]"""

    heading: float = 0.0
    """Where it leads [rad], 0 to +z."""

    def __post_init__(self) -> None:
        check_finite("a ramp with", *self.place, self.rise, self.heading)
        check_positive("a ramp", length=self.length, width=self.width)


@dataclass(frozen=True, slots=True)
class Stairs:
    """Steps that lead up, and a landing after them.

    Raises:
        ArgumentError: If a number is not finite, a size not positive, or there is no step.
    """

    place: tuple[float, float, float]
    """The middle of the foot of the first riser: x, y, z [m]."""

    steps: int
    """How many."""

    rise: float = 0.18
    """Of each [m]; negative leads down."""

    tread: float = 0.29
    """Depth of each [m]."""

    width: float = 4.0
    """[m]"""

    landing: float = 4.0
    """Length of the landing at their end [m]."""

    heading: float = 0.0
    """Where they lead [rad], 0 to +z."""

    def __post_init__(self) -> None:
        check_finite("stairs with", *self.place, self.rise, self.heading)
        check_positive("stairs", tread=self.tread, width=self.width, landing=self.landing)
        if self.steps < 1:
            raise ArgumentError(f"stairs of {self.steps} steps; there must be at least 1")


@dataclass(frozen=True, slots=True)
class Platform:
    """A plate that moves, turns or tilts.

    Raises:
        ArgumentError: If a number is not finite, a size not positive, or the period negative; if
            it tilts beyond 60 degrees, or without a period.
    """

    place: tuple[float, float, float]
    """Its middle at clock time 0: x, y, z [m]."""

    size: tuple[float, float]
    """Along x and z [m]."""

    way: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """How far it swings to each side [m]; without a period, its velocity [m/s]."""

    period: float = 0.0
    """Of its swing [s]; 0: it goes on for ever."""

    turning: float = 0.0
    """How fast it turns [rad/s]."""

    tilt: tuple[float, float] = (0.0, 0.0)
    """By how much it tilts to each side in its period: rise per meter along its own x and z. What
    stands on it is taken up and down, not sideways."""

    def __post_init__(self) -> None:
        numbers = (*self.place, *self.way, self.turning, self.period, *self.tilt)
        check_finite("a platform with", *numbers)
        check_positive("a platform", width=self.size[0], length=self.size[1])
        if self.period < 0.0:
            raise ArgumentError(f"a platform with a period of {self.period} s; it must be >= 0")
        if math.hypot(*self.tilt) > STEEPEST:
            raise ArgumentError(
                f"a platform that tilts by {self.tilt}; nobody stands where it is steeper than 60°"
            )
        if any(self.tilt) and self.period == 0.0:
            raise ArgumentError("a platform that tilts without a period; give one > 0 s")


@dataclass(frozen=True, slots=True)
class Terrain:
    """Several surfaces together; where they lie above each other the highest counts.

    Raises:
        ArgumentError: If there is none.
    """

    parts: tuple[Plane | Ramp | Stairs | Platform | HeightField, ...]
    """The surfaces. Where none lies the ground is level at height 0."""

    def __post_init__(self) -> None:
        if not self.parts:
            raise ArgumentError("a terrain without parts; give at least one surface")


BuiltGround = Plane | Ramp | Stairs | Platform | HeightField | Terrain
"""The kinds that the kernels know."""

AnyGround = BuiltGround | Ground
"""Everything a character can stand on."""
