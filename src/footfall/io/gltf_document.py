"""A glTF file taken apart: its JSON and the bytes of its buffers [glTF 2.0, chapters 3 and 4]."""

from __future__ import annotations

import base64
import binascii
import struct
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, cast
from urllib.parse import unquote

from footfall.errors import FileFormatError
from footfall.io.json_record import JsonRecord, parse_json
from footfall.io.meshopt import MeshoptError, decode_meshopt
from footfall.io.raw_file import read_bytes

__all__ = ["MESHOPT", "GltfDocument", "bytes_of_uri", "parse_gltf", "read_document"]

MESHOPT = "EXT_meshopt_compression"

UNDERSTOOD = frozenset(
    {
        MESHOPT,
        "KHR_mesh_quantization",
        "KHR_texture_transform",
        "KHR_texture_basisu",
        "KHR_lights_punctual",
        "KHR_animation_pointer",
        "EXT_texture_webp",
    }
)
"""Extensions that a file may require: the first two are read, the others bear on neither joints
nor skins. So do all whose names begin with ``KHR_materials_``."""

_JSON, _BIN = 0x4E4F534A, 0x004E4942


@dataclass(frozen=True, eq=False)
class GltfDocument:
    """All that a glTF file says."""

    root: JsonRecord
    """The JSON."""

    buffers: tuple[bytes | None, ...]
    """The bytes of each buffer; None for one that only stands in for compressed data."""

    path: Path
    """The file, for messages."""

    size: int
    """Bytes of the file and of all files beside it that it names."""

    _views: dict[int, bytes] = field(default_factory=dict[int, bytes])

    def item(self, kind: str, index: int) -> JsonRecord:
        """Return one object of a list of the root, such as ``("accessors", 3)``."""
        records = self.root.content.get(kind)
        count = len(records) if isinstance(records, list) else 0  # pyright: ignore[reportUnknownArgumentType]
        if not 0 <= index < count:
            raise FileFormatError(
                f"{kind}[{index}] is referred to, but there are {count}", path=self.path
            )
        content = self.root.content[kind][index]
        if not isinstance(content, dict):
            raise FileFormatError(f"{kind}[{index}] is no object", path=self.path)
        return JsonRecord(content, f"{kind}[{index}]", self.path)  # pyright: ignore[reportUnknownArgumentType]

    def view_bytes(self, index: int) -> bytes:
        """Return the bytes of a buffer view, decompressed where it is compressed.

        Raises:
            FileFormatError: If it reaches beyond its buffer or cannot be decompressed.
        """
        if index not in self._views:
            self._views[index] = self._read_view(self.item("bufferViews", index))
        return self._views[index]

    def _read_view(self, view: JsonRecord) -> bytes:
        extensions = view.record("extensions")
        packed = None if extensions is None else extensions.record(MESHOPT)
        if packed is None:
            return self._slice(view)
        count = packed.integer("count")
        stride = packed.integer("byteStride", least=1, below=257)
        if count * stride > 64 * self.size:
            packed.fail("count", f"is {count}, more than so small a file can hold")
        try:
            return decode_meshopt(
                self._slice(packed),
                count,
                stride,
                packed.text("mode"),
                packed.text("filter", "NONE"),
            )
        except MeshoptError as error:
            packed.fail("", f"cannot be decompressed: {error}")

    def _slice(self, view: JsonRecord) -> bytes:
        number = view.integer("buffer", below=max(len(self.buffers), 1))
        buffer = self.buffers[number] if self.buffers else None
        if buffer is None:
            view.fail("buffer", f"is {number}, which holds no data")
        start = view.integer("byteOffset", 0)
        length = view.integer("byteLength")
        if start + length > len(buffer):
            view.fail(
                "byteLength",
                f"is {length} from byte {start} on, but buffer {number} has {len(buffer)} bytes; "
                "the file was cut short",
            )
        return buffer[start : start + length]


def read_document(path: Path) -> GltfDocument:
    """Read a .glb or .gltf file and the buffers that it names.

    Raises:
        FileFormatError: If it breaks the rules of glTF, requires an extension that is not known,
            or names a file outside its own folder.
    """
    return parse_gltf(read_bytes(path), path)


