"""A mannequin of a skeleton's own size, so that a motion without a skin shows something.

The torso is one surface that bends with the spine. A limb moves with one joint; limbs meet in
balls of one size, so that elbows and knees stay round at any bend. Proportions follow the skeleton
where it says something and adults (segment girths as shares of stature) where it does not. Joints
that are no part of a body plan, such as twist joints, props and rig handles, get no limb.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Indices, Positions, Rotations
from footfall.geometry import rotate
from footfall.io.body_plan import BodyPlan, Limb, Tone
from footfall.io.lofts import Loft, capsule, loft_surface, vertex_rings
from footfall.io.mannequin_head import head_limbs
from footfall.io.mannequin_limbs import arm_limbs, leg_limbs
from footfall.io.mannequin_torso import torso_limb
from footfall.skeleton import Anatomy, Skeleton
from footfall.skeleton.landmarks import rest_positions

__all__ = ["Mannequin", "Tone", "mannequin"]


@dataclass(frozen=True, eq=False)
class Mannequin:
    """A closed surface for each limb of a skeleton, vertex by vertex in its joint's frame."""

    positions: Positions
    """Vertices in the frames of their joints [m], shape (vertices, 3)."""

    normals: Positions
    """Unit normals in the frames of their joints, shape (vertices, 3)."""

    joints: Indices
    """The joint that each vertex moves with most, shape (vertices,)."""

    others: Indices
    """Another joint that moves it too, or the same, shape (vertices,)."""

    shares: Floats
    """The share of the other joint, 0 to 0.5, shape (vertices,)."""

    triangles: Indices
    """Vertex indices, counterclockwise from outside, shape (triangles, 3)."""

    tones: Indices
    """The `Tone` of each triangle, shape (triangles,)."""

    limbs: Indices
    """The number of the limb of each triangle, shape (triangles,)."""

    rest: Positions
    """Where the joints are at rest, where their frames are parallel [m], shape (joints, 3)."""

    def placed(self, rotations: Rotations, positions: Positions) -> Positions:
        """Return the vertices of a posed body, each between where its two joints take it.

        Args:
            rotations: Of the joints in the world, shape (joints, 4).
            positions: The joints [m], shape (joints, 3).

        Returns:
            Vertices in the world [m], shape (vertices, 3).
        """
        carried = self.positions + self.rest[self.joints] - self.rest[self.others]
        own = positions[self.joints] + rotate(rotations[self.joints], self.positions)
        other = positions[self.others] + rotate(rotations[self.others], carried)
        return own + self.shares[:, np.newaxis] * (other - own)


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
        limbs = (torso_limb(plan), *head_limbs(plan), *leg_limbs(plan, turns), *arm_limbs(plan))
    return _joined(limbs, rest_positions(skeleton))


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


def _joined(limbs: tuple[Limb, ...], rest: Positions) -> Mannequin:
    surfaces = [loft_surface(limb.loft, limb.segments) for limb in limbs]
    counts = [len(surface.positions) for surface in surfaces]
    faces = [len(surface.triangles) for surface in surfaces]
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    moving = [_vertex_joints(limb) for limb in limbs]
    joints = np.concatenate([joints for joints, _, _ in moving])
    places = np.concatenate([surface.positions for surface in surfaces])
    return Mannequin(
        places + rest[np.repeat([limb.joint for limb in limbs], counts)] - rest[joints],
        np.concatenate([surface.normals for surface in surfaces]),
        joints,
        np.concatenate([others for _, others, _ in moving]),
        np.concatenate([shares for _, _, shares in moving]),
        np.concatenate([s.triangles + start for s, start in zip(surfaces, starts, strict=True)]),
        np.repeat([limb.tone for limb in limbs], faces),
        np.repeat(np.arange(len(limbs)), faces),
        rest,
    )


def _vertex_joints(limb: Limb) -> tuple[Indices, Indices, Floats]:
    """Return what moves each vertex of a limb: a joint, another one, the share of the other."""
    rings = vertex_rings(len(limb.loft.centers), limb.segments)
    if limb.bends is None:
        joints = np.full(len(rings), limb.joint, dtype=np.int64)
        return joints, joints, np.zeros(len(rings))
    return limb.bends.joints[rings], limb.bends.others[rings], limb.bends.shares[rings]
