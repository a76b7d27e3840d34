"""Where the ankles of a body must be so that its soles stand where those of another stand.

Feet differ in length and height. Where a foot is flat, the middle of its sole stands where that
of the leading foot does, lengths scaled; where it rolls, the heel or the toe that carries stays
where it was then. The lowest point of a foot is as high over its ground as the leader's, scaled:
nothing floats and nothing sinks.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from footfall.arrays import Floats, Positions, Rotations
from footfall.geometry import rotate
from footfall.skeleton import Anatomy, Skeleton
from footfall.skeleton.rig import rig_of

__all__ = ["Soles", "ankles_on_soles", "soles_of"]

RESTING_PERCENTILE = 5.0
"""Percentile of a foot point's heights that is its height at rest, as in the reports."""

ROLL_BAND = 0.02
"""Difference in height of heel and toe over which the carrying point passes between them [m]."""

STEEP = 0.5
"""Level share of a foot's direction below which its heading counts less and less."""


class Soles(NamedTuple):
    """Heel and toe of both feet during a motion; heel first, left foot first."""

    points: Positions
    """Where they are [m], shape (frames, 2 feet, 2 points, 3)."""

    levels: Floats
    """Their heights at rest [m], shape (2, 2)."""

    offsets: Positions
    """Where they are in the frames of the ankles [m], shape (2, 2, 3)."""


def soles_of(
    skeleton: Skeleton, anatomy: Anatomy, rotations: Rotations, positions: Positions
) -> Soles:
    """Return the soles of a motion, `anatomy` having its heels on the soles.

    Toes are taken as they are bent at rest: a point of the foot, not of the toes.
    """
    offsets = rig_of(skeleton, anatomy).foot_points
    ankles = [leg.ankle for leg in anatomy.legs]
    turned = rotate(rotations[:, ankles, np.newaxis], offsets)
    points = positions[:, ankles, np.newaxis] + turned
    levels = np.percentile(points[..., 1], RESTING_PERCENTILE, axis=0)
    return Soles(points, levels, offsets)


def ankles_on_soles(leading: Soles, ratio: float, offsets: Positions, feet: Rotations) -> Positions:
    """Return where the ankles must be [m], shape (frames, 2, 3).

    Args:
        leading: The soles of the motion that is followed.
        ratio: The body's size over the leader's: the leader's places are scaled by it.
        offsets: The body's heels and toes in the frames of its ankles [m], (2, 2, 3).
        feet: How its feet are turned in the world, shape (frames, 2, 4).
    """
    turned = rotate(feet[:, :, np.newaxis], offsets)
    along = turned[:, :, 1] - turned[:, :, 0]
    size = np.linalg.norm(offsets[:, 1] - offsets[:, 0], axis=-1)
    fore = leading.points[:, :, 1] - leading.points[:, :, 0]
    own = np.linalg.norm(leading.offsets[:, 1] - leading.offsets[:, 0], axis=-1)
    heading = np.where((size > 1e-6)[:, np.newaxis], along, fore) * np.array([1.0, 0.0, 1.0])
    length = np.array(size)
    length[size <= 1e-6] = np.maximum(own[size <= 1e-6], 1e-6)
    level = np.linalg.norm(heading, axis=-1, keepdims=True)
    heading = heading / np.maximum(level, STEEP * length[:, np.newaxis])
    longer = (0.5 * (size - ratio * own))[:, np.newaxis] * heading
    clear = leading.points[..., 1] - leading.levels
    rolled = np.clip(0.5 + (clear[..., 0] - clear[..., 1]) / (2.0 * ROLL_BAND), 0.0, 1.0)
    toes = (rolled * rolled * (3.0 - 2.0 * rolled))[..., np.newaxis]
    heel = ratio * leading.points[:, :, 0] - longer - turned[:, :, 0]
    toe = ratio * leading.points[:, :, 1] + longer - turned[:, :, 1]
    ankles = (1.0 - toes) * heel + toes * toe
    lowest = (turned[..., 1] - ratio * leading.levels).min(axis=-1)
    ankles[..., 1] = ratio * clear.min(axis=-1) - lowest
    return ankles
