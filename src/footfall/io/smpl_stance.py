"""How a body of the SMPL family stands: along y at rest, along z in the worlds of most files."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Indices, Positions, Rotations
from footfall.geometry import conjugate, multiply, rotate
from footfall.io.conclusions import Conclusion
from footfall.io.smpl_bodies import SMPL_TREES, STATURE
from footfall.io.up_axis import TO_Y_UP
from footfall.skeleton import Skeleton, world_poses

__all__ = ["conclude_axis", "on_the_floor", "standing_along_z"]

SOLE = 0.012
"""Height of the approximate body's foot joints above the floor, as a share of its stature."""


def conclude_axis(rotations: Rotations, up: str | None) -> Conclusion[str]:
    """Return the axis along which the bodies stand; at rest all of them stand along y."""
    if up is not None:
        return Conclusion(up, f"{up}, as asked for")
    trunk = rotate(rotations[:, 0], np.array([0.0, 1.0, 0.0]))
    mean = np.median(trunk, axis=0)
    if mean[1] > 0.8:
        return Conclusion("y", "y: the pelvis stands along it")
    return Conclusion("z", "z, as always in AMASS")


def on_the_floor(
    kind: str,
    parents: Indices,
    offsets: Positions,
    places: Positions,
    rotations: Rotations,
    axis: str,
) -> Positions:
    """Return the places of the pelvis, all lifted by as much: the lowest feet stand on zero."""
    names = tuple(SMPL_TREES[kind])
    body = Skeleton(names, parents, offsets)
    _, positions = world_poses(body, places, rotations)
    column = "xyz".index(axis)
    feet = positions[:, [names.index("left_foot"), names.index("right_foot")], column].min(axis=1)
    lifted = places.copy()
    lifted[:, column] += SOLE * STATURE - float(np.percentile(feet, 5.0))
    return lifted


def standing_along_z(offsets: Positions, rotations: Rotations) -> tuple[Positions, Rotations]:
    """Return the same motion of a body whose rest pose stands along z, as its world does."""
    back = conjugate(TO_Y_UP)
    turned = multiply(multiply(back, rotations), TO_Y_UP)
    turned[:, 0] = multiply(rotations[:, 0], TO_Y_UP)
    return rotate(back, offsets), turned
