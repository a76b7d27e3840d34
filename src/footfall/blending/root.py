"""Where the root goes while motions are mixed: so that the carrying foot does not pay for it.

Each motion moves its root and, seen from the root, its feet. With fixed weights and equal turns
the weighted sum of what leaves each foot in place leaves the mixed foot in place. While weights
move, or where motions turn differently, it does not; but by how much is known exactly, and is
taken out of the root's displacement. What the motions themselves let their foot slide is kept:
with footprints off, a clip alone plays back as it was.
"""

from __future__ import annotations

from footfall.arrays import Positions
from footfall.compilation import small_kernel
from footfall.geometry import transforms

__all__ = ["correct_displacement", "mix_point"]


@small_kernel
def mix_point(points: Positions, side: int, toe_share: float, axis: int) -> float:
    """Return one coordinate of the point of a foot that carries, between heel and toe."""
    return (1.0 - toe_share) * points[side, 0, axis] + toe_share * points[side, 1, axis]


@small_kernel
def correct_displacement(
    heading: float,
    slide: tuple[float, float],
    before: Positions,
    after: Positions,
    side: int,
    toe_share: float,
) -> tuple[float, float]:
    """Return the root displacement that lets a foot slide no more than its motions do.

    Args:
        heading: How far the root turns in this step [rad].
        slide: What the motions themselves let the foot slide, weighted.
        before: Blended heel and toe of each foot before the step, relative to the root, x and z,
            shape (2, 2, 2).
        after: The same after the step, shape (2, 2, 3).
        side: Which foot carries.
        toe_share: Where between heel (0) and toe (1) it carries.
    """
    cosine, sine = transforms.cosine_and_sine(heading)
    x, z = transforms.turn(
        cosine, sine, mix_point(after, side, toe_share, 0), mix_point(after, side, toe_share, 2)
    )
    return (
        slide[0] + mix_point(before, side, toe_share, 0) - x,
        slide[1] + mix_point(before, side, toe_share, 1) - z,
    )
