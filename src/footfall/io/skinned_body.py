"""A body with a skin: its vertices follow the joints of a skeleton."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Indices, Positions, Rotations, Weights
from footfall.compilation import kernel
from footfall.errors import ClipError
from footfall.geometry import quaternions
from footfall.io.gltf_document import GltfDocument
from footfall.motion import Clip
from footfall.skeleton import Skeleton

__all__ = ["INFLUENCES", "SkinnedBody", "skin_vertices"]

INFLUENCES = 4
"""Joints that move a vertex at most."""

SAME_BODY = 0.02
"""A clip is made for a body if every joint is within this share of the body's height of its place
in the parent: animators move joints a little within their parents."""


@dataclass(frozen=True, eq=False)
class SkinnedBody:
    """A skeleton, the skin around it, and the file that both came from.

    A vertex is a weighted mean of up to four points, each fixed in the frame of one joint
    (linear-blend skinning).
    """

    name: str
    """What messages call it."""

    skeleton: Skeleton
    """The body; its joints are unrotated in the pose in which the skin was bound."""

    anchors: Positions
    """The points of each vertex in the frames of its joints [m], shape (vertices, 4, 3)."""

    joints: Indices
    """The joints, shape (vertices, 4)."""

    weights: Weights
    """Shares of the joints, >= 0, summing to one over each row, shape (vertices, 4)."""

    triangles: Indices
    """Vertex indices, counterclockwise from outside, shape (triangles, 3)."""

    colors: Floats
    """Linear base color of each vertex, textures apart, within [0, 1], shape (vertices, 3)."""

    document: GltfDocument
    """The file."""

    nodes: tuple[int, ...]
    """The node of each joint in the file."""

    rest_rotations: Rotations
    """How the node of each joint is turned in the world where its joint is unrotated, shape
    (joints, 4)."""

    stretches: Floats
    """How much longer each joint's offset is in the world than its node's translation, shape
    (joints, 3)."""

    world_from_file: Floats
    """What takes the frame in which the pelvis' node stands to the world, shape (4, 4)."""

    @property
    def height(self) -> float:
        """Between the lowest and the highest joint at rest [m]."""
        positions = np.zeros((self.skeleton.count, 3))
        for joint, parent in enumerate(self.skeleton.parents.tolist()):
            if parent >= 0:
                positions[joint] = positions[parent] + self.skeleton.rest_offsets[joint]
        return float(np.ptp(positions[:, 1]))

    def check(self, clip: Clip) -> None:
        """Refuse a clip of another body.

        Raises:
            ClipError: If its joints or bones are not those of this body.
        """
        if not clip.skeleton.same_family(self.skeleton):
            raise ClipError(
                f"clip {clip.name!r} moves {', '.join(clip.skeleton.names[:5])}, ..., but "
                f"{self.name} has {', '.join(self.skeleton.names[:5])}, ...; retarget the clip "
                "onto it first"
            )
        away = np.linalg.norm(clip.skeleton.rest_offsets - self.skeleton.rest_offsets, axis=-1)
        if away.max() > SAME_BODY * self.height:
            joint = int(away.argmax())
            raise ClipError(
                f"clip {clip.name!r} has {self.skeleton.names[joint]!r} "
                f"{away[joint] * 1000.0:.1f} mm from where {self.name} has it; retarget the clip "
                "onto it first"
            )

    def vertices(self, world_rotations: Rotations, world_positions: Positions) -> Positions:
        """Return where the skin is.

        Args:
            world_rotations: The joints, shape (frames, joints, 4), as `Clip.world_poses` returns
                them.
            world_positions: The same [m], shape (frames, joints, 3).

        Returns:
            Shape (frames, vertices, 3) [m].
        """
        placed = np.empty((len(world_rotations), len(self.anchors), 3))
        skin_vertices(
            self.anchors,
            self.joints,
            self.weights,
            np.ascontiguousarray(world_rotations, dtype=np.float64),
            np.ascontiguousarray(world_positions, dtype=np.float64),
            placed,
        )
        return placed


@kernel
def skin_vertices(
    anchors: Positions,
    joints: Indices,
    weights: Weights,
    rotations: Rotations,
    positions: Positions,
    placed: Positions,
) -> None:
    """Place the vertices of a skin frame by frame; shapes as in `SkinnedBody`, frames leading."""
    for frame in range(rotations.shape[0]):
        for vertex in range(anchors.shape[0]):
            x = y = z = 0.0
            for influence in range(anchors.shape[1]):
                weight = weights[vertex, influence]
                if weight == 0.0:
                    continue
                joint = joints[vertex, influence]
                px, py, pz = quaternions.rotate(
                    rotations[frame, joint, 0],
                    rotations[frame, joint, 1],
                    rotations[frame, joint, 2],
                    rotations[frame, joint, 3],
                    anchors[vertex, influence, 0],
                    anchors[vertex, influence, 1],
                    anchors[vertex, influence, 2],
                )
                x += weight * (positions[frame, joint, 0] + px)
                y += weight * (positions[frame, joint, 1] + py)
                z += weight * (positions[frame, joint, 2] + pz)
            placed[frame, vertex, 0] = x
            placed[frame, vertex, 1] = y
            placed[frame, vertex, 2] = z
