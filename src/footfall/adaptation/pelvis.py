"""How far the pelvis sinks so that no leg has to reach further than it can."""

from __future__ import annotations

import math

from footfall.arrays import Positions
from footfall.compilation import kernel
from footfall.skeleton.rig import Rig
from footfall.skeleton.two_bone_ik import SOFT_REACH

__all__ = ["FALL_SPEED", "RISE_SPEED", "needed_drop"]

FALL_SPEED = 40.0
"""Of the spring that lowers the pelvis [1/s]."""

RISE_SPEED = 8.0
"""Of the spring that lets it rise again [1/s]."""


@kernel
def needed_drop(
    rig: Rig, side: int, ankle: Positions, offset: Positions, positions: Positions
) -> float:
    """Return how far the pelvis must sink for one leg [m].

    A leg may be as straight as the blended pose has it; a footprint may not make it straighter
    than `SOFT_REACH`.

    Args:
        rig: The body.
        side: Which leg.
        ankle: Where its ankle is in the blended pose, relative to the root [m], shape (3,).
        offset: How far its footprint moves it [m], shape (3,).
        positions: Joints relative to the root, before the legs reach [m], shape (joints, 3).
    """
    hip = rig.limbs[side, 0]
    x, y, z = (
        positions[hip, 0] - ankle[0],
        positions[hip, 1] - ankle[1],
        positions[hip, 2] - ankle[2],
    )
    longest = max(SOFT_REACH * rig.leg_length, math.sqrt(x * x + y * y + z * z))
    x, y, z = x - offset[0], y - offset[1], z - offset[2]
    across = x * x + z * z
    if across + y * y <= longest * longest or across >= longest * longest:
        return 0.0
    return max(y - math.sqrt(longest * longest - across), 0.0)
