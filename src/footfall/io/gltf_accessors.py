"""Accessors: typed arrays in the buffers of a glTF file [glTF 2.0, 3.6.2]."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.arrays import Floats, Indices
from footfall.io.gltf_document import GltfDocument
from footfall.io.json_record import JsonRecord

__all__ = ["floats", "integers"]

_COMPONENTS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


def floats(document: GltfDocument, index: int, width: int) -> Floats:
    """Return an accessor as real numbers; normalized integers become shares of their range.

    Args:
        document: The file.
        index: The accessor.
        width: How many numbers an element must have.

    Returns:
        The elements, shape (count, width).

    Raises:
        FileFormatError: If it reaches beyond its bytes, is of another width, or holds a number
            that is not finite.
    """
    record, stored = _elements(document, index, width)
    if stored.dtype.kind == "f" and not (np.abs(stored) < 1e12).all():
        element = int(np.argwhere(~(np.abs(stored) < 1e12))[0][0])
        record.fail("", f"holds a number in element {element} that is not finite and below 1e12")
    numbers = stored.astype(np.float64)
    if record.flag("normalized") and stored.dtype.kind in "iu":
        # The least signed integer is below -1 by a little, and stands for -1.
        numbers = np.maximum(numbers / np.iinfo(stored.dtype).max, -1.0)
    return numbers


def integers(document: GltfDocument, index: int, width: int) -> Indices:
    """Return an accessor of whole numbers, shape (count, width); errors as in `floats`."""
    record, stored = _elements(document, index, width)
    if stored.dtype.kind not in "iu":
        record.fail("componentType", "is a real number; a whole one is expected")
    return stored.astype(np.int64)


def _elements(
    document: GltfDocument, index: int, width: int
) -> tuple[JsonRecord, npt.NDArray[Any]]:
    record = document.item("accessors", index)
    kind = record.text("type")
    if _WIDTHS.get(kind) != width:
        record.fail("type", f"is {kind[:20]!r}; {width} numbers an element are expected")
    dtype = _dtype(record)
    count = record.integer("count", least=1)
    sparse = record.record("sparse")
    if record.has("bufferView"):
        elements = _strided(document, record, count, width, dtype)
    elif sparse is None or count * width <= 16 * document.size:
        elements = np.zeros((count if sparse is not None else 0, width), dtype=dtype)
    else:
        record.fail("count", f"is {count}, more than so small a file can hold")
    if sparse is not None:
        elements = elements.copy()
        _replace(document, sparse, elements)
    if len(elements) != count:
        record.fail("bufferView", "is missing, and no sparse elements stand for it")
    return record, elements


def _dtype(record: JsonRecord) -> np.dtype[Any]:
    component = record.integer("componentType")
    if component not in _COMPONENTS:
        record.fail("componentType", f"is {component}, which glTF does not know")
    return np.dtype(_COMPONENTS[component])


def _strided(
    document: GltfDocument, record: JsonRecord, count: int, width: int, dtype: np.dtype[Any]
) -> npt.NDArray[Any]:
    """Return a view of the elements, however far apart they stand."""
    number = record.integer("bufferView")
    view = document.item("bufferViews", number)
    data = document.view_bytes(number)
    element = width * dtype.itemsize
    stride = view.integer("byteStride", element, least=1, below=257)
    start = record.integer("byteOffset", 0)
    if stride < element:
        record.fail("bufferView", f"steps by {stride} bytes, but an element has {element}")
    if start + (count - 1) * stride + element > len(data):
        record.fail(
            "count",
            f"is {count} elements of {element} bytes, beyond the {len(data)} bytes of its view",
        )
    return np.ndarray((count, width), dtype, data, start, (stride, dtype.itemsize))


def _replace(document: GltfDocument, sparse: JsonRecord, elements: npt.NDArray[Any]) -> None:
    """Put the elements that a sparse accessor names in their places."""
    count = sparse.integer("count", least=1)
    places = sparse.record("indices")
    values = sparse.record("values")
    if places is None or values is None:
        sparse.fail("", "has no indices or no values")
    if not places.has("bufferView") or not values.has("bufferView"):
        sparse.fail("", "has indices or values without a bufferView")
    at = _strided(document, places, count, 1, _dtype(places))[:, 0]
    if at.dtype.kind != "u" or int(at.max()) >= len(elements):
        places.fail("", f"names an element beyond the {len(elements)} that there are")
    elements[at] = _strided(document, values, count, elements.shape[1], elements.dtype)
