"""Against what meshoptimizer 1.3 made of numbers of our own, packed and unpacked again by it."""

from __future__ import annotations

import base64
import json
from pathlib import Path
from typing import Any

import pytest

from footfall.io.meshopt import MeshoptError, decode_meshopt

VECTORS: dict[str, Any] = json.loads(
    (Path(__file__).parent.parent / "golden" / "meshopt" / "vectors.json").read_text()
)
every_vector = pytest.mark.parametrize("name", sorted(VECTORS))


def packed(name: str) -> bytes:
    return base64.b64decode(VECTORS[name]["packed"])


def unpack(name: str, data: bytes) -> bytes:
    one = VECTORS[name]
    return decode_meshopt(data, one["count"], one["size"], one["mode"], one["filter"])


def test_there_is_a_vector_for_each_mode_and_filter() -> None:
    kinds = {(one["mode"], one["filter"]) for one in VECTORS.values()}
    assert kinds == {
        ("ATTRIBUTES", "NONE"),
        ("ATTRIBUTES", "OCTAHEDRAL"),
        ("ATTRIBUTES", "QUATERNION"),
        ("ATTRIBUTES", "EXPONENTIAL"),
        ("TRIANGLES", "NONE"),
        ("INDICES", "NONE"),
    }


@every_vector
def test_it_unpacks_as_meshoptimizer_does(name: str) -> None:
    assert unpack(name, packed(name)) == base64.b64decode(VECTORS[name]["plain"])


@every_vector
def test_what_is_cut_short_is_refused_wherever_the_cut_is(name: str) -> None:
    data = packed(name)
    for end in range(len(data)):
        with pytest.raises(MeshoptError):
            unpack(name, data[:end])


@every_vector
def test_another_first_byte_is_refused(name: str) -> None:
    data = packed(name)
    with pytest.raises(MeshoptError) as caught:
        unpack(name, b"\x00" + data[1:])
    assert str(caught.value) == "its first byte is not that of its mode, or of a later version"


@pytest.mark.parametrize(
    ("stride", "mode", "kind", "message"),
    [
        (4, "LINES", "NONE", "mode 'LINES' is unknown"),
        (3, "TRIANGLES", "NONE", "indices of 3 bytes and filter 'NONE'"),
        (4, "INDICES", "OCTAHEDRAL", "indices of 4 bytes and filter 'OCTAHEDRAL'"),
        (6, "ATTRIBUTES", "NONE", "its elements have 6 bytes, no multiple of 4"),
        (12, "ATTRIBUTES", "OCTAHEDRAL", "filter 'OCTAHEDRAL' is unknown for 12 bytes"),
        (4, "ATTRIBUTES", "COLOR", "filter 'COLOR' is unknown for 4 bytes"),
    ],
)
def test_what_the_extension_does_not_know_is_refused(
    stride: int, mode: str, kind: str, message: str
) -> None:
    with pytest.raises(MeshoptError) as caught:
        decode_meshopt(b"\xa0" + bytes(40), 1, stride, mode, kind)
    assert str(caught.value) == message
