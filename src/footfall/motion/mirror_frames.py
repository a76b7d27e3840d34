"""Which joint mirrors which, and how their frames correspond.

Mirrored across a plane, a joint turns as its partner did: R' = M R_partner C, where M mirrors the
world and C, also a reflection, says how the partner's frame looks in the mirror. Files orient
joint frames anyhow: mirrored, equal on both sides, or with every axis turned over. C has to carry
the bones of one side onto those of the other, which fixes it up to a turn about a lone bone; there
the poses of the clip decide, in which both sides turn alike on average.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from footfall.arrays import Floats, Indices, Positions, Rotations, frozen
from footfall.geometry import blend_rotations, rotate
from footfall.skeleton import Anatomy, Leg, Skeleton
from footfall.skeleton.joint_names import read_joint_names

__all__ = ["frame_reflections", "mirrored_joints"]

AXIS_MISFIT = 0.03
"""Squared misfit of the bones, as a share of their squared length, up to which a reflection along
the axes is taken as meant: bones 10° apart, which real bodies' unequal limbs stay below."""

AXIS_MISFIT_ALONE = 0.1
"""The same for a joint without partner: shoulders are mounted up to 18° unevenly, and the head
above them is not to lean for it."""

POSE_WEIGHT = 0.02
"""Weight of what the poses say beside the bones: enough to settle a turn about a lone bone, too
little to bend the bones away from each other."""

_NONE = np.zeros(3)


def mirrored_joints(skeleton: Skeleton, anatomy: Anatomy) -> Indices:
    """Return the joint that mirrors each joint, itself where it has no partner, shape (joints,).

    Hips, knees and ankles are paired by the anatomy, others by equal names but for the side.
    """
    names = read_joint_names(skeleton)
    numbers = ["".join(filter(str.isdigit, name)) for name in skeleton.names]
    partners = np.arange(skeleton.count)

    def pair(one: int, other: int) -> None:
        if one != other and partners[one] == one and partners[other] == other:
            partners[one], partners[other] = other, one

    left, right = anatomy.legs
    for one, other in zip(_chain(left), _chain(right), strict=True):
        pair(one, other)
    known = {(names[j].side, names[j].words, numbers[j]): j for j in range(skeleton.count)}
    for joint, name in enumerate(names):
        if name.side == 0:
            pair(joint, known.get((1, name.words, numbers[joint]), joint))
    for joint in range(skeleton.count):
        _pair_rest(skeleton, [name.side for name in names], partners, joint, pair)
    return frozen(partners, np.int64)


def _chain(leg: Leg) -> tuple[int, int, int, int]:
    return (leg.hip, leg.knee, leg.ankle, leg.toe.joint)


def _pair_rest(
    skeleton: Skeleton,
    sides: list[int | None],
    partners: Indices,
    joint: int,
    pair: Callable[[int, int], None],
) -> None:
    """Pair the children that names left over: of a pair in order, of a lone joint by side."""
    partner = int(partners[joint])
    mine = [child for child in skeleton.children(joint) if partners[child] == child]
    if partner == joint:
        others = [child for child in mine if sides[child] == 1]
        mine = [child for child in mine if sides[child] == 0]
    else:
        others = [child for child in skeleton.children(partner) if partners[child] == child]
    if len(mine) == len(others):
        for one, other in zip(mine, others, strict=True):
            pair(one, other)


def frame_reflections(skeleton: Skeleton, local_rotations: Rotations, partners: Indices) -> Floats:
    """Return C of each joint: a reflection from its frame to its partner's, (joints, 3, 3).

    The two of a pair are each other's transpose, so that mirroring twice changes nothing.

    Args:
        skeleton: The body.
        local_rotations: Its poses in a clip, shape (frames, joints, 4).
        partners: The joint that mirrors each joint, shape (joints,).
    """
    count = len(local_rotations)
    aligned = np.where(
        np.einsum("fji,ji->fj", local_rotations, local_rotations[0])[..., np.newaxis] < 0.0,
        -local_rotations,
        local_rotations,
    )
    mean = _matrices(blend_rotations(aligned, np.full(aligned.shape[:2], 1.0 / count)))
    reflections = np.empty((skeleton.count, 3, 3))
    for joint in range(skeleton.count):
        partner = int(partners[joint])
        if partner < joint:
            reflections[joint] = reflections[partner].T
            continue
        bones, images = _bones(skeleton, partners, joint)
        if joint == 0:
            expected = _across(bones, images)
        else:
            parent = reflections[skeleton.parents[joint]]
            expected = mean[partner].T @ parent @ mean[joint]
        reflections[joint] = _reflection(bones, images, expected, partner == joint)
    return reflections


def _matrices(rotations: Rotations) -> Floats:
    return np.stack([rotate(rotations, axis) for axis in np.eye(3)], axis=-1)


def _bones(skeleton: Skeleton, partners: Indices, joint: int) -> tuple[Positions, Positions]:
    """Return the bones that leave a joint, and those that leave its partner, (bones, 3) each.

    Bones of which one is twice as long as the other are helpers and say nothing.
    """
    partner = int(partners[joint])
    pairs = [(skeleton.tip_offsets[joint], skeleton.tip_offsets[partner])]
    pairs += [
        (skeleton.rest_offsets[child], skeleton.rest_offsets[partners[child]])
        for child in skeleton.children(joint)
        if skeleton.parents[partners[child]] == partner
    ]
    lengths = [sorted((np.linalg.norm(one), np.linalg.norm(other))) for one, other in pairs]
    alike = [short > 0.5 * long for short, long in lengths]
    bones = [bones for bones, use in zip(pairs, alike, strict=True) if use] or [(_NONE, _NONE)]
    return np.array([one for one, _ in bones]), np.array([other for _, other in bones])


def _across(bones: Positions, images: Positions) -> Floats:
    """Return the reflection across the plane between the bones and their images."""
    apart = bones - images
    _, _, axes = np.linalg.svd(apart)
    normal = axes[0]
    return np.eye(3) - 2.0 * np.outer(normal, normal)


def _reflection(bones: Positions, images: Positions, expected: Floats, alone: bool) -> Floats:
    """Return the reflection that carries bones onto their images and agrees with the poses."""
    size = max(float((bones**2).sum() + (images**2).sum()) / 2.0, 1e-9)
    most = AXIS_MISFIT_ALONE if alone else AXIS_MISFIT
    best, least = expected, np.inf
    for signs in ((-1, 1, 1), (1, -1, 1), (1, 1, -1), (-1, -1, -1)):
        axes = np.diag(np.array(signs, dtype=np.float64))
        misfit = float(((images - bones @ axes) ** 2).sum())
        score = misfit + POSE_WEIGHT * size * float(((axes - expected) ** 2).sum())
        if misfit <= most * size and score < least:
            best, least = axes, score
    if np.isfinite(least) and float(((best - expected) ** 2).sum()) < 4.0:
        return best
    return _nearest_reflection(images.T @ bones + POSE_WEIGHT * size * expected, alone)


def _nearest_reflection(matrix: Floats, alone: bool) -> Floats:
    """Return the orthogonal matrix of determinant -1 nearest to one; an involution if `alone`."""
    if alone:
        _, axes = np.linalg.eigh(0.5 * (matrix + matrix.T))
        normal = axes[:, 0]
        return np.eye(3) - 2.0 * np.outer(normal, normal)
    left, _, right = np.linalg.svd(matrix)
    turned: Any = np.diag([1.0, 1.0, -np.linalg.det(left @ right)])
    return left @ turned @ right
