"""What exporters leave wrong in skins, and what validators say of it, set right."""

from __future__ import annotations

from typing import Any

import numpy as np

from footfall.io.gltf_accessors import floats
from footfall.io.gltf_buffers import ARRAY_BUFFER, BufferBuilder
from footfall.io.gltf_document import GltfDocument

__all__ = ["lift_skins", "normalize_weights"]

NORMAL = 2e-7
"""Sums of weights may miss one by this for each influence [glTF 2.0, 3.7.3.3]."""


def lift_skins(document: dict[str, Any]) -> None:
    """Hang skinned meshes on no node: only their joints move them, and validators say so."""
    nodes = document["nodes"]
    lifted = [index for index, node in enumerate(nodes) if "mesh" in node and "skin" in node]
    for node in nodes:
        below = [child for child in node.get("children", []) if child not in lifted]
        if below != node.get("children", []):
            node["children"] = below
            if not below:
                del node["children"]
    for index in lifted:
        for name in ("translation", "rotation", "scale", "matrix"):
            if "children" not in nodes[index]:
                nodes[index].pop(name, None)
    for scene in document.get("scenes", []):
        shown = scene.get("nodes", [])
        scene["nodes"] = shown + [index for index in lifted if index not in shown]


def normalize_weights(
    document: dict[str, Any], source: GltfDocument, buffers: BufferBuilder
) -> None:
    """Let the weights of every vertex sum to one, as viewers would anyway."""
    for mesh in document.get("meshes", []):
        for primitive in mesh.get("primitives", []):
            attributes = primitive["attributes"]
            names = [name for name in attributes if name.startswith("WEIGHTS_")]
            if not names:
                continue
            weights = np.concatenate(
                [floats(source, attributes[name], 4) for name in names], axis=1
            )
            if np.abs(weights.sum(axis=1) - 1.0).max() <= NORMAL * weights.shape[1]:
                continue
            weights = np.maximum(weights, 0.0)
            weights[weights.sum(axis=1) <= 1e-9, 0] = 1.0
            weights /= weights.sum(axis=1, keepdims=True)
            for index, name in enumerate(names):
                part = weights[:, 4 * index : 4 * index + 4]
                attributes[name] = buffers.add(part, "f4", target=ARRAY_BUFFER)
