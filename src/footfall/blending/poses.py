"""The weighted mean of normalized poses, each body part with its own weights.

Eight joints at once: poses lie component by component (`footfall.skeleton.normalized`).
"""

from __future__ import annotations

from typing import NamedTuple

from footfall.arrays import Flags, Indices, SmallFloats
from footfall.compilation import small_kernel
from footfall.octet_memory import load, spread, store
from footfall.octets import LANES, select, square_root
from footfall.skeleton import BodyPart

__all__ = ["Layers", "blend_layers"]

LEGS = int(BodyPart.LEGS)

SHORTEST = 1e-12
"""Length of a sum of rotations below which it says nothing: no rotation then."""


class Layers(NamedTuple):
    """The poses that are mixed, each somewhere between two frames."""

    frames: Indices
    """The frame before, shape (layers,)."""

    after: Indices
    """The frame after, shape (layers,); the same where the clip ends there."""

    fractions: SmallFloats
    """How far between the two, in [0, 1), shape (layers,)."""

    weights: SmallFloats
    """Weight on each body part, shape (layers, parts)."""

    whole: Flags
    """Whether it is the same on all of them, shape (layers,)."""


@small_kernel
def blend_layers(
    keys: SmallFloats, layers: Layers, count: int, part_masks: SmallFloats, out: SmallFloats
) -> None:
    """Write the weighted mean of some poses.

    A quaternion and its opposite are the same rotation: each is added on the side of the
    sphere where the sum so far lies. Lengths are those of the mean leg, so they are weighted
    like the legs.

    Args:
        keys: Normalized poses by component, shape (frames, 4 rows + 8).
        layers: Which of them.
        count: How many layers there are.
        part_masks: Which rows belong to a body part, shape (parts, rows).
        out: Written: rotations of unit length and lengths, by component, shape (4 rows + 8,).
    """
    rows, stride = part_masks.shape[1], keys.shape[1]
    for row in range(0, rows, LANES):
        w, x, y, z = spread(0.0), spread(0.0), spread(0.0), spread(0.0)
        for layer in range(count):
            share = spread(layers.weights[layer, LEGS])
            if not layers.whole[layer]:
                share = spread(0.0)
                for part in range(part_masks.shape[0]):
                    mask = load(part_masks, part * rows + row)
                    share = share + mask * layers.weights[layer, part]
            before = layers.frames[layer] * stride + row
            after = layers.after[layer] * stride + row
            fraction = layers.fractions[layer]
            aw = _between(keys, before, after, fraction)
            ax = _between(keys, before + rows, after + rows, fraction)
            ay = _between(keys, before + 2 * rows, after + 2 * rows, fraction)
            az = _between(keys, before + 3 * rows, after + 3 * rows, fraction)
            share = select(w * aw + x * ax + y * ay + z * az < 0.0, -share, share)
            w, x, y, z = w + share * aw, x + share * ax, y + share * ay, z + share * az
        length = square_root(w * w + x * x + y * y + z * z)
        empty = length < SHORTEST
        scale = select(empty, 0.0, 1.0 / length)
        store(out, row, select(empty, 1.0, w * scale))
        store(out, row + rows, x * scale)
        store(out, row + 2 * rows, y * scale)
        store(out, row + 3 * rows, z * scale)
    lengths = spread(0.0)
    for layer in range(count):
        before = layers.frames[layer] * stride + 4 * rows
        after = layers.after[layer] * stride + 4 * rows
        mean = _between(keys, before, after, layers.fractions[layer])
        lengths = lengths + mean * layers.weights[layer, LEGS]
    store(out, 4 * rows, lengths)


@small_kernel
def _between(keys: SmallFloats, before: int, after: int, fraction: float) -> float:
    one = load(keys, before)
    return one + (load(keys, after) - one) * fraction
