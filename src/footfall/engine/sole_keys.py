"""Heel and toe of each foot in every pose of the library, and how far a motion lets them slide.

A foot point is asked for in every frame by every motion that plays; working it out of the foot's
rotation each time took a quarter of a tick. All four lie in one octet: x of left heel, left toe,
right heel, right toe, then z in the same order.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from footfall.arrays import Floats, Positions, SmallFloats
from footfall.compilation import small_kernel
from footfall.geometry import rotate
from footfall.geometry.transforms import cosine_and_sine
from footfall.octet_memory import load
from footfall.octets import LANES
from footfall.skeleton.normalized import ANKLES

__all__ = ["resting_octets", "sole_keys_of", "sole_slides"]

SHORTEST = 1e-12
"""Length below which a rotation is none."""


def sole_keys_of(keys: SmallFloats, joints: int, points: Positions) -> SmallFloats:
    """Return where heel and toe of each foot are in normalized poses.

    Args:
        keys: Normalized poses by component, as `Shelf.keys`, shape (frames, 4 rows + 8).
        joints: How many joints they have.
        points: Heel and toe of each foot in the ankle's frame, in leg lengths, shape (2, 2, 3).

    Returns:
        As `Shelf.sole_keys`, shape (frames, 16).
    """
    rows = (keys.shape[1] - LANES) // 4
    ankles = 4 * rows + ANKLES
    out = np.empty((len(keys), 2 * LANES), dtype=np.float32)
    for side in range(2):
        place = keys[:, ankles + 3 * side : ankles + 3 * side + 3].astype(np.float64)
        foot = keys[:, joints + side : 4 * rows : rows].astype(np.float64)
        foot /= np.maximum(np.linalg.norm(foot, axis=1, keepdims=True), SHORTEST)
        for point in range(2):
            at = place + rotate(foot, points[side, point])
            column = 2 * side + point
            out[:, column], out[:, column + 4] = at[:, 0], at[:, 2]
            out[:, column + LANES], out[:, column + LANES + 4] = at[:, 2], -at[:, 0]
    return out


def resting_octets(heights: Sequence[Floats]) -> SmallFloats:
    """Return how high foot points rest, each of shape (2, 2), as `Shelf.resting_heights`."""
    out = np.zeros((len(heights), LANES), dtype=np.float32)
    out[:, :4] = np.reshape(heights, (-1, 4))
    return out


@small_kernel
def sole_slides(
    keys: SmallFloats,
    before: tuple[int, float, int],
    now: tuple[int, float, int],
    turn: float,
) -> float:
    """Return how far a motion itself moves all four foot points, but for what its root goes.

    Seen from its root before the step.

    Args:
        keys: `Shelf.sole_keys`.
        before: Where its clip was, as `key_at` says.
        now: Where it is.
        turn: How far its root turns in this step [rad].

    Returns:
        An octet: x of the four, then z.
    """
    cosine, sine = cosine_and_sine(turn)
    straight, turned = _sole_at(keys, now, 0), _sole_at(keys, now, LANES)
    return cosine * straight + sine * turned - _sole_at(keys, before, 0)


@small_kernel
def _sole_at(keys: SmallFloats, place: tuple[int, float, int], part: int) -> float:
    after = place[0] + 1 if place[1] > 0.0 else place[0]
    one = load(keys, 2 * LANES * place[0] + part)
    return one + (load(keys, 2 * LANES * after + part) - one) * place[1]