def parse_gltf(data: bytes, path: Path) -> GltfDocument:
    """Take the bytes of a .glb or .gltf file apart; errors are those of `read_document`."""
    text, binary = _chunks(data, path) if data[:4] == b"glTF" else (data, None)
    root = parse_json(text, path)
    _check_version(root)
    required: Any = root.content.get("extensionsRequired") or []
    for name in cast(list[Any], required) if isinstance(required, list) else [required]:
        known = name in UNDERSTOOD if isinstance(name, str) else False
        if not known and not str(name).startswith("KHR_materials_"):
            raise FileFormatError(
                f"requires the extension {str(name)[:60]!r}, which is not read; export it "
                "without it",
                path=path,
            )
    buffers = [
        _buffer(record, index, binary) for index, record in enumerate(root.records("buffers"))
    ]
    size = len(data) + sum(len(b) for b in buffers if b is not None and b is not binary)
    return GltfDocument(root, tuple(buffers), path, size)


def _check_version(root: JsonRecord) -> None:
    asset = root.record("asset")
    version = "missing" if asset is None else asset.text("version")
    if not version.startswith("2."):
        root.fail("asset.version", f"is {version[:20]}; this program reads glTF 2")


def _chunks(data: bytes, path: Path) -> tuple[bytes, bytes | None]:
    """Return the JSON and the binary chunk of a GLB file [glTF 2.0, 4.4]."""
    if len(data) < 20:
        raise FileFormatError(
            f"has {len(data)} bytes; a GLB file begins with 20, so it was cut short", path=path
        )
    version, length = struct.unpack_from("<II", data, 4)
    if version != 2:
        raise FileFormatError(f"is GLB version {version}; this program reads 2", path=path)
    if length != len(data):
        raise FileFormatError(
            f"says that it has {length} bytes, but has {len(data)}; fetch it again", path=path
        )
    found: dict[int, bytes] = {}
    at = 12
    while at + 8 <= length:
        size, kind = struct.unpack_from("<II", data, at)
        if at + 8 + size > length:
            raise FileFormatError(
                f"a chunk of {size} bytes begins at byte {at}, beyond the end of the file",
                path=path,
            )
        found.setdefault(kind, data[at + 8 : at + 8 + size])
        at += 8 + size
    if _JSON not in found:
        raise FileFormatError("holds no JSON chunk; it is no GLB file", path=path)
    return found[_JSON], found.get(_BIN)


def _buffer(record: JsonRecord, index: int, binary: bytes | None) -> bytes | None:
    length = record.integer("byteLength")
    extensions = record.record("extensions")
    if extensions is not None and extensions.has(MESHOPT) and not record.has("uri"):
        return None
    if record.has("uri"):
        data = bytes_of_uri(record)
    elif index == 0 and binary is not None:
        data = binary
    else:
        record.fail("uri", "is missing, and there is no binary chunk for it")
    if len(data) < length:
        record.fail("byteLength", f"is {length}, but there are {len(data)} bytes")
    return data


def bytes_of_uri(record: JsonRecord) -> bytes:
    """Return what the ``uri`` of a buffer or an image holds.

    Raises:
        FileFormatError: If it is neither base64 data nor a file in or below the document's folder.
    """
    uri = record.text("uri")
    if uri.startswith("data:"):
        head, comma, body = uri.partition(",")
        if not comma or not head.endswith(";base64"):
            record.fail("uri", "is data, but not base64")
        try:
            return base64.b64decode(body, validate=True)
        except (binascii.Error, ValueError):
            record.fail("uri", "is no whole base64 data; the file was cut short")
    name = unquote(uri)
    folder = record.path.parent.resolve()
    try:
        place = (folder / name).resolve()
        inside = ":" not in name and "\\" not in name and place.is_relative_to(folder)
    except (OSError, ValueError, RuntimeError):
        inside, place = False, folder
    if not inside:
        record.fail("uri", f"is {name[:60]!r}; only files in or below its own folder are read")
    return read_bytes(place)
