"""Hundreds of bodies made of capsules, drawn as copies of one shape."""

from __future__ import annotations

import numpy as np
from viser import SceneApi

from footfall.arrays import Floats, Indices, Positions, Rotations
from footfall.geometry import multiply, rotate
from footfall.io.lofts import Loft, loft_surface
from footfall.skeleton import Anatomy, BodyPart, Skeleton

__all__ = ["CrowdFigures", "capsule_limbs", "from_vertical"]

MOST_LIMBS = 15
"""Capsules a body, beside that of its head."""

HEAD = 0.22
"""Height of a head whose tip the skeleton does not tell [m]."""

HEAD_SIZE = (0.085, 0.125, 0.1)
"""Half-axes of a head [m]."""


def capsule_limbs(skeleton: Skeleton, anatomy: Anatomy) -> tuple[Indices, Positions]:
    """Return the bones that are drawn: the longest ones, and the head.

    Returns:
        The joint that each moves with, shape (limbs,), and where it ends in that joint's frame
        [m], shape (limbs, 3).
    """
    lengths = [skeleton.bone_length(joint) for joint in range(skeleton.count)]
    ranked = sorted(range(1, skeleton.count), key=lambda joint: -lengths[joint])
    drawn = sorted(joint for joint in ranked[:MOST_LIMBS] if lengths[joint] > 0.02)
    joints = [int(skeleton.parents[joint]) for joint in drawn]
    ends = [skeleton.rest_offsets[joint] for joint in drawn]
    if anatomy.head is not None:
        tip = skeleton.tip_offsets[anatomy.head]
        joints.append(anatomy.head)
        ends.append(tip if np.linalg.norm(tip) > 0.05 else np.array([0.0, HEAD, 0.0]))
    return np.array(joints), np.array(ends)


class CrowdFigures:
    """Bodies of one skeleton."""

    def __init__(
        self, scene: SceneApi, name: str, skeleton: Skeleton, anatomy: Anatomy, size: int
    ) -> None:
        """Put so many bodies into the scene."""
        self._joints, ends = capsule_limbs(skeleton, anatomy)
        self._middles = 0.5 * ends
        lengths = np.linalg.norm(ends, axis=-1)
        self._aligned = from_vertical(ends / lengths[:, np.newaxis])
        girths = np.clip(0.24 * lengths, 0.04, 0.085) * _stoutness(self._joints, anatomy)
        scales = np.stack([girths, 0.5 * lengths + 0.35 * girths, girths], axis=-1)
        head = self._joints == anatomy.head
        scales[head] = HEAD_SIZE
        count = size * len(self._joints)
        surface = loft_surface(_unit_capsule(), 6)
        self._node = scene.add_batched_meshes_simple(
            name,
            surface.positions.astype(np.float32),
            surface.triangles,
            batched_wxyzs=np.tile([1.0, 0.0, 0.0, 0.0], (count, 1)),
            batched_positions=np.zeros((count, 3)),
            batched_scales=np.tile(scales, (size, 1)).astype(np.float32),
            batched_colors=np.tile(np.array([[200, 204, 210]], dtype=np.uint8), (count, 1)),
            lod="off",
            cast_shadow=False,
            receive_shadow=False,
        )

    def pose(self, positions: Positions, rotations: Rotations, shifts: Positions) -> None:
        """Move them.

        Args:
            positions: Joints in the world [m], shape (size, joints, 3).
            rotations: Joints in the world, shape (size, joints, 4).
            shifts: How far each body is drawn beside where it is [m], shape (size, 3).
        """
        turned = rotations[:, self._joints]
        places = positions[:, self._joints] + shifts[:, np.newaxis] + rotate(turned, self._middles)
        turns = multiply(turned, self._aligned)
        self._node.batched_positions = places.reshape(-1, 3).astype(np.float32)
        self._node.batched_wxyzs = turns.reshape(-1, 4).astype(np.float32)

    def paint(self, colors: Floats) -> None:
        """Give each body a color, 0 to 255, shape (size, 3)."""
        self._node.batched_colors = np.repeat(colors, len(self._joints), axis=0).astype(np.uint8)

    def show(self, visible: bool) -> None:
        """Show or hide them."""
        self._node.visible = visible

    def remove(self) -> None:
        """Take them out of the scene."""
        self._node.remove()


def _stoutness(joints: Indices, anatomy: Anatomy) -> Floats:
    """Return how thick limbs are for their length: trunks are stout, shape (limbs,)."""
    trunk = anatomy.parts[joints] == BodyPart.TRUNK
    return np.where(trunk, 1.5, 1.0)


def _unit_capsule() -> Loft:
    """Return a round bone from -1 to 1 along y, of radius 1 in the middle."""
    along = np.array([-1.0, -0.85, -0.55, 0.55, 0.85, 1.0])
    radii = np.array([0.0, 0.72, 1.0, 1.0, 0.72, 0.0])
    centers = np.stack([np.zeros(6), along, np.zeros(6)], axis=-1)
    across, over = np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0])
    return Loft(centers, across, over, np.repeat(radii[:, np.newaxis], 3, axis=1))


def from_vertical(directions: Positions) -> Rotations:
    """Return the shortest rotations that take +y to unit directions, shape (n, 3)."""
    axis = np.cross(np.array([0.0, 1.0, 0.0]), directions)
    turned = np.concatenate([1.0 + directions[:, 1:2], axis], axis=-1)
    # Straight down has no shortest turn: any half turn about a horizontal axis does.
    turned[directions[:, 1] < -1.0 + 1e-9] = [0.0, 1.0, 0.0, 0.0]
    return turned / np.linalg.norm(turned, axis=-1, keepdims=True)
