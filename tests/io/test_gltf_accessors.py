from __future__ import annotations

import base64
import json
import struct
from pathlib import Path
from typing import Any

import pytest

from footfall.errors import FileFormatError
from footfall.io.gltf_accessors import floats, integers
from footfall.io.gltf_document import GltfDocument, read_document


def document(tmp_path: Path, data: bytes, *accessors: dict[str, Any], **view: int) -> GltfDocument:
    """Return a document of one buffer and one view of all of it."""
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    content = {
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": len(data), "uri": uri}],
        "bufferViews": [{"buffer": 0, "byteLength": len(data), **view}],
        "accessors": accessors,
    }
    path = tmp_path / "a.gltf"
    path.write_text(json.dumps(content))
    return read_document(path)


def accessor(kind: str, component: int, count: int, **more: Any) -> dict[str, Any]:
    return {"bufferView": 0, "type": kind, "componentType": component, "count": count, **more}


def test_elements_may_stand_apart_and_begin_late(tmp_path: Path) -> None:
    data = struct.pack("<8f", 9, 1, 2, 9, 9, 3, 4, 9)
    read = document(tmp_path, data, accessor("VEC2", 5126, 2, byteOffset=4), byteStride=16)
    assert floats(read, 0, 2).tolist() == [[1.0, 2.0], [3.0, 4.0]]


@pytest.mark.parametrize(
    ("component", "stored", "meant"),
    [
        (5120, struct.pack("<4b", -128, -127, 0, 127), [-1.0, -1.0, 0.0, 1.0]),
        (5121, struct.pack("<4B", 0, 51, 204, 255), [0.0, 0.2, 0.8, 1.0]),
        (5122, struct.pack("<4h", -32768, -32767, 0, 32767), [-1.0, -1.0, 0.0, 1.0]),
        (5123, struct.pack("<4H", 0, 13107, 52428, 65535), [0.0, 0.2, 0.8, 1.0]),
    ],
)
def test_normalized_integers_are_shares_of_their_range(
    tmp_path: Path, component: int, stored: bytes, meant: list[float]
) -> None:
    read = document(tmp_path, stored, accessor("SCALAR", component, 4, normalized=True))
    assert floats(read, 0, 1)[:, 0] == pytest.approx(meant)


def sparse(count: int, places: int = 0, component: int = 5121) -> dict[str, Any]:
    return {
        "count": count,
        "indices": {"bufferView": 0, "byteOffset": places, "componentType": component},
        "values": {"bufferView": 0, "byteOffset": 4},
    }


def test_sparse_elements_stand_in_a_row_of_zeros_or_of_others(tmp_path: Path) -> None:
    data = struct.pack("<4B3f", 1, 3, 0, 0, 5.0, 6.0, 7.0)
    alone = {"type": "SCALAR", "componentType": 5126, "count": 4, "sparse": sparse(2)}
    others = accessor("SCALAR", 5126, 2, byteOffset=8, sparse=sparse(1, places=2))
    read = document(tmp_path, data, alone, others)
    assert floats(read, 0, 1)[:, 0].tolist() == [0.0, 5.0, 0.0, 6.0]
    assert floats(read, 1, 1)[:, 0].tolist() == [5.0, 7.0]
    # The bytes of the file stay as they are for whoever reads them next.
    assert floats(read, 0, 1)[:, 0].tolist() == [0.0, 5.0, 0.0, 6.0]


def test_whole_numbers_stay_whole(tmp_path: Path) -> None:
    read = document(tmp_path, struct.pack("<2I", 7, 2**32 - 1), accessor("SCALAR", 5125, 2))
    assert integers(read, 0, 1)[:, 0].tolist() == [7, 2**32 - 1]


FOUR = struct.pack("<4f", 1, 2, 3, 4)

FAULTS = (
    (accessor("VEC3", 5126, 1), "accessors[0].type is 'VEC3'; 1 numbers an element are expected"),
    (accessor("SCALAR", 5124, 1), "accessors[0].componentType is 5124, which glTF does not know"),
    (
        accessor("SCALAR", 5126, 5),
        "accessors[0].count is 5 elements of 4 bytes, beyond the 16 bytes of its view",
    ),
    (
        accessor("SCALAR", 5126, 4, byteOffset=4),
        "accessors[0].count is 4 elements of 4 bytes, beyond the 16 bytes of its view",
    ),
    (
        {"type": "SCALAR", "componentType": 5126, "count": 1},
        "accessors[0].bufferView is missing, and no sparse elements stand for it",
    ),
    (
        {"type": "SCALAR", "componentType": 5126, "count": 10**9, "sparse": sparse(1)},
        "accessors[0].count is 1000000000, more than so small a file can hold",
    ),
    (
        accessor("SCALAR", 5126, 1, sparse=sparse(1, places=2)),
        "accessors[0].sparse.indices names an element beyond the 1 that there are",
    ),
    (
        accessor("SCALAR", 5126, 1, sparse={"count": 1}),
        "accessors[0].sparse has no indices or no values",
    ),
)


@pytest.mark.parametrize(("record", "message"), FAULTS, ids=[fault[1][:60] for fault in FAULTS])
def test_a_false_promise_is_refused(tmp_path: Path, record: dict[str, Any], message: str) -> None:
    with pytest.raises(FileFormatError) as refusal:
        floats(document(tmp_path, FOUR, record), 0, 1)
    assert str(refusal.value) == f"{tmp_path / 'a.gltf'}: {message}"


@pytest.mark.parametrize("number", [float("nan"), float("inf"), 2e12])
def test_a_number_that_is_none_is_refused(tmp_path: Path, number: float) -> None:
    read = document(tmp_path, struct.pack("<2f", 1.0, number), accessor("SCALAR", 5126, 2))
    with pytest.raises(FileFormatError, match="in element 1 that is not finite and below 1e12"):
        floats(read, 0, 1)


def test_real_numbers_are_no_indices(tmp_path: Path) -> None:
    with pytest.raises(FileFormatError, match="is a real number; a whole one is expected"):
        integers(document(tmp_path, FOUR, accessor("SCALAR", 5126, 4)), 0, 1)


def test_elements_that_overlap_are_refused(tmp_path: Path) -> None:
    read = document(tmp_path, FOUR, accessor("VEC2", 5126, 2), byteStride=4)
    with pytest.raises(FileFormatError, match="steps by 4 bytes, but an element has 8"):
        floats(read, 0, 2)
