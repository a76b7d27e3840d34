"""A ground that changes, put into a GLB file beside the character that walks on it."""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np

from footfall.arrays import Floats, Indices
from footfall.io.gltf_buffers import (
    ARRAY_BUFFER,
    ELEMENT_ARRAY_BUFFER,
    BufferBuilder,
    glb_bytes,
)

__all__ = ["with_ground"]

_COLOR = (0.32, 0.36, 0.40, 1.0)


def with_ground(
    glb: bytes, patterns: Floats, weights: Floats, times: Floats, grid: tuple[float, float, float]
) -> bytes:
    """Return a GLB file with a ground in its scene, whose heights its first animation moves.

    The heights are sums of patterns, each with a weight of its own at each time: in the file, a
    level mesh with a morph target a pattern.

    Args:
        glb: The file: a scene with an animation, as `footfall.io.save_gltf` writes it.
        patterns: Heights [m], shape (patterns, along z, along x).
        weights: How much there is of each, shape (times, patterns).
        times: When [s], shape (times,).
        grid: The x and z of the first height, and the distance between two [m].
    """
    document, binary = _parts(glb)
    first = len(document["accessors"])
    buffers = BufferBuilder()
    mesh = _mesh(patterns, weights[0], grid, buffers, first, len(document["materials"]))
    node = len(document["nodes"])
    document["nodes"].append({"name": "ground", "mesh": len(document["meshes"])})
    document["scenes"][0]["nodes"].append(node)
    document["meshes"].append(mesh)
    document["materials"].append(
        {
            "name": "ground",
            "doubleSided": True,
            "pbrMetallicRoughness": {
                "baseColorFactor": list(_COLOR),
                "metallicFactor": 0.0,
                "roughnessFactor": 0.95,
            },
        }
    )
    animation = document["animations"][0]
    sampler = {
        "input": first + buffers.add(times, "f4", bounds=True),
        "output": first + buffers.add(weights.reshape(-1), "f4"),
        "interpolation": "LINEAR",
    }
    animation["channels"].append(
        {"sampler": len(animation["samplers"]), "target": {"node": node, "path": "weights"}}
    )
    animation["samplers"].append(sampler)
    _append(document, buffers, len(binary))
    data = binary + buffers.data
    document["buffers"] = [{"byteLength": len(data)}]
    return glb_bytes(document, data)


def _parts(glb: bytes) -> tuple[dict[str, Any], bytes]:
    """Return the JSON and the buffer of a file of our own."""
    (length,) = struct.unpack_from("<I", glb, 12)
    document = json.loads(glb[20 : 20 + length])
    (size,) = struct.unpack_from("<I", glb, 20 + length)
    return document, glb[28 + length : 28 + length + size]


def _mesh(
    patterns: Floats,
    weights: Floats,
    grid: tuple[float, float, float],
    buffers: BufferBuilder,
    first: int,
    material: int,
) -> dict[str, Any]:
    _, rows, columns = patterns.shape
    left, back, spacing = grid
    places = np.zeros((rows, columns, 3))
    places[..., 0] = left + spacing * np.arange(columns)
    places[..., 2] = back + spacing * np.arange(rows)[:, np.newaxis]
    targets: list[dict[str, int]] = []
    position = first + buffers.add(places.reshape(-1, 3), "f4", target=ARRAY_BUFFER, bounds=True)
    for heights in patterns:
        moved = np.zeros((rows * columns, 3))
        moved[:, 1] = heights.reshape(-1)
        targets.append(
            {"POSITION": first + buffers.add(moved, "f4", target=ARRAY_BUFFER, bounds=True)}
        )
    triangles = first + buffers.add(
        _triangles(rows, columns).reshape(-1), "u4", target=ELEMENT_ARRAY_BUFFER
    )
    return {
        "name": "ground",
        "weights": np.float32(weights).tolist(),
        "primitives": [
            {
                "attributes": {"POSITION": position},
                "indices": triangles,
                "material": material,
                "targets": targets,
            }
        ],
    }


def _triangles(rows: int, columns: int) -> Indices:
    """Return two triangles a cell, counterclockwise from above."""
    corner = (np.arange(rows - 1)[:, np.newaxis] * columns + np.arange(columns - 1)).reshape(-1)
    one = np.stack([corner, corner + columns, corner + 1], axis=-1)
    other = np.stack([corner + 1, corner + columns, corner + columns + 1], axis=-1)
    return np.concatenate([one, other])


def _append(document: dict[str, Any], buffers: BufferBuilder, start: int) -> None:
    """Let the document know the new accessors and views, which begin at byte `start`."""
    views = len(document["bufferViews"])
    for view in buffers.views:
        document["bufferViews"].append({**view, "byteOffset": view["byteOffset"] + start})
    for accessor in buffers.accessors:
        document["accessors"].append({**accessor, "bufferView": accessor["bufferView"] + views})
