"""The nodes of a scene file, and the skeleton among them: what FBX and USD have in common.

A scene holds cameras, meshes and bones in one tree, each placed in its parent by any matrix. A
body here has joints that turn, on bones of fixed length: so scales are multiplied out, joint by
joint, and what is left of a matrix is a turn and a place. The joints keep the frames that the file
gives them, so that all files of one rig agree on them, with or without a skin.
"""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path

import numpy as np

from footfall.arrays import Flags, Floats, Indices, Positions, Rotations
from footfall.errors import FileFormatError
from footfall.geometry import conjugate, continuous, multiply, rotate
from footfall.io.bvh_hierarchy import GREATEST
from footfall.io.bvh_rig import BvhRig
from footfall.io.rigid_frames import rigid_rotations

__all__ = ["SceneNodes", "rig_of_scene", "world_matrices"]

FIXED = 1e-6
"""A joint that moves less than this in its parent stays in place [m]."""


@dataclass(frozen=True, eq=False)
class SceneNodes:
    """The nodes of a scene in every frame."""

    names: tuple[str, ...]
    """What the file calls them."""

    parents: Indices
    """Index of each node's parent, -1 where there is none, shape (nodes,)."""

    joints: Flags
    """Which of them are joints of a skeleton, shape (nodes,)."""

    matrices: Floats
    """From each node to its parent [m], shape (frames, nodes, 4, 4)."""

    fps: float
    """Frames per second."""


def world_matrices(nodes: SceneNodes, path: Path) -> Floats:
    """Return the matrices from the nodes to the world, shape (frames, nodes, 4, 4).

    Numbers that are not finite spread to what hangs on them, and no further.

    Raises:
        FileFormatError: If a node is its own ancestor.
    """
    world = np.array(nodes.matrices)
    for node in _parents_first(nodes.parents, path):
        parent = int(nodes.parents[node])
        if parent >= 0:
            with np.errstate(invalid="ignore", over="ignore"):
                world[:, node] = world[:, parent] @ nodes.matrices[:, node]
    return world


def _parents_first(parents: Indices, path: Path) -> list[int]:
    """Return the nodes depth first, in the order of the file among brothers."""
    children: dict[int, list[int]] = {}
    for node, parent in enumerate(parents.tolist()):
        children.setdefault(parent, []).append(node)
    order: list[int] = []
    stack = children.get(-1, [])[::-1]
    while stack:
        node = stack.pop()
        order.append(node)
        stack += children.get(node, [])[::-1]
    if len(order) != len(parents):
        raise FileFormatError(
            f"{len(parents) - len(order)} of its {len(parents)} nodes hang on each other in a "
            "circle; each needs a way up to the root",
            path=path,
        )
    return order


def rig_of_scene(nodes: SceneNodes, path: Path) -> tuple[BvhRig, str]:
    """Return the largest skeleton of a scene and its motion, and a sentence about any others.

    Args:
        nodes: The scene, in metres, y up.
        path: The file, for messages.

    Raises:
        FileFormatError: If there is no skeleton, or a joint of it shrinks to nothing.
    """
    order = _parents_first(nodes.parents, path)
    tops = _tops(nodes, order)
    if not tops:
        raise FileFormatError(
            f"holds no skeleton: none of its {len(nodes.names)} nodes is a bone", path=path
        )
    sizes = {top: sum(1 for one in tops.values() if one == top) for top in set(tops.values())}
    largest = max(sizes, key=lambda top: (sizes[top], -top))
    joints = [node for node in order if tops.get(node) == largest]
    told = ""
    if len(sizes) > 1:
        told = (
            f"of {len(sizes)} skeletons that of {nodes.names[largest]!r} is read, which has the "
            f"most joints, {sizes[largest]}"
        )
    return _rig(nodes, joints, path), told


def _tops(nodes: SceneNodes, order: list[int]) -> dict[int, int]:
    """Return the highest joint above each joint; what lies between two joints is one, too."""
    below: set[int] = set()
    for node in reversed(order):
        if nodes.joints[node] or node in below:
            below.add(int(nodes.parents[node]))
    tops: dict[int, int] = {}
    for node in order:
        parent = int(nodes.parents[node])
        if parent in tops and (nodes.joints[node] or node in below):
            tops[node] = tops[parent]
        elif nodes.joints[node]:
            tops[node] = node
    return tops


def _rig(nodes: SceneNodes, joints: list[int], path: Path) -> BvhRig:
    world = world_matrices(nodes, path)[:, joints]
    rotations = rigid_rotations(world[..., :3, :3])
    sound = np.isfinite(rotations).all(axis=-1) & (np.abs(world) < GREATEST).all(axis=(-1, -2))
    if not sound.all():
        frame, joint = (int(index) for index in np.argwhere(~sound)[0])
        raise FileFormatError(
            f"joint {nodes.names[joints[joint]]!r} has no size or no place in frame {frame}; its "
            "scale must stay above zero, and its numbers below 1e12",
            path=path,
        )
    rows = {node: row for row, node in enumerate(joints)}
    parents = np.array([-1, *(rows[int(nodes.parents[node])] for node in joints[1:])])
    local, places = _relative(rotations, world[..., :3, 3], parents)
    offsets = np.median(places, axis=0)
    strays = np.abs(places - offsets).max(axis=(0, 2))
    moving = [0, *(int(joint) for joint in np.flatnonzero(strays > FIXED) if joint > 0)]
    return BvhRig(
        names=tuple(nodes.names[node] for node in joints),
        parents=parents,
        offsets=offsets,
        tips=np.zeros((len(joints), 3)),
        rotations=local,
        translations={joint: places[:, joint] for joint in moving},
        declared_frames=len(world),
        frame_time=1 / Decimal(nodes.fps),
    )


def _relative(
    rotations: Rotations, positions: Positions, parents: Indices
) -> tuple[Rotations, Positions]:
    """Return turns and places of the joints in their parents, the first one's in the world."""
    back = conjugate(rotations[:, parents[1:]])
    local, places = rotations.copy(), positions.copy()
    local[:, 1:] = multiply(back, rotations[:, 1:])
    places[:, 1:] = rotate(back, positions[:, 1:] - positions[:, parents[1:]])
    local /= np.linalg.norm(local, axis=-1, keepdims=True)
    return continuous(local), places
