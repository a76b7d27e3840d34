"""How far the pelvis sinks so that no leg has to reach further than it can."""

from __future__ import annotations

from footfall.compilation import small_kernel
from footfall.octets import greater, select, square_root
from footfall.skeleton.two_bone_ik import SOFT_REACH, Vector

__all__ = ["FALL_SPEED", "RISE_SPEED", "needed_drop"]

FALL_SPEED = 40.0
"""Of the spring that lowers the pelvis [1/s]."""

RISE_SPEED = 8.0
"""Of the spring that lets it rise again [1/s]."""


@small_kernel
def needed_drop(leg_length: float, hip: Vector, ankle: Vector, offset: Vector) -> float:
    """Return how far the pelvis must sink for one leg [m].

    A leg may be as straight as the blended pose has it; a footprint may not make it straighter
    than `SOFT_REACH`. All relative to the root [m]; one leg, or eight at once.

    Args:
        leg_length: Thigh and shank together.
        hip: Where the hip is before the legs reach.
        ankle: Where the ankle is in the blended pose.
        offset: How far its footprint moves it.
    """
    x, y, z = hip[0] - ankle[0], hip[1] - ankle[1], hip[2] - ankle[2]
    longest = greater(SOFT_REACH * leg_length, square_root(x * x + y * y + z * z))
    x, y, z = x - offset[0], y - offset[1], z - offset[2]
    room = longest * longest - (x * x + z * z)
    drop = greater(y - square_root(greater(room, 0.0)), 0.0)
    return select(room > 0.0, select(y * y <= room, 0.0, drop), 0.0)
