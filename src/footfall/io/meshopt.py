"""EXT_meshopt_compression: compressed buffers of vertices and triangles, unpacked.

After the bitstream specification of the extension [Khronos glTF registry, Vendor,
EXT_meshopt_compression]: vertices here, triangles in `meshopt_indices`, filters in
`meshopt_filters`. The kernels meet damaged data, so that each read is checked.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from footfall.compilation import kernel
from footfall.io.meshopt_filters import FILTERS
from footfall.io.meshopt_indices import read_sequence, read_triangles

__all__ = ["MeshoptError", "decode_meshopt"]

Bytes = npt.NDArray[np.uint8]

_STRIDES = {"OCTAHEDRAL": (4, 8), "QUATERNION": (8,)}
"""Bytes that an element must have under these filters."""

_VERTEX_HEADER, _TRIANGLE_HEADER, _SEQUENCE_HEADER = 0xA0, 0xE0, 0xD0


class MeshoptError(ValueError):
    """Compressed data that break the rules; the message says which, for the reader to place."""


def decode_meshopt(data: bytes, count: int, stride: int, mode: str, filter_name: str) -> bytes:
    """Unpack a compressed buffer view.

    Args:
        data: The compressed bytes.
        count: How many elements it holds.
        stride: Bytes of an element.
        mode: ATTRIBUTES, TRIANGLES or INDICES.
        filter_name: NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL.

    Returns:
        ``count * stride`` bytes.

    Raises:
        MeshoptError: If anything is not as the extension wants it.
    """
    source = np.frombuffer(data, dtype=np.uint8)
    if mode == "ATTRIBUTES":
        return _attributes(source, count, stride, filter_name)
    if mode not in ("TRIANGLES", "INDICES"):
        raise MeshoptError(f"mode {mode[:20]!r} is unknown")
    if stride not in (2, 4) or filter_name != "NONE":
        raise MeshoptError(f"indices of {stride} bytes and filter {filter_name[:20]!r}")
    indices = np.zeros(count, dtype=np.int64)
    numbers = source.astype(np.int64)
    if mode == "TRIANGLES":
        version = _version(source, _TRIANGLE_HEADER, 1)
        good = count % 3 == 0 and read_triangles(numbers, version, indices)
    else:
        version = _version(source, _SEQUENCE_HEADER, 1)
        good = read_sequence(numbers, indices)
    if not good:
        raise MeshoptError("its indices are damaged")
    return indices.astype("<u2" if stride == 2 else "<u4").tobytes()


def _version(source: Bytes, header: int, greatest: int) -> int:
    """Return the version that the first byte tells."""
    if source.size == 0 or source[0] & 0xF0 != header or source[0] & 0x0F > greatest:
        raise MeshoptError("its first byte is not that of its mode, or of a later version")
    return int(source[0] & 0x0F)


def _attributes(source: Bytes, count: int, stride: int, filter_name: str) -> bytes:
    _version(source, _VERTEX_HEADER, 0)
    if stride % 4 != 0:
        raise MeshoptError(f"its elements have {stride} bytes, no multiple of 4")
    decode = FILTERS.get(filter_name)
    if decode is None or stride not in _STRIDES.get(filter_name, (stride,)):
        raise MeshoptError(f"filter {filter_name[:20]!r} is unknown for {stride} bytes")
    tail = max(stride, 32)
    if source.size < 1 + tail:
        raise MeshoptError("it ends before its tail")
    vertices = np.zeros((count, stride), dtype=np.uint8)
    # The tail ends with the element that the first one is a difference from.
    before = source[source.size - stride :].copy()
    if not _read_vertices(source[: source.size - tail], before, vertices):
        raise MeshoptError("its vertices are damaged")
    return decode(vertices).tobytes()


@kernel
def _read_vertices(source: Bytes, before: Bytes, vertices: Bytes) -> bool:
    """Unpack the elements, byte lane by byte lane in blocks; False where data are damaged."""
    count, stride = vertices.shape
    largest = min((8192 // stride) & ~15, 256)
    deltas = np.zeros(256, dtype=np.uint8)
    at = 1
    for first in range(0, count, largest):
        size = min(largest, count - first)
        for lane in range(stride):
            at = _read_lane(source, at, (size + 15) // 16, deltas)
            if at < 0:
                return False
            value = np.int64(before[lane])
            for index in range(size):
                delta = np.int64(deltas[index])
                value = (value + ((delta >> 1) ^ -(delta & 1))) & 0xFF
                vertices[first + index, lane] = value
            before[lane] = value
    return at == source.size


@kernel
def _read_lane(source: Bytes, at: int, groups: int, deltas: Bytes) -> int:
    """Unpack groups of 16 differences; return where they end, or -1."""
    header = at
    at += (groups + 3) // 4
    if at > source.size:
        return -1
    for group in range(groups):
        bits = 1 << ((source[header + group // 4] >> (2 * (group % 4))) & 3)
        start = 16 * group
        if bits == 1:
            deltas[start : start + 16] = 0
            continue
        if bits == 8:
            if at + 16 > source.size:
                return -1
            deltas[start : start + 16] = source[at : at + 16]
            at += 16
            continue
        packed = at
        at += 2 * bits
        if at > source.size:
            return -1
        escape = (1 << bits) - 1
        for index in range(16):
            place = index * bits
            shift = 8 - bits - place % 8
            value = (source[packed + place // 8] >> shift) & escape
            if value == escape:
                # Too large for its few bits: it stands in full behind the group.
                if at >= source.size:
                    return -1
                value = source[at]
                at += 1
            deltas[start + index] = value
    return at
