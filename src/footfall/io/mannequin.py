"""A mannequin of a skeleton's own size, so that a motion without a skin shows something.

Each limb moves rigidly with one joint; limbs overlap in round ends, so that no bend opens a
gap. Proportions follow the skeleton where it says something and adults (segment girths as
shares of stature) where it does not. Joints that are no part of a body plan, such as twist
joints, props and rig handles, get no limb.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Indices, Positions, Rotations
from footfall.io.body_plan import BodyPlan, Limb, Tone
from footfall.io.lofts import Loft, capsule, loft_surface
from footfall.io.mannequin_limbs import arm_limbs, leg_limbs
from footfall.io.mannequin_trunk import head_limbs, trunk_limbs
from footfall.skeleton import Anatomy, Skeleton

__all__ = ["Mannequin", "Tone", "mannequin"]


@dataclass(frozen=True, eq=False)
class Mannequin:
    """A closed surface for each limb of a skeleton, vertex by vertex in its joint's frame."""

    positions: Positions
    """Vertices in the frames of their joints [m], shape (vertices, 3)."""

    normals: Positions
    """Unit normals in the frames of their joints, shape (vertices, 3)."""

    joints: Indices
    """The joint that each vertex moves with, shape (vertices,)."""

    triangles: Indices
    """Vertex indices, counterclockwise from outside, shape (triangles, 3)."""

    tones: Indices
    """The `Tone` of each triangle, shape (triangles,)."""


def mannequin(
    skeleton: Skeleton, anatomy: Anatomy | None, toe_turns: Rotations | None = None
) -> Mannequin:
    """Return the mannequin of a skeleton.

    Args:
        skeleton: The body.
        anatomy: What its joints are, or None where that is unknown: then each bone becomes a
            plain capsule.
        toe_turns: How the left and the right toes are turned on a foot that stands flat, shape
            (2, 4): see `flat_toe_turns`. None: as at rest.
    """
    limbs = _plain_limbs(skeleton)
    if anatomy is not None:
        plan = BodyPlan(skeleton, anatomy)
        turns = np.tile([1.0, 0.0, 0.0, 0.0], (2, 1)) if toe_turns is None else toe_turns
        limbs = (*trunk_limbs(plan), *head_limbs(plan), *leg_limbs(plan, turns), *arm_limbs(plan))
    return _joined(limbs)


def _plain_limbs(skeleton: Skeleton) -> tuple[Limb, ...]:
    """Return a capsule for each bone that is long enough to be seen, at least one limb."""
    lengths = np.linalg.norm(skeleton.rest_offsets, axis=-1)
    shortest = 0.03 * float(lengths.max())
    limbs = [
        Limb(parent, Tone.BODY, _bone(skeleton.rest_offsets[joint]))
        for joint, parent in enumerate(skeleton.parents.tolist())
        if lengths[joint] > max(shortest, 1e-6)
    ]
    tips = np.linalg.norm(skeleton.tip_offsets, axis=-1)
    limbs += [
        Limb(joint, Tone.BODY, _bone(skeleton.tip_offsets[joint]))
        for joint in range(skeleton.count)
        if tips[joint] > max(shortest, 1e-6)
    ]
    if not limbs:
        limbs = [Limb(0, Tone.BODY, _bone(np.array([0.0, 0.1, 0.0])))]
    return tuple(limbs)


def _bone(offset: Positions) -> Loft:
    length = float(np.linalg.norm(offset))
    radius = float(np.clip(0.18 * length, 0.004, 0.06))
    return capsule(np.zeros(3), offset, radius, 0.8 * radius)


def _joined(limbs: tuple[Limb, ...]) -> Mannequin:
    surfaces = [loft_surface(limb.loft, limb.segments) for limb in limbs]
    counts = [len(surface.positions) for surface in surfaces]
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    return Mannequin(
        np.concatenate([surface.positions for surface in surfaces]),
        np.concatenate([surface.normals for surface in surfaces]),
        np.repeat([limb.joint for limb in limbs], counts),
        np.concatenate([s.triangles + start for s, start in zip(surfaces, starts, strict=True)]),
        np.repeat([limb.tone for limb in limbs], [len(s.triangles) for s in surfaces]),
    )
