"""Which nodes of a glTF file are the joints of its body, and how they are turned at rest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Rotations
from footfall.errors import FileFormatError
from footfall.geometry import conjugate, from_matrix, multiply, rotate
from footfall.io.gltf_accessors import floats
from footfall.io.gltf_document import GltfDocument
from footfall.io.gltf_nodes import GltfNodes
from footfall.io.json_record import JsonRecord

__all__ = ["GltfJoints", "bind_matrices", "find_joints"]

GREATEST_COUNT = 2000
"""More joints than this are no body: hair, cloth or a damaged file."""


@dataclass(frozen=True, eq=False)
class GltfJoints:
    """The nodes that move a body, a parent before its children."""

    nodes: tuple[int, ...]
    """The node of each joint."""

    parents: tuple[int, ...]
    """The joint that each joint stands in; -1 for the first."""

    names: tuple[str, ...]
    """What they are called, all different."""

    rest_rotations: Rotations
    """How each is turned in the world where the body is at rest, shape (joints, 4). Skeletons
    of this project have joints that are unrotated at rest; glTF lets them point anywhere."""

    def index(self, node: int) -> int | None:
        """Return the joint of a node; None where it is none."""
        return self.nodes.index(node) if node in self.nodes else None


def find_joints(document: GltfDocument, nodes: GltfNodes, animated: set[int]) -> GltfJoints:
    """Return the joints: those of the largest skin and of all skins on the same tree.

    Without a skin they are all nodes that an animation moves, with all below them that are no
    meshes, cameras or lights. Nodes above and between joints are joints too.

    Args:
        document: The file.
        nodes: Its nodes.
        animated: Those that some animation moves.

    Raises:
        FileFormatError: If there are none.
    """
    skins = [skin.indices("joints", nodes.count) for skin in document.root.records("skins")]
    largest: list[int] = max(skins, key=len, default=list[int]())
    if largest:
        root = nodes.root_of(largest[0])
        wanted = {j for skin in skins for j in skin if nodes.root_of(j) == root}
    else:
        wanted = _moved(nodes, animated)
    for node in tuple(wanted):
        wanted.update(nodes.ancestors(node))
    if not wanted:
        raise FileFormatError(
            "holds no skin and no animated nodes; there is no body", path=document.path
        )
    if len(wanted) > GREATEST_COUNT:
        raise FileFormatError(
            f"has {len(wanted)} joints; a body of at most {GREATEST_COUNT} is read",
            path=document.path,
        )
    order = _depth_first(nodes, wanted)
    parents = tuple(
        -1 if nodes.parents[node] < 0 else order.index(int(nodes.parents[node])) for node in order
    )
    names = _different([nodes.name(node) for node in order])
    return GltfJoints(tuple(order), parents, names, _rest(document, nodes, order, parents))


def _moved(nodes: GltfNodes, animated: set[int]) -> set[int]:
    """Return the animated nodes of the tree that has most of them, and what ends their limbs."""
    roots = [nodes.root_of(node) for node in sorted(animated)]
    if not roots:
        return set()
    root = max(roots, key=roots.count)
    wanted = {node for node in animated if nodes.root_of(node) == root}
    waiting = list(wanted)
    while waiting:
        for child in nodes.children[waiting.pop()]:
            record = nodes.records[child]
            if child not in wanted and not any(map(record.has, ("mesh", "camera", "extensions"))):
                wanted.add(child)
                waiting.append(child)
    return wanted


def _depth_first(nodes: GltfNodes, wanted: set[int]) -> list[int]:
    waiting = [nodes.root_of(min(wanted))]
    order: list[int] = []
    while waiting:
        node = waiting.pop()
        order.append(node)
        waiting += [child for child in reversed(nodes.children[node]) if child in wanted]
    return order


def _different(names: list[str]) -> tuple[str, ...]:
    """Return the names, a number behind each that is there already."""
    taken: set[str] = set()
    result: list[str] = []
    for name in names:
        number = 1
        unique = name
        while unique in taken:
            number += 1
            unique = f"{name}_{number}"
        taken.add(unique)
        result.append(unique)
    return tuple(result)


def bind_matrices(document: GltfDocument, skin: JsonRecord) -> Floats | None:
    """Return what takes the mesh of a skin into the frame of each of its joints.

    Returns:
        Shape (joints of the skin, 4, 4); None where the file says nothing, which means that mesh
        and joints share one frame.

    Raises:
        FileFormatError: If a matrix cannot be inverted, or there are too few.
    """
    if not skin.has("inverseBindMatrices"):
        return None
    index = skin.integer("inverseBindMatrices")
    matrices = floats(document, index, 16).reshape(-1, 4, 4).transpose(0, 2, 1)
    count = len(skin.content["joints"])
    if len(matrices) < count:
        skin.fail("inverseBindMatrices", f"holds {len(matrices)} matrices for {count} joints")
    matrices = matrices[:count]
    scales = np.linalg.norm(matrices[:, :3, :3], axis=1)
    if (
        scales.min() < 1e-9
        or np.abs(np.linalg.det(matrices[:, :3, :3] / scales.max())).min() < 1e-12
    ):
        skin.fail("inverseBindMatrices", "holds a matrix that flattens the mesh")
    return matrices


def _rest(
    document: GltfDocument, nodes: GltfNodes, order: list[int], parents: tuple[int, ...]
) -> Rotations:
    """Return the joints as they were when the skin was bound; else as the nodes are posed.

    Files may be posed as in any frame of their animation, but a skin is bound in a T-pose.
    """
    posed = np.empty((len(order), 4))
    for joint, (node, parent) in enumerate(zip(order, parents, strict=True)):
        own = nodes.rotations[node]
        posed[joint] = own if parent < 0 else multiply(posed[parent], own)
    bound = _bound(document, nodes, order)
    if not bound:
        return posed
    known = sorted(bound)
    turns = multiply(posed[known], conjugate(np.array([bound[joint] for joint in known])))
    upright = _upright(turns)
    rest = posed.copy()
    for joint, parent in enumerate(parents):
        if joint in bound:
            rest[joint] = multiply(upright, bound[joint])
        elif parent >= 0:
            rest[joint] = multiply(rest[parent], nodes.rotations[order[joint]])
    return rest


def _bound(document: GltfDocument, nodes: GltfNodes, order: list[int]) -> dict[int, Rotations]:
    """Return how the joints of the largest skin were turned in its mesh, by their index."""
    found: dict[int, Rotations] = {}
    skins = document.root.records("skins")
    skins.sort(key=lambda skin: -len(skin.indices("joints", nodes.count)))
    for skin in skins[:1]:
        matrices = bind_matrices(document, skin)
        if matrices is None:
            continue
        strangers = set(skin.indices("joints", nodes.count)) - set(order)
        if strangers:
            skin.fail("joints", f"hold node {min(strangers)}, which hangs on another root")
        axes = np.linalg.inv(matrices)[:, :3, :3]
        axes /= np.linalg.norm(axes, axis=1, keepdims=True)
        rotations = from_matrix(axes)
        for node, rotation in zip(skin.indices("joints", nodes.count), rotations, strict=True):
            found[order.index(node)] = rotation
    return found


def _upright(turns: Rotations) -> Rotations:
    """Return what stands the frame in which a skin was bound upright.

    Args:
        turns: How each joint has turned from there to how the file is posed, shape (joints, 4).
    """
    axes = np.concatenate([np.eye(3)[[1, 2, 0]], -np.eye(3)[[1, 2, 0]]])
    rises = [float(rotate(turns, axis)[:, 1].mean()) for axis in axes]
    axis = axes[int(np.argmax(rises))]
    sine = np.cross(axis, [0.0, 1.0, 0.0])
    cosine = float(axis[1])
    if cosine < -0.5:
        return np.array([0.0, 1.0, 0.0, 0.0])
    turn = np.concatenate([[1.0 + cosine], sine])
    return turn / np.linalg.norm(turn)
