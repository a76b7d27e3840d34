"""Meshes of glTF files: vertices, the joints that move them, triangles [glTF 2.0, 3.7]."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Indices, Positions, Weights
from footfall.io.gltf_accessors import floats, integers
from footfall.io.gltf_document import GltfDocument
from footfall.io.json_record import JsonRecord
from footfall.io.skinned_body import INFLUENCES

__all__ = ["GltfPrimitive", "read_primitives"]

_TRIANGLES, _STRIP, _FAN = 4, 5, 6


@dataclass(frozen=True, eq=False)
class GltfPrimitive:
    """A mesh of one material."""

    positions: Positions
    """Vertices in the mesh's own frame, shape (vertices, 3)."""

    joints: Indices
    """Index in the skin of the joints that move each vertex, shape (vertices, 4)."""

    weights: Weights
    """Their shares, >= 0, summing to one over each row, shape (vertices, 4)."""

    triangles: Indices
    """Vertex indices, counterclockwise from outside, shape (triangles, 3)."""

    color: Floats
    """Linear base color, shape (3,)."""


def read_primitives(document: GltfDocument, mesh: int, joint_count: int) -> list[GltfPrimitive]:
    """Read those primitives of a mesh that are made of triangles.

    Args:
        document: The file.
        mesh: Its index.
        joint_count: How many joints its skin has; one for a mesh without weights.

    Raises:
        FileFormatError: If it breaks the rules of glTF.
    """
    return [
        _primitive(document, record, joint_count)
        for record in document.item("meshes", mesh).records("primitives")
        if record.integer("mode", _TRIANGLES) in (_TRIANGLES, _STRIP, _FAN)
    ]


def _primitive(document: GltfDocument, record: JsonRecord, joint_count: int) -> GltfPrimitive:
    attributes = record.record("attributes")
    if attributes is None:
        record.fail("attributes", "are missing")
    positions = floats(document, attributes.integer("POSITION"), 3)
    joints, weights = _influences(document, attributes, len(positions), joint_count)
    if record.has("indices"):
        corners = integers(document, record.integer("indices"), 1)[:, 0]
        if corners.min() < 0 or corners.max() >= len(positions):
            record.fail("indices", f"name a vertex beyond the {len(positions)} that there are")
    else:
        corners = np.arange(len(positions))
    triangles = _triangles(corners, record.integer("mode", _TRIANGLES))
    return GltfPrimitive(positions, joints, weights, triangles, _color(document, record))


def _influences(
    document: GltfDocument, attributes: JsonRecord, count: int, joint_count: int
) -> tuple[Indices, Weights]:
    """Return the four joints of most weight for each vertex, weights summing to one."""
    sets = [
        (
            integers(document, attributes.integer(f"JOINTS_{index}"), 4),
            floats(document, attributes.integer(f"WEIGHTS_{index}"), 4),
        )
        for index in range(8)
        if attributes.has(f"JOINTS_{index}") and attributes.has(f"WEIGHTS_{index}")
    ]
    if not sets:
        weights = np.zeros((count, INFLUENCES))
        weights[:, 0] = 1.0
        return np.zeros((count, INFLUENCES), dtype=np.int64), weights
    if any(len(array) != count for pair in sets for array in pair):
        attributes.fail(
            "JOINTS_0", f"or WEIGHTS_0 hold not one element for each of {count} vertices"
        )
    joints = np.concatenate([one for one, _ in sets], axis=1)
    weights = np.maximum(np.concatenate([one for _, one in sets], axis=1), 0.0)
    kept = np.argsort(-weights, axis=1, kind="stable")[:, :INFLUENCES]
    joints, weights = np.take_along_axis(joints, kept, 1), np.take_along_axis(weights, kept, 1)
    if (joints[weights > 0.0] >= joint_count).any():
        attributes.fail("JOINTS_0", f"name a joint beyond the {joint_count} of the skin")
    joints[weights == 0.0] = 0
    totals = weights.sum(axis=1, keepdims=True)
    # A vertex without any weight stays on the first joint, as viewers have it.
    weights[totals[:, 0] <= 1e-9] = [1.0, 0.0, 0.0, 0.0]
    return joints, weights / weights.sum(axis=1, keepdims=True)


def _triangles(corners: Indices, mode: int) -> Indices:
    """Return triangles from a list, a strip or a fan of corners."""
    if mode == _TRIANGLES:
        return corners[: len(corners) // 3 * 3].reshape(-1, 3)
    count = max(len(corners) - 2, 0)
    one = np.arange(count)
    if mode == _FAN:
        return corners[np.stack([np.zeros(count, dtype=np.int64), one + 1, one + 2], axis=-1)]
    odd = one % 2
    return corners[np.stack([one, one + 1 + odd, one + 2 - odd], axis=-1)]


def _color(document: GltfDocument, record: JsonRecord) -> Floats:
    material = (
        document.item("materials", record.integer("material")) if record.has("material") else None
    )
    look = None if material is None else material.record("pbrMetallicRoughness")
    if look is None:
        return np.ones(3)
    return np.clip(look.numbers("baseColorFactor", 4, (1.0, 1.0, 1.0, 1.0))[:3], 0.0, 1.0)
