"""Where the nodes of a glTF file are, by the letter of the specification and nothing clever.

Four by four matrices, one node and one moment at a time; plain float accessors only.
"""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false
# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false
# pyright: reportUnknownParameterType=false, reportMissingTypeStubs=false
from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["SlowGltf"]

Matrix = npt.NDArray[np.float64]
WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class SlowGltf:
    """A GLB file."""

    def __init__(self, path: Path) -> None:
        data = path.read_bytes()
        (size,) = struct.unpack_from("<I", data, 12)
        self.document: dict[str, Any] = json.loads(data[20 : 20 + size])
        self.buffer = data[28 + size :]
        self.nodes: list[Any] = self.document["nodes"]
        self.parents = {c: i for i, node in enumerate(self.nodes) for c in node.get("children", [])}

    def array(self, index: int) -> Matrix:
        """Return an accessor of floats, shape (count, width)."""
        record = self.document["accessors"][index]
        assert record["componentType"] == 5126
        view = self.document["bufferViews"][record["bufferView"]]
        width = WIDTHS[record["type"]]
        start = view.get("byteOffset", 0) + record.get("byteOffset", 0)
        step = view.get("byteStride", 4 * width)
        rows = [
            struct.unpack_from(f"<{width}f", self.buffer, start + i * step)
            for i in range(record["count"])
        ]
        return np.array(rows, dtype=np.float64)

    def properties(self, animation: int | None, time: float) -> dict[tuple[int, str], Matrix]:
        """Return the animated properties at a moment [s], quaternions xyzw."""
        if animation is None:
            return {}
        record = self.document["animations"][animation]
        found: dict[tuple[int, str], Matrix] = {}
        for channel in record["channels"]:
            path = channel["target"]["path"]
            if path != "weights":
                sampler = record["samplers"][channel["sampler"]]
                found[channel["target"]["node"], path] = self._value(sampler, path, time)
        return found

    def _value(self, sampler: Any, path: str, time: float) -> Matrix:
        times = self.array(sampler["input"])[:, 0]
        values = self.array(sampler["output"])
        kind = sampler.get("interpolation", "LINEAR")
        spline = kind == "CUBICSPLINE"
        if time <= times[0]:
            return values[1] if spline else values[0]
        if time >= times[-1]:
            return values[-2] if spline else values[-1]
        k = int(np.searchsorted(times, time, side="right")) - 1
        span = times[k + 1] - times[k]
        u = (time - times[k]) / span
        if kind == "STEP":
            return values[k]
        if spline:
            one, leave = values[3 * k + 1], values[3 * k + 2]
            arrive, other = values[3 * k + 3], values[3 * k + 4]
            mixed = (
                (2 * u**3 - 3 * u**2 + 1) * one
                + span * (u**3 - 2 * u**2 + u) * leave
                + (-2 * u**3 + 3 * u**2) * other
                + span * (u**3 - u**2) * arrive
            )
            return mixed / np.linalg.norm(mixed) if path == "rotation" else mixed
        one, other = values[k], values[k + 1]
        if path != "rotation":
            return (1 - u) * one + u * other
        one, other = one / np.linalg.norm(one), other / np.linalg.norm(other)
        if float(one @ other) < 0:
            other = -other
        # Of two unit quaternions nearly alike the cosine says nothing of the angle.
        angle = 2.0 * np.arctan2(np.linalg.norm(one - other), np.linalg.norm(one + other))
        if angle < 1e-9:
            return one
        return (np.sin((1 - u) * angle) * one + np.sin(u * angle) * other) / np.sin(angle)

    def local(self, node: int, moved: dict[tuple[int, str], Any]) -> Matrix:
        """Return what takes a node's frame to its parent's, shape (4, 4)."""
        record = self.nodes[node]
        if "matrix" in record:
            return np.array(record["matrix"]).reshape(4, 4).T
        translation = moved.get((node, "translation"), record.get("translation", [0, 0, 0]))
        x, y, z, w = moved.get((node, "rotation"), record.get("rotation", [0, 0, 0, 1]))
        scale = moved.get((node, "scale"), record.get("scale", [1, 1, 1]))
        matrix = np.eye(4)
        matrix[:3, :3] = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
            ]
        ) * np.array(scale)
        matrix[:3, 3] = translation
        return matrix

    def world(self, node: int, moved: dict[tuple[int, str], Any]) -> Matrix:
        """Return what takes a node's frame to the world, shape (4, 4)."""
        matrix = self.local(node, moved)
        while node in self.parents:
            node = self.parents[node]
            matrix = self.local(node, moved) @ matrix
        return matrix
