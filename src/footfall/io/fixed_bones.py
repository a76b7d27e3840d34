"""Bones of fixed length for files in which joints also move within their parents.

The engine's bodies have fixed bones. A file with position channels on its joints is read with
each joint at its median place. What that loses at the feet matters most, and most of it is the
pelvis turning under a trunk that does not: the hip joints move, opposite ways. So the pelvis is
first turned and placed, frame by frame, such that its two hips are where the file has them; all
joints keep their turns in the world.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from footfall.arrays import Indices, Positions, Rotations
from footfall.errors import FileFormatError
from footfall.geometry import conjugate, multiply, rotate
from footfall.io.bvh_rig import BvhRig
from footfall.io.conclusions import Conclusion
from footfall.io.root_layout import rest_skeleton, translation_of
from footfall.skeleton import Anatomy, leg_length

__all__ = ["fix_bones"]

GREATEST_STRAY = 0.05
"""A joint of a leg may stray this share of the leg's length from its place (4 cm on a grown
person): beyond that the foot would visibly not be where the file has it."""

NEGLIGIBLE_STRAY = 1e-4
"""Less than this share of the leg's length (0.1 mm) is rounding in the file."""


def fix_bones(rig: BvhRig, anatomy: Anatomy | None, path: Path) -> tuple[BvhRig, Conclusion[float]]:
    """Give every bone a fixed length.

    Args:
        rig: What the file holds, joint 0 being the pelvis.
        anatomy: Its legs, by the joints of `rig`; None where there are none.
        path: The file, for messages.

    Returns:
        The rig with the median places as its offsets and no joint but joint 0 moving, and how far
        a joint strays at most from its place, in the file's unit.

    Raises:
        FileFormatError: If a joint of a leg strays further than `GREATEST_STRAY`.
    """
    if not any(rig.translations.keys() - {0}):
        return rig, Conclusion(0.0, "fixed: no joint but the root has position channels")
    rigid = rest_skeleton(rig)
    leg = 0.0 if anatomy is None else max(leg_length(rigid, one) for one in anatomy.legs)
    fitted = False
    if anatomy is not None and _strays(rig)[_hip_roots(rig, anatomy)].max() > (
        NEGLIGIBLE_STRAY * leg
    ):
        rig = _with_pelvis_at_hips(rig, _hip_roots(rig, anatomy))
        fitted = True
    strays = _strays(rig)
    if anatomy is not None:
        _check_legs(rig, anatomy, strays, leg, path)
    worst = int(strays.argmax())
    stray = float(strays[worst])
    reason = (
        f"fixed: {len(rig.translations.keys() - {0})} joints have position channels; each is put "
        f"at its median place, from which {rig.names[worst]!r} strays most"
    )
    if fitted:
        reason += "; the pelvis is turned and placed so that both hips stay where the file has them"
    offsets = rest_skeleton(rig).rest_offsets
    places = np.array(translation_of(rig, 0))
    return replace(rig, offsets=offsets, translations={0: places}), Conclusion(stray, reason)


def _strays(rig: BvhRig) -> Positions:
    """Return how far each joint moves at most from its median place, shape (joints,)."""
    strays = np.zeros(len(rig.names))
    for joint, places in rig.translations.items():
        if joint > 0:
            away = np.linalg.norm(places - np.median(places, axis=0), axis=-1)
            strays[joint] = away.max()
    return strays


def _hip_roots(rig: BvhRig, anatomy: Anatomy) -> Indices:
    """Return the two children of joint 0 that the legs hang on."""
    roots: list[int] = []
    for leg in anatomy.legs:
        joint = leg.hip
        while rig.parents[joint] != 0:
            joint = int(rig.parents[joint])
        roots.append(joint)
    return np.array(roots)


def _with_pelvis_at_hips(rig: BvhRig, hips: Indices) -> BvhRig:
    """Return the same motion with another pelvis: all joints keep their place and turn."""
    left, right = (translation_of(rig, int(hip)) for hip in hips)
    rest_left, rest_right = np.median(left, axis=0), np.median(right, axis=0)
    turn = _shortest_turns(rest_right - rest_left, right - left)
    shift = 0.5 * (left + right) - rotate(turn, 0.5 * (rest_left + rest_right))
    back = conjugate(turn)
    rotations = rig.rotations.copy()
    translations = dict(rig.translations)
    for child in np.flatnonzero(rig.parents == 0):
        translations[int(child)] = rotate(back, translation_of(rig, int(child)) - shift)
        rotations[:, child] = multiply(back, rig.rotations[:, child])
    translations[0] = translation_of(rig, 0) + rotate(rig.rotations[:, 0], shift)
    rotations[:, 0] = multiply(rig.rotations[:, 0], turn)
    return replace(rig, rotations=rotations, translations=translations)


def _shortest_turns(direction: Positions, others: Positions) -> Rotations:
    """Return the shortest rotations of one direction, shape (3,), to others, shape (frames, 3)."""
    lengths = np.linalg.norm(direction) * np.linalg.norm(others, axis=-1)
    scalar = lengths + others @ direction
    quaternions = np.concatenate([scalar[:, np.newaxis], np.cross(direction, others)], axis=-1)
    norms = np.linalg.norm(quaternions, axis=-1, keepdims=True)
    # Opposed or without length: there is no shortest turn, and none is made.
    return np.where(
        norms > 1e-6 * lengths.max(), quaternions / np.maximum(norms, 1e-300), [1.0, 0, 0, 0]
    )


def _check_legs(rig: BvhRig, anatomy: Anatomy, strays: Positions, leg: float, path: Path) -> None:
    for one in anatomy.legs:
        joint = one.toe.joint
        while joint > 0:
            if strays[joint] > GREATEST_STRAY * leg:
                raise FileFormatError(
                    f"joint {rig.names[joint]!r} moves {strays[joint] / leg:.0%} of the leg's "
                    f"length within its parent; at most {GREATEST_STRAY:.0%} can be left out, "
                    "so bake the motion to rotations first",
                    path=path,
                )
            joint = int(rig.parents[joint])
