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
from footfall.geometry import blend_rotations, continuous, rotate
from footfall.skeleton import Anatomy, Leg, Skeleton, world_poses
from footfall.skeleton.joint_names import read_joint_names

__all__ = ["frame_reflections", "mirrored_joints"]

AXIS_MISFIT = 0.03
"""Squared misfit of the bones, as a share of their squared length, up to which a reflection along
the axes is taken as meant: bones 10° apart, which real bodies' unequal limbs stay below."""

AXIS_MISFIT_ALONE = 0.1
"""The same for a joint without partner: shoulders are mounted up to 18° unevenly, and the head
above them is not to lean for it."""

AXIS_SHARE = 0.9
"""Share of the joints that reflections along the axes must fit, or frames are turned anyhow and
each reflection is fitted to its bones."""

POSE_WEIGHT = 1e-4
"""Weight of what the poses say beside the bones: enough to settle a turn about a lone bone, too
little to bend the bones away from each other."""

_AXIS_REFLECTIONS = tuple(
    np.diag(np.array(signs, dtype=np.float64))
    for signs in ((-1, 1, 1), (1, -1, 1), (1, 1, -1), (-1, -1, -1))
)

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
    bones = [_bones(skeleton, partners, joint) for joint in range(skeleton.count)]
    alone = partners == np.arange(skeleton.count)
    fitting = [
        _fitting_axes(bones[joint], bool(alone[joint])) if partners[joint] >= joint else []
        for joint in range(skeleton.count)
    ]
    asked = int((partners >= np.arange(skeleton.count)).sum())
    along_axes = sum(map(bool, fitting)) >= AXIS_SHARE * asked
    mean = _mean_rotations(local_rotations)
    reflections = np.empty((skeleton.count, 3, 3))
    for joint in range(skeleton.count):
        partner = int(partners[joint])
        if partner < joint:
            reflections[joint] = reflections[partner].T
            continue
        if joint == 0:
            expected = _across(skeleton, local_rotations, partners)
        else:
            parent = reflections[skeleton.parents[joint]]
            expected = mean[partner].T @ parent @ mean[joint]
        if along_axes:
            reflections[joint] = min(
                fitting[joint] or _AXIS_REFLECTIONS,
                key=lambda axes: float(((axes - expected) ** 2).sum()),
            )
        else:
            reflections[joint] = _nearest_reflection(bones[joint], expected, bool(alone[joint]))
    return reflections


def _mean_rotations(local_rotations: Rotations) -> Floats:
    """Return the mean rotation of each joint over the frames as a matrix, (joints, 3, 3)."""
    steady = continuous(local_rotations)
    shares = np.full(steady.shape[:2], 1.0 / len(steady))
    mean = blend_rotations(steady, shares)
    return np.stack([rotate(mean, axis) for axis in np.eye(3)], axis=-1)


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


def _across(skeleton: Skeleton, local_rotations: Rotations, partners: Indices) -> Floats:
    """Return the reflection of joint 0: along the line between the pair nearest to it."""
    still = local_rotations.copy()
    still[:, 0] = np.array([1.0, 0.0, 0.0, 0.0])
    _, positions = world_poses(skeleton, np.zeros((len(still), 3)), still)
    for joint, partner in enumerate(partners.tolist()):
        apart = (positions[:, joint] - positions[:, partner]).mean(axis=0)
        size = float(np.linalg.norm(apart))
        if size > 1e-6:
            return np.eye(3) - 2.0 * np.outer(apart, apart) / size**2
    return _AXIS_REFLECTIONS[0]


def _fitting_axes(bones: tuple[Positions, Positions], alone: bool) -> list[Floats]:
    """Return the reflections along axes that carry bones nearly onto their images."""
    own, images = bones
    most = AXIS_MISFIT_ALONE if alone else AXIS_MISFIT
    room = most * float((own**2).sum() + (images**2).sum()) / 2.0
    misfits = [float(((images - own @ axes) ** 2).sum()) for axes in _AXIS_REFLECTIONS]
    return [axes for axes, misfit in zip(_AXIS_REFLECTIONS, misfits, strict=True) if misfit <= room]


def _nearest_reflection(
    bones: tuple[Positions, Positions], expected: Floats, alone: bool
) -> Floats:
    """Return the reflection that best carries bones onto images; an involution if `alone`."""
    own, images = bones
    size = max(float((own**2).sum() + (images**2).sum()) / 2.0, 1e-9)
    matrix = images.T @ own + POSE_WEIGHT * size * expected
    if alone:
        _, axes = np.linalg.eigh(0.5 * (matrix + matrix.T))
        normal = axes[:, 0]
        return np.eye(3) - 2.0 * np.outer(normal, normal)
    left, _, right = np.linalg.svd(matrix)
    turned: Any = np.diag([1.0, 1.0, -np.linalg.det(left @ right)])
    return left @ turned @ right
