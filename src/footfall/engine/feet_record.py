"""What a character remembers of its feet, and of the ground under them."""

from __future__ import annotations

from typing import Annotated

from footfall.arrays import Flags, Floats, Positions, Seconds, SmallFloats, SmallIndices

__all__ = ["Feet"]


class Feet:
    """The feet of one row of a crowd, in the order left, right: the first part of its record."""

    foot_ground: Annotated[Floats, 2, 2]
    """Height of the ground under heel and toe of each foot [m], shape (2, 2)."""

    foot_slope: Annotated[SmallFloats, 2, 2]
    """How the sole of each foot is tilted: rise per meter along the world's x and z, (2, 2)."""

    tilt: Annotated[SmallFloats, 2, 2]
    """The tilt of each sole in the pose shown last, likewise, shape (2, 2)."""

    tilt_rise: Annotated[SmallFloats, 2, 2]
    """How far that raises heel and toe [m], shape (2, 2)."""

    ground_slope: Annotated[SmallFloats, 2, 2]
    """How the ground under each foot is tilted, likewise, shape (2, 2)."""

    ground_below: Annotated[Floats, 2]
    """Height of the ground under the middle of each sole [m], shape (2,)."""

    surface: Annotated[SmallIndices, 2]
    """The surface that each carrying foot is on, else -1, shape (2,)."""

    carried: Annotated[Positions, 2, 3]
    """How far the surfaces under the feet have taken them since the beginning [m], (2, 3)."""

    landing: Annotated[SmallFloats, 2, 3]
    """How far each swinging foot is led from where it would land, x and z, and how high the ground
    is there [m], shape (2, 3)."""

    landing_time: Annotated[Seconds, 2]
    """How long until it lands [s]; -1 where that is not foreseen, shape (2,)."""

    toe_velocity: Annotated[SmallFloats, 2, 2]
    """How fast the blended toes go over the ground, x and z [m/s], shape (2, 2)."""

    world_points: Annotated[Positions, 2, 2, 3]
    """Heel and toe of each foot in the world, before footprints [m], shape (2, 2, 3)."""

    foot_offset: Annotated[Positions, 2, 3]
    """How far footprints move each foot [m], shape (2, 3)."""

    foot_velocity: Annotated[Positions, 2, 3]
    """How fast that changes [m/s], shape (2, 3)."""

    planted_time: Annotated[Seconds, 2]
    """How long each foot has been carrying [s], 0 while it does not, shape (2,)."""

    toe_shares: Annotated[SmallFloats, 2]
    """Where between heel (0) and toe (1) each foot carries, on its way to `on_toes`, (2,)."""

    slide_speeds: Annotated[SmallFloats, 2, 2]
    """How fast the motions themselves let heel and toe slide, smoothed [m/s], shape (2, 2)."""

    on_toes: Annotated[Flags, 2]
    """Whether the toe of each foot carries rather than its heel, shape (2,)."""

    shown_ankles: Annotated[SmallFloats, 2, 2]
    """Where the ankles were shown last, footprints included, x and z relative to the root in leg
    lengths, shape (2, 2)."""

    stance: Annotated[SmallFloats, 2, 2]
    """How far each foot then stands from where the neutral pose has it, x and z in leg lengths,
    shape (2, 2)."""
