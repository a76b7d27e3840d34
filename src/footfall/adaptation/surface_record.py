"""A surface as the kernels take it: one record each, and the heights of all grids."""

from __future__ import annotations

from typing import NamedTuple, Protocol

import numpy as np

from footfall.arrays import Floats

__all__ = ["FIELD", "SLOPE", "STAIRS", "Ground", "Surface", "Surfaces", "surface_type"]

SLOPE, STAIRS, FIELD = 0, 1, 2
"""What a surface is: an even slope, steps that rise along its own z, or heights on a grid."""


class Surface:
    """One surface: a record of `surface_type`. Its own frame lies in its middle, z forward."""

    kind: int
    """`SLOPE`, `STAIRS` or `FIELD`."""

    x: float
    """Where its frame is at clock time 0 [m]."""

    y: float
    """Its height there [m]."""

    z: float
    """[m]"""

    heading: float
    """[rad]"""

    half_x: float
    """Half its width [m]; infinite where it has no end."""

    half_z: float
    """Half its length [m], likewise."""

    slope_x: float
    """Rise per meter along its own x."""

    slope_z: float
    """Rise per meter along its own z."""

    tilt_x: float
    """By how much `slope_x` swings each way in its period; its points go up and down only."""

    tilt_z: float
    """Likewise `slope_z`."""

    rise: float
    """Of one step [m]."""

    tread: float
    """Of one step [m]."""

    steps: int
    """How many."""

    way_x: float
    """How far it goes each way from where it is at rest [m], or, where `period` is 0, per
    second."""

    way_y: float
    """[m]"""

    way_z: float
    """[m]"""

    period: float
    """Of its way there and back [s]; 0 where it goes on for ever."""

    turning: float
    """How fast it turns about its middle [rad/s]."""

    first: int
    """Where its heights begin in `Ground.samples`."""

    count_x: int
    """How many there are along its own x."""

    count_z: int
    """And along its own z."""

    spacing: float
    """Between them [m]."""


surface_type = np.dtype(
    [
        (name, np.int64 if hint == "int" else np.float64)
        for name, hint in Surface.__annotations__.items()
    ],
    align=True,
)
"""The memory layout of `Surface`."""


class Surfaces(Protocol):
    """An array of `Surface` records, shape (surfaces,)."""

    @property
    def shape(self) -> tuple[int, ...]:
        """How many there are, as a tuple of one."""
        ...

    def __getitem__(self, index: int) -> Surface:
        """Return one surface."""
        ...


class Ground(NamedTuple):
    """All surfaces that a character may stand on.

    Where several lie above each other the highest counts.
    """

    surfaces: Surfaces
    """One record of `surface_type` for each, shape (surfaces,)."""

    even: bool
    """Whether there is but one, endless, of one slope and at rest, its middle at the origin."""

    samples: Floats
    """The heights of all grids, one after the other, row by row along x [m], shape (samples,)."""
