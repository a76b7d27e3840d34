"""glTF documents made by hand: a leg under a scaled and turned root, animated as one likes."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from footfall.io.gltf_buffers import BufferBuilder, glb_bytes

__all__ = ["SmallGltf"]

QUARTER = float(np.sqrt(0.5))


class SmallGltf:
    """A rig that lies along z in centimetres, stood up and made metres by the node above it."""

    def __init__(self) -> None:
        self.buffers = BufferBuilder()
        self.document: dict[str, Any] = {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [
                {
                    "name": "Armature",
                    "rotation": [-QUARTER, 0, 0, QUARTER],
                    "scale": [0.01, 0.01, 0.01],
                    "children": [1],
                },
                {"name": "Hips", "translation": [0, 0, 95], "children": [2, 5, 8]},
                *self._leg("Left", 10, 3),
                *self._leg("Right", -10, 6),
                {"name": "Spine", "translation": [0, 0, 20], "children": [9]},
                {"name": "Head", "translation": [0, 0, 40]},
            ],
        }

    def _leg(self, side: str, x: float, knee: int) -> list[dict[str, Any]]:
        return [
            {"name": f"{side}UpLeg", "translation": [x, 0, -5], "children": [knee]},
            {"name": f"{side}Leg", "translation": [0, 1, -42], "children": [knee + 1]},
            {"name": f"{side}Foot", "translation": [0, 0, -42]},
        ]

    def animate(
        self, node: int, path: str, times: Any, values: Any, interpolation: str = "LINEAR"
    ) -> None:
        """Add a channel to the last animation, to the first one if there is none."""
        if "animations" not in self.document:
            self.start("move")
        animation = self.document["animations"][-1]
        animation["channels"].append(
            {"sampler": len(animation["samplers"]), "target": {"node": node, "path": path}}
        )
        animation["samplers"].append(
            {
                "input": self.buffers.add(np.array(times, dtype=np.float64), "f4", bounds=True),
                "output": self.buffers.add(np.array(values, dtype=np.float64), "f4"),
                "interpolation": interpolation,
            }
        )

    def start(self, name: str) -> None:
        """Begin another animation."""
        self.document.setdefault("animations", []).append(
            {"name": name, "samplers": [], "channels": []}
        )

    def _finished(self) -> dict[str, Any]:
        document = json.loads(json.dumps(self.document))
        if self.buffers.views:
            document["bufferViews"] = self.buffers.views
            document["accessors"] = document.get("accessors") or self.buffers.accessors
            document["buffers"] = [{"byteLength": len(self.buffers.data)}]
        return document

    def write(self, path: Path) -> Path:
        """Write a .glb file, and return its path."""
        path.write_bytes(glb_bytes(self._finished(), self.buffers.data))
        return path

    def write_apart(self, path: Path, uri: str) -> Path:
        """Write a .gltf file whose buffer is at a URI, and return its path."""
        document = self._finished()
        document["buffers"][0]["uri"] = uri
        path.write_text(json.dumps(document))
        return path
