"""A finished motion as the measures see it, whatever made it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from footfall.arrays import Flags, Floats, Positions, Rotations, Seconds, Supports
from footfall.errors import ArgumentError
from footfall.skeleton import Anatomy

__all__ = ["SurfaceHeights", "Trace"]

SurfaceHeights = Callable[[Positions, Seconds], Floats]
"""Heights of the surface [m], shape (...), at points (..., 3) and times [s], shape (...)."""


@dataclass(frozen=True, eq=False)
class Trace:
    """World poses at a steady rate, what was commanded, and what the blend did at the time.

    Raises:
        ArgumentError: If there is no frame, the rate is not positive, an array has the wrong
            shape, or a number is not finite.
    """

    positions: Positions
    """All joints in the world [m], shape (frames, joints, 3); joint 0 is the pelvis."""

    rotations: Rotations
    """All joints in the world, shape (frames, joints, 4)."""

    anatomy: Anatomy
    """Which joints are the legs, and where heel and toe sit."""

    fps: float
    """Frames per second."""

    supports: Supports
    """The commanded `Support` of each frame, shape (frames,). In a CONFLICT no foot is said to
    carry: nothing that can be done was commanded."""

    shares: Floats | None = None
    """Share of each action in the legs, shape (frames, actions), summing to one over the
    actions; None where one action plays alone."""

    moving: Flags | None = None
    """Whether weights move in a frame, shape (frames,); None: wherever `shares` change."""

    rates: Floats | None = None
    """Clip time per clock time in each frame, shape (frames,); None: 1 throughout."""

    ground: SurfaceHeights | Floats | float = 0.0
    """Height of the surface [m]: the same everywhere, or a function, or the height under each
    foot point, shape (frames, 2 feet, 2 points)."""

    surface_displacement: Positions | None = None
    """How far the surface has moved since the first frame [m], shape (frames, 3), or under each
    foot point, shape (frames, 2 feet, 2 points, 3); None: it stands still."""

    resting_levels: Floats | None = None
    """Heights of heel and toe over the surface while they rest on it [m], shape (2 feet,
    2 points); None: the 5th percentile of each point's own heights, and for a foot that is never
    down about the other one's, which cannot see feet that hover from the first frame to the
    last."""

    contact_height: float | None = None
    """A point is in contact below this height over its resting level [m]; None: 0.05 of the
    leg's length."""

    def __post_init__(self) -> None:
        frames = len(self.positions)
        if frames == 0:
            raise ArgumentError("a trace has no frames; at least one is needed")
        if not (self.fps > 0.0 and math.isfinite(self.fps)):
            raise ArgumentError(f"a trace has {self.fps} frames per second; it must be > 0")
        joints = self.positions.shape[1]
        actions = 1 if self.shares is None else self.shares.shape[-1]
        surface = None if callable(self.ground) else np.asarray(self.ground, dtype=np.float64)
        _check("positions", self.positions, (frames, joints, 3))
        _check("rotations", self.rotations, (frames, joints, 4))
        _check("supports", self.supports, (frames,))
        _check("shares", self.shares, (frames, actions))
        _check("moving flags", self.moving, (frames,))
        _check("rates", self.rates, (frames,))
        _check("ground heights", surface, (), (frames, 2, 2))
        _check("surface displacements", self.surface_displacement, (frames, 3), (frames, 2, 2, 3))
        _check("resting levels", self.resting_levels, (2, 2))

    @property
    def frames(self) -> int:
        """How many frames there are."""
        return len(self.positions)


def _check(label: str, array: Floats | Supports | Flags | None, *shapes: tuple[int, ...]) -> None:
    if array is None:
        return
    if array.shape not in shapes:
        wanted = " or ".join(str(shape) for shape in shapes)
        raise ArgumentError(f"the {label} of a trace have shape {array.shape}, not {wanted}")
    if not np.isfinite(array).all():
        frame = int(np.argwhere(~np.isfinite(array))[0][0]) if array.ndim else 0
        raise ArgumentError(f"the {label} of a trace are not finite, first in row {frame}")
