"""The binary half of a GLB file: arrays become accessors into one buffer [glTF 2.0, 3.6]."""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["BufferBuilder", "glb_bytes"]

ARRAY_BUFFER = 34962
ELEMENT_ARRAY_BUFFER = 34963

_COMPONENTS = {"f4": 5126, "u1": 5121, "u2": 5123, "u4": 5125}
_SHAPES = {(): "SCALAR", (2,): "VEC2", (3,): "VEC3", (4,): "VEC4", (4, 4): "MAT4"}


class BufferBuilder:
    """Collects arrays; each gets an accessor and a buffer view of its own."""

    def __init__(self) -> None:
        self.accessors: list[dict[str, Any]] = []
        self.views: list[dict[str, Any]] = []
        self._data = bytearray()

    def add(
        self,
        array: npt.NDArray[Any],
        kind: str,
        *,
        target: int | None = None,
        bounds: bool = False,
        normalized: bool = False,
    ) -> int:
        """Append an array and return the index of its accessor.

        Args:
            array: The elements, shape (count, ...) with a shape that glTF knows.
            kind: How a number is stored: ``"f4"``, ``"u1"``, ``"u2"`` or ``"u4"``.
            target: ARRAY_BUFFER or ELEMENT_ARRAY_BUFFER for vertex data, else None.
            bounds: Whether to state the least and greatest elements.
            normalized: Whether integers stand for shares of their range.
        """
        stored = np.ascontiguousarray(array, dtype=f"<{kind}")
        view = self.add_view(stored.tobytes(), **({} if target is None else {"target": target}))
        accessor: dict[str, Any] = {
            "bufferView": view,
            "componentType": _COMPONENTS[kind],
            "count": len(stored),
            "type": _SHAPES[stored.shape[1:]],
        }
        if normalized:
            accessor["normalized"] = True
        if bounds:
            accessor["min"] = np.atleast_1d(stored.min(axis=0)).tolist()
            accessor["max"] = np.atleast_1d(stored.max(axis=0)).tolist()
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def add_view(self, data: bytes, **facts: Any) -> int:
        """Append bytes and return the index of their view; `facts` are said of it besides."""
        self.views.append(
            {"buffer": 0, "byteOffset": len(self._data), "byteLength": len(data), **facts}
        )
        self._data += data
        self._data += bytes(-len(self._data) % 4)
        return len(self.views) - 1

    @property
    def data(self) -> bytes:
        """The buffer so far, padded to four bytes."""
        return bytes(self._data)


def glb_bytes(document: dict[str, Any], data: bytes) -> bytes:
    """Return a GLB file: a header, the document as JSON, and the buffer [glTF 2.0, 4.4]."""
    text = json.dumps(document, ensure_ascii=False, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    chunks += struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks
