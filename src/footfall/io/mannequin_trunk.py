"""The mannequin's pelvis, trunk, neck and head."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.io.body_plan import BodyPlan, Limb, Tone, across_axis, unit
from footfall.io.lofts import Loft, capsule, ellipsoid

__all__ = ["head_limbs", "trunk_limbs"]

# Half-width and half-depth of the trunk as shares of stature, from the pelvis to the neck.
_TRUNK_HEIGHTS = np.array([0.0, 0.25, 0.55, 0.78, 0.92, 1.0])
_TRUNK_WIDTHS = np.array([0.080, 0.072, 0.084, 0.092, 0.076, 0.040])
_TRUNK_DEPTHS = np.array([0.060, 0.053, 0.061, 0.062, 0.050, 0.036])


def trunk_limbs(plan: BodyPlan) -> tuple[Limb, ...]:
    """Return the pelvis, and a slice of the trunk for each spine joint."""
    height = plan.stature
    hips = [plan.rest[leg.hip] for leg in plan.anatomy.legs]
    apart = float(np.linalg.norm(hips[0] - hips[1]))
    pelvis = ellipsoid(
        0.5 * (hips[0] + hips[1]) + 0.018 * height * plan.up,
        plan.left,
        plan.up,
        (0.5 * apart + 0.038 * height, 0.062 * height, 0.059 * height),
    )
    limbs = [Limb(0, Tone.BODY, pelvis, 18)]
    path = plan.trunk_path
    bones = [plan.skeleton.rest_offsets[joint] for joint in path[1:]] + [plan.trunk_top]
    ends = np.concatenate([[0.0], np.cumsum([float(np.linalg.norm(bone)) for bone in bones])])
    heights = ends / max(float(ends[-1]), 1e-9)
    for joint, bone, span in zip(path, bones, pairwise(heights.tolist()), strict=True):
        if plan.visible(bone):
            limbs.append(Limb(joint, Tone.BODY, _slice(plan, bone, span), 18))
    return tuple(limbs)


def _slice(plan: BodyPlan, bone: Positions, span: tuple[float, float]) -> Loft:
    """Return the trunk along a bone, between two heights of 0 at the pelvis and 1 at the neck."""
    length = float(np.linalg.norm(bone))
    axis = unit(bone)
    across = across_axis(plan.left, axis)
    shares = np.linspace(0.0, 1.0, 4)
    half_width, half_depth = _trunk_profile(span[0] + shares * (span[1] - span[0]), plan.stature)
    dome = 0.3 * np.sqrt(half_width * half_depth)
    steps = (1.0, 0.85, 0.5)
    shrink = [0.0, 0.53, 0.87]
    along = [
        *(-step * dome[0] for step in steps),
        *(shares * length),
        *(length + step * dome[-1] for step in reversed(steps)),
    ]
    scale = np.array([*shrink, 1.0, 1.0, 1.0, 1.0, *reversed(shrink)])
    which = [0, 0, 0, 0, 1, 2, 3, 3, 3, 3]
    wide, deep = scale * half_width[which], scale * half_depth[which]
    centers: Positions = np.array(along)[:, np.newaxis] * axis
    return Loft(centers, across, np.cross(axis, across), np.stack([wide, deep, deep], axis=-1))


def _trunk_profile(heights: Floats, stature: float) -> tuple[Floats, Floats]:
    return (
        stature * np.interp(heights, _TRUNK_HEIGHTS, _TRUNK_WIDTHS),
        stature * np.interp(heights, _TRUNK_HEIGHTS, _TRUNK_DEPTHS),
    )


def head_limbs(plan: BodyPlan) -> tuple[Limb, ...]:
    """Return the neck and a head with a face that tells where it looks."""
    head = plan.anatomy.head
    if head is None:
        return ()
    size = plan.stature
    limbs: list[Limb] = []
    for joint, child in pairwise(plan.neck_path):
        offset = plan.skeleton.rest_offsets[child]
        if plan.visible(offset):
            neck = capsule(np.zeros(3), offset, 0.032 * size, 0.028 * size)
            limbs.append(Limb(joint, Tone.BODY, neck))
    up = across_axis(plan.up, plan.left)
    center = 0.062 * size * up + 0.014 * size * plan.forward
    skull = ellipsoid(center, plan.left, up, (0.044 * size, 0.066 * size, 0.054 * size))
    face_center = center + 0.036 * size * plan.forward - 0.002 * size * up
    face = ellipsoid(face_center, plan.left, up, (0.031 * size, 0.022 * size, 0.024 * size))
    return (*limbs, Limb(head, Tone.BODY, skull, 18), Limb(head, Tone.FACE, face))
