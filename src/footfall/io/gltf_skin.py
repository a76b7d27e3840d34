"""Skinned characters in: the meshes of a glTF file, bound to the joints of its body."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from footfall.arrays import Floats, Indices, Positions, Weights
from footfall.errors import FileFormatError
from footfall.geometry import rotate
from footfall.io.bvh_clip import clip_from_rig
from footfall.io.conclusions import Conclusion
from footfall.io.gltf_clip import GltfBody, gltf_body
from footfall.io.gltf_document import GltfDocument, read_document
from footfall.io.gltf_joints import bind_matrices
from footfall.io.gltf_mesh import GltfPrimitive, read_primitives
from footfall.io.gltf_nodes import node_matrix
from footfall.io.gltf_rig import rig_at
from footfall.io.skinned_body import SkinnedBody
from footfall.io.stated import Stated
from footfall.io.units import parse_unit

__all__ = ["load_skinned"]


@dataclass(frozen=True, eq=False)
class _Piece:
    """The part of a skin that one primitive makes."""

    anchors: Positions
    joints: Indices
    weights: Weights
    triangles: Indices
    color: Floats


def load_skinned(path: Path | str) -> SkinnedBody:
    """Read a character from a .glb or .gltf file: skeleton, skin, and the file itself.

    Meshes that hang rigidly on a joint belong to the skin too. Weights are normalized, and of
    more than four the greatest are kept. Animations in the file are left alone; `footfall.load`
    reads them as clips of the same skeleton.

    Raises:
        FileFormatError: If the file breaks the rules of glTF, or has no mesh on its joints.
    """
    document = read_document(Path(path))
    body = gltf_body(document)
    rig = rig_at(document, body.nodes, body.joints, [], np.zeros(1), 30.0)
    stated = Stated(
        Conclusion(parse_unit("m"), "m, as always in glTF"),
        Conclusion("y", "y, as always in glTF"),
        Conclusion(30.0, "30 frames per second, of which there is one"),
    )
    clip, _ = clip_from_rig(rig, document.path, stated=stated)
    # Joints above the pelvis were folded into it: they stand first.
    folded = len(body.joints.nodes) - clip.skeleton.count
    bound = _bound_frames(body)
    pieces = [
        piece
        for node in range(body.nodes.count)
        for piece in _pieces(document, body, node, folded, bound)
    ]
    if not pieces:
        raise FileFormatError("has no mesh on its joints; there is no skin", path=document.path)
    counts = [len(piece.anchors) for piece in pieces]
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    above = _world_matrix(body, body.nodes.ancestors(body.joints.nodes[folded])[::-1])
    return SkinnedBody(
        name=document.path.name,
        skeleton=clip.skeleton,
        anchors=np.concatenate([piece.anchors for piece in pieces]),
        joints=np.concatenate([piece.joints for piece in pieces]),
        weights=np.concatenate([piece.weights for piece in pieces]),
        triangles=np.concatenate(
            [piece.triangles + start for piece, start in zip(pieces, starts, strict=True)]
        ),
        colors=np.repeat(np.stack([piece.color for piece in pieces]), counts, axis=0),
        document=document,
        nodes=body.joints.nodes[folded:],
        rest_rotations=body.joints.rest_rotations[folded:],
        stretches=_stretches(body)[list(body.joints.parents[folded:])],
        world_from_file=above,
    )


def _world_matrix(body: GltfBody, path: list[int]) -> Floats:
    """Return the product of the matrices of nodes, the topmost first, shape (4, 4)."""
    matrix = np.eye(4)
    for node in path:
        matrix = matrix @ node_matrix(body.nodes, node)
    return matrix


def _bound_frames(body: GltfBody) -> Floats:
    """Return what takes each joint node's own frame to its joint's, shape (joints, 3, 3).

    The node's frame is stretched by all scales above it; its joint's is not, and is turned back
    to where joints are unrotated at rest.
    """
    axes = rotate(body.joints.rest_rotations[:, np.newaxis], np.eye(3)).transpose(0, 2, 1)
    return axes * _stretches(body)[:, np.newaxis]


def _stretches(body: GltfBody) -> Floats:
    """Return how much the frame of each joint's node is stretched in the world, (joints, 3)."""
    stretches = np.ones((len(body.joints.nodes), 3))
    for joint, node in enumerate(body.joints.nodes):
        parent = body.joints.parents[joint]
        above = 1.0 if parent < 0 else stretches[parent].mean()
        stretches[joint] = above * body.nodes.scales[node]
    return stretches


def _pieces(
    document: GltfDocument, body: GltfBody, node: int, folded: int, bound: Floats
) -> list[_Piece]:
    """Return what the mesh of a node adds to the skin; nothing where it hangs on no joint."""
    record = body.nodes.records[node]
    if not record.has("mesh"):
        return []
    mesh = record.integer("mesh")
    if not record.has("skin"):
        chain = [node, *body.nodes.ancestors(node)]
        on = next(
            (body.joints.index(one) for one in chain if body.joints.index(one) is not None), None
        )
        if on is None or on < folded:
            return []
        local = _world_matrix(body, chain[: chain.index(body.joints.nodes[on])][::-1])
        bind = (bound[on] @ local[:3])[np.newaxis]
        return [
            _piece(one, bind, np.array([on - folded])) for one in read_primitives(document, mesh, 1)
        ]
    skin = document.item("skins", record.integer("skin"))
    nodes = skin.indices("joints", body.nodes.count)
    joints = [body.joints.index(one) for one in nodes]
    if not joints or None in joints:
        return []
    known = np.array([joint or 0 for joint in joints])
    matrices = bind_matrices(document, skin)
    if matrices is None:
        matrices = np.tile(np.eye(4), (len(known), 1, 1))
    bind = bound[known] @ matrices[:, :3]
    _fold(bind, known, body, folded)
    # What hangs on a joint above the pelvis moves with the pelvis.
    known = np.maximum(known - folded, 0)
    return [_piece(one, bind, known) for one in read_primitives(document, mesh, len(known))]


def _fold(bind: Floats, joints: Indices, body: GltfBody, folded: int) -> None:
    """Bind vertices of joints above the pelvis to the pelvis, as the file is posed."""
    pelvis = body.joints.nodes[folded]
    path = [pelvis, *body.nodes.ancestors(pelvis)][::-1]
    world = _world_matrix(body, path)
    scale = np.linalg.norm(world[:3, :3], axis=0).mean()
    back = rotate(body.joints.rest_rotations[folded], np.eye(3)).T @ (world[:3, :3] / scale).T
    for row in np.flatnonzero(joints < folded):
        joint = int(joints[row])
        above = _world_matrix(body, path[: path.index(body.joints.nodes[joint]) + 1])
        turn = rotate(body.joints.rest_rotations[joint], np.eye(3))
        scales = np.linalg.norm(above[:3, :3], axis=0)
        posed = (above[:3, :3] / scales) @ turn @ bind[row]
        posed[:, 3] += above[:3, 3] - world[:3, 3]
        bind[row] = back @ posed


def _piece(primitive: GltfPrimitive, bind: Floats, joints: Indices) -> _Piece:
    """Return the vertices of a primitive in the frames of their joints.

    Args:
        primitive: The mesh.
        bind: What takes the mesh to the frame of each joint of its skin, shape (joints, 3, 4).
        joints: Those joints in the body's own order, shape (joints,).
    """
    matrices = bind[primitive.joints]
    anchors = np.einsum("vkij,vj->vki", matrices[..., :3], primitive.positions) + matrices[..., 3]
    return _Piece(
        anchors, joints[primitive.joints], primitive.weights, primitive.triangles, primitive.color
    )
