"""Triangles and index sequences of EXT_meshopt_compression, as kernels.

A triangle is coded by an edge of one of the last sixteen edges, or by vertices of the last
sixteen vertices, or by a difference from the last index that was written in full.
"""

from __future__ import annotations

import numpy as np

from footfall.arrays import Indices
from footfall.compilation import kernel

__all__ = ["read_sequence", "read_triangles"]


@kernel
def _varint(source: Indices, at: int, end: int) -> tuple[int, int]:
    """Return a number of seven bits a byte, and where it ends; -1 where it does not."""
    value = 0
    for index in range(5):
        if at >= end:
            return 0, -1
        byte = int(source[at])
        at += 1
        value |= (byte & 127) << (7 * index)
        if byte < 128:
            break
    return value & 0xFFFFFFFF, at


@kernel
def _signed(value: int) -> int:
    return (value >> 1) ^ -(value & 1)


@kernel
def _push_edge(edges: Indices, state: Indices, one: int, other: int) -> None:
    edges[state[0] & 15, 0] = one
    edges[state[0] & 15, 1] = other
    state[0] += 1


@kernel
def _push_vertex(vertices: Indices, state: Indices, vertex: int) -> None:
    vertices[state[1] & 15] = vertex
    state[1] += 1


@kernel
def read_triangles(source: Indices, version: int, indices: Indices) -> bool:
    """Unpack triangles.

    Args:
        source: The compressed bytes, as whole numbers.
        version: 0 or 1, from the first of them.
        indices: Written, three a triangle, shape (count,).

    Returns:
        False where the data are damaged.
    """
    triangles = indices.size // 3
    end = source.size - 16
    at = 1 + triangles
    if at > end:
        return False
    edges = np.zeros((16, 2), dtype=np.int64)
    vertices = np.zeros(16, dtype=np.int64)
    # How many edges and vertices were pushed; the next new vertex; the last one in full.
    state = np.zeros(4, dtype=np.int64)
    for triangle in range(triangles):
        code = int(source[1 + triangle])
        corners = indices[3 * triangle : 3 * triangle + 3]
        if code < 0xF0:
            at = _beside_edge(source, at, end, code, version, edges, vertices, state, corners)
        else:
            at = _apart(source, at, end, code, edges, vertices, state, corners)
        if at < 0:
            return False
    return at == end


@kernel
def _beside_edge(
    source: Indices,
    at: int,
    end: int,
    code: int,
    version: int,
    edges: Indices,
    vertices: Indices,
    state: Indices,
    corners: Indices,
) -> int:
    """Unpack a triangle that shares an edge with a recent one; return where it ends, or -1."""
    edge = (state[0] - 1 - (code >> 4)) & 15
    a, b = int(edges[edge, 0]), int(edges[edge, 1])
    low = code & 15
    if low < (13 if version >= 1 else 15):
        if low == 0:
            c = state[2]
            state[2] += 1
            _push_vertex(vertices, state, c)
        else:
            c = vertices[(state[1] - 1 - low) & 15]
    else:
        if low == 15:
            value, at = _varint(source, at, end)
            if at < 0:
                return -1
            state[3] = (state[3] + _signed(value)) & 0xFFFFFFFF
        else:
            state[3] = (state[3] + (1 if low == 14 else -1)) & 0xFFFFFFFF
        c = state[3]
        _push_vertex(vertices, state, c)
    corners[0], corners[1], corners[2] = a, b, c
    _push_edge(edges, state, corners[2], corners[1])
    _push_edge(edges, state, corners[0], corners[2])
    return at


@kernel
def _place_corners(
    source: Indices,
    at: int,
    end: int,
    lows: tuple[int, int, int],
    full: int,
    vertices: Indices,
    state: Indices,
    corners: Indices,
) -> int:
    """Find three corners: new ones (0), recent ones, or (`full`) written ones; as `_apart`."""
    pushed = state[1]
    for corner in range(3):
        if lows[corner] == 0:
            corners[corner] = state[2]
            state[2] += 1
        elif lows[corner] < full:
            corners[corner] = vertices[(pushed - lows[corner]) & 15]
    for corner in range(3):
        if lows[corner] >= full:
            value, at = _varint(source, at, end)
            if at < 0:
                return -1
            state[3] = (state[3] + _signed(value)) & 0xFFFFFFFF
            corners[corner] = state[3]
    for corner in range(3):
        if lows[corner] == 0 or lows[corner] >= full:
            _push_vertex(vertices, state, corners[corner])
    return at


@kernel
def _apart(
    source: Indices,
    at: int,
    end: int,
    code: int,
    edges: Indices,
    vertices: Indices,
    state: Indices,
    corners: Indices,
) -> int:
    """Unpack a triangle that shares no recent edge; return where it ends, or -1."""
    if code < 0xFE:
        aux = int(source[end + (code & 15)])
        low_a = 0
    else:
        if at >= end:
            return -1
        aux = int(source[at])
        at += 1
        low_a = 0 if code == 0xFE else 15
        if aux == 0:
            state[2] = 0
    # In the table's codes 15 is the oldest vertex; behind the triangles it is an index in full.
    full = 15 if code >= 0xFE else 16
    at = _place_corners(
        source, at, end, (low_a, aux >> 4, aux & 15), full, vertices, state, corners
    )
    if at < 0:
        return -1
    a, b, c = corners[0], corners[1], corners[2]
    _push_edge(edges, state, b, a)
    _push_edge(edges, state, c, b)
    _push_edge(edges, state, a, c)
    return at


@kernel
def read_sequence(source: Indices, indices: Indices) -> bool:
    """Unpack indices that are differences from one of two earlier ones; False where damaged."""
    end = source.size - 4
    at = 1
    last = np.zeros(2, dtype=np.int64)
    for index in range(indices.size):
        value, at = _varint(source, at, end)
        if at < 0:
            return False
        current = value & 1
        last[current] = (last[current] + _signed(value >> 1)) & 0xFFFFFFFF
        indices[index] = last[current]
    return at == end
