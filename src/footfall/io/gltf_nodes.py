"""The nodes of a glTF file: how they hang together, and how each stands in its parent."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Indices, Positions, Rotations
from footfall.geometry import from_matrix, rotate
from footfall.io.gltf_document import GltfDocument
from footfall.io.json_record import JsonRecord

__all__ = ["GltfNodes", "node_matrix", "read_nodes", "unit_rotations"]


@dataclass(frozen=True, eq=False)
class GltfNodes:
    """All nodes of a file, in its order."""

    records: list[JsonRecord]
    """What the file says of each."""

    parents: Indices
    """Parent of each; -1 for roots. Shape (nodes,)."""

    children: list[list[int]]
    """Children of each, in the order of the file."""

    translations: Positions
    """Where each stands in its parent [m], shape (nodes, 3)."""

    rotations: Rotations
    """How each is turned in its parent, shape (nodes, 4)."""

    scales: Floats
    """How much each stretches what is in it, axis by axis, shape (nodes, 3)."""

    @property
    def count(self) -> int:
        """How many nodes there are."""
        return len(self.records)

    def ancestors(self, node: int) -> list[int]:
        """Return a node's parent, its parent, and so on up to a root."""
        found: list[int] = []
        above = int(self.parents[node])
        while above >= 0:
            found.append(above)
            above = int(self.parents[above])
        return found

    def root_of(self, node: int) -> int:
        """Return the topmost node above a node, or itself."""
        return (node, *self.ancestors(node))[-1]

    def name(self, node: int) -> str:
        """Return what a node is called; its number where it has no name."""
        name = " ".join(self.records[node].text("name", "").split())
        return name or f"node {node}"


def read_nodes(document: GltfDocument) -> GltfNodes:
    """Read the nodes.

    Raises:
        FileFormatError: If a node has two parents, stands below itself, or stands in its parent
            as no translation, rotation and scale can say.
    """
    records = document.root.records("nodes")
    count = len(records)
    parents = np.full(count, -1, dtype=np.int64)
    children = [record.indices("children", count) for record in records]
    for node, below in enumerate(children):
        for child in below:
            if parents[child] != -1:
                records[child].fail(
                    "", f"is a child of node {int(parents[child])} and again of node {node}"
                )
            parents[child] = node
    _check_circles(parents, records)
    placed = [_placed(record) for record in records]
    return GltfNodes(
        records,
        parents,
        children,
        np.array([translation for translation, _, _ in placed]).reshape(-1, 3),
        np.array([rotation for _, rotation, _ in placed]).reshape(-1, 4),
        np.array([scale for _, _, scale in placed]).reshape(-1, 3),
    )


def _check_circles(parents: Indices, records: list[JsonRecord]) -> None:
    """Refuse nodes that stand below themselves."""
    reaches_root = np.zeros(len(parents), dtype=np.bool_)
    for start in range(len(parents)):
        path: list[int] = []
        node = start
        while node >= 0 and not reaches_root[node]:
            if len(path) > len(parents):
                records[start].fail("children", "lead back to the node itself")
            path.append(node)
            node = int(parents[node])
        reaches_root[path] = True


def _placed(record: JsonRecord) -> tuple[Positions, Rotations, Floats]:
    """Return translation, rotation and scale of a node."""
    if record.has("matrix"):
        return _decomposed(record)
    turn = np.roll(record.numbers("rotation", 4, (0.0, 0.0, 0.0, 1.0)), 1)
    return (
        record.numbers("translation", 3, (0.0, 0.0, 0.0)),
        unit_rotations(turn[np.newaxis], record, "rotation")[0],
        record.numbers("scale", 3, (1.0, 1.0, 1.0)),
    )


def _decomposed(record: JsonRecord) -> tuple[Positions, Rotations, Floats]:
    """Take the matrix of a node apart; glTF stores it column by column."""
    matrix = record.numbers("matrix", 16).reshape(4, 4).T
    scale = np.linalg.norm(matrix[:3, :3], axis=0)
    if not (scale > 1e-12).all():
        record.fail("matrix", "flattens what is in it")
    axes = matrix[:3, :3] / scale
    if np.abs(axes.T @ axes - np.eye(3)).max() > 1e-3:
        record.fail("matrix", "shears, which no translation, rotation and scale can say")
    if np.linalg.det(axes) < 0.0:
        axes, scale = -axes, -scale
    return matrix[:3, 3], from_matrix(axes), scale


def unit_rotations(rotations: Rotations, record: JsonRecord, name: str) -> Rotations:
    """Return rotations of unit length.

    Args:
        rotations: Quaternions wxyz, about of unit length, shape (..., 4).
        record: Where they stand, for messages.
        name: The member of it.

    Raises:
        FileFormatError: If one has a length that no rounding explains.
    """
    lengths = np.linalg.norm(rotations, axis=-1, keepdims=True)
    if not ((lengths > 0.5) & (lengths < 2.0)).all():
        worst = float(lengths.flat[int(np.abs(lengths - 1.0).argmax())])
        record.fail(name, f"holds a quaternion of length {worst:.3g}; rotations have length 1")
    return rotations / lengths


def node_matrix(nodes: GltfNodes, node: int) -> Floats:
    """Return what takes the frame of a node to that of its parent, shape (4, 4)."""
    matrix = np.eye(4)
    matrix[:3, :3] = rotate(nodes.rotations[node], np.eye(3)).T * nodes.scales[node]
    matrix[:3, 3] = nodes.translations[node]
    return matrix
