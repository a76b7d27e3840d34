"""Where the bones of a binary FBX file are, read byte by byte and turned matrix by matrix.

Knows what the test files need: version 7, one animation layer a take, constant, linear and
unweighted cubic keys, and the node transform of the FBX SDK's manual:
T · Roff · Rp · Rpre · R · Rpost⁻¹ · Rp⁻¹ · Soff · Sp · S · Sp⁻¹.
"""

from __future__ import annotations

import struct
import zlib
from typing import Any

import numpy as np
import numpy.typing as npt

Matrix = npt.NDArray[np.float64]

TICKS = 46186158000
"""Of FBX time in a second."""

ORDERS = ("XYZ", "XZY", "YZX", "YXZ", "ZXY", "ZYX")
"""Axes in the order in which they turn, by number."""


class Record:
    """A node of the file's own tree."""

    def __init__(self, name: str, values: list[Any], children: list[Record]) -> None:
        self.name, self.values, self.children = name, values, children

    def child(self, name: str) -> Record | None:
        return next((one for one in self.children if one.name == name), None)


def parse(data: bytes) -> Record:
    """Return the root of the tree of records."""
    assert data[:20] == b"Kaydara FBX Binary  "
    (version,) = struct.unpack_from("<I", data, 23)
    head = "<IIIB" if version < 7500 else "<QQQB"
    children: list[Record] = []
    at = 27
    while True:
        record, at = _record(data, at, head)
        if record is None:
            return Record("", [], children)
        children.append(record)


def _record(data: bytes, at: int, head: str) -> tuple[Record | None, int]:
    end, count, _, length = struct.unpack_from(head, data, at)
    at += struct.calcsize(head)
    if end == 0:
        return None, at
    name = data[at : at + length].decode("latin-1")
    at += length
    values: list[Any] = []
    for _ in range(count):
        value, at = _value(data, at)
        values.append(value)
    children: list[Record] = []
    while at < end:
        child, at = _record(data, at, head)
        if child is not None:
            children.append(child)
    return Record(name, values, children), end


def _value(data: bytes, at: int) -> tuple[Any, int]:
    kind = chr(data[at])
    at += 1
    single = {"Y": "<h", "C": "<?", "I": "<i", "F": "<f", "D": "<d", "L": "<q"}
    if kind in single:
        return struct.unpack_from(single[kind], data, at)[0], at + struct.calcsize(single[kind])
    if kind in "SR":
        (length,) = struct.unpack_from("<I", data, at)
        raw = data[at + 4 : at + 4 + length]
        return (raw.decode("latin-1") if kind == "S" else raw), at + 4 + length
    count, packed, length = struct.unpack_from("<III", data, at)
    raw = data[at + 12 : at + 12 + length]
    dtype = {"f": "<f4", "d": "<f8", "l": "<i8", "i": "<i4", "b": "?"}[kind]
    return np.frombuffer(zlib.decompress(raw) if packed else raw, dtype, count), at + 12 + length


class Curve:
    """The keys of one number, and the slopes with which it leaves one and comes to the next."""

    def __init__(self, record: Record) -> None:
        def array(name: str) -> Matrix:
            child = record.child(name)
            assert child is not None
            return np.asarray(child.values[0])

        self.times, self.values = array("KeyTime") / TICKS, array("KeyValueFloat")
        counts = array("KeyAttrRefCount").astype(np.int64)
        self.flags = np.repeat(array("KeyAttrFlags").astype(np.int64), counts)
        slopes = np.repeat(array("KeyAttrDataFloat").reshape(-1, 4)[:, :2], counts, axis=0)
        if len(self.times) > 1:
            # An automatic slope is the mean of those of the lines to the keys before and after.
            lines = np.diff(self.values) / np.diff(self.times)
            means = 0.5 * (np.append(lines[:1], lines) + np.append(lines, lines[-1:]))
            automatic = (self.flags & 0x100) > 0
            slopes[automatic, 0] = means[automatic]
            into = automatic[1:]
            slopes[:-1][into, 1] = means[1:][into]
        self.slopes = slopes

    def at(self, time: float) -> float:
        key = int(np.searchsorted(self.times, time + 1e-9, side="right")) - 1
        if key < 0 or key + 1 == len(self.times):
            return float(self.values[max(key, 0)])
        span = self.times[key + 1] - self.times[key]
        u = (time - self.times[key]) / span
        start, end = self.values[key], self.values[key + 1]
        if self.flags[key] & 2:
            return float(start)
        if self.flags[key] & 4:
            return float(start + u * (end - start))
        leave, arrive = self.slopes[key] * span
        return float(
            (1 + 2 * u) * (1 - u) ** 2 * start
            + u * u * (3 - 2 * u) * end
            + u * (1 - u) ** 2 * leave
            + u * u * (u - 1) * arrive
        )


class Scene:
    """The models of a file, and the curves that move them."""

    def __init__(self, data: bytes, take: str) -> None:
        root = parse(data)
        objects, connections = root.child("Objects"), root.child("Connections")
        assert objects is not None
        assert connections is not None
        settings = root.child("GlobalSettings")
        assert settings is not None
        facts = _properties(settings)
        self.metres = float(facts["UnitScaleFactor"][0]) / 100.0
        self.models = {one.values[0]: one for one in objects.children if one.name == "Model"}
        self.properties = {key: _properties(one) for key, one in self.models.items()}
        self.names = {key: one.values[1].split("\0")[0] for key, one in self.models.items()}
        self.parents: dict[int, int] = {}
        self.curves: dict[tuple[int, str, str], Curve] = {}
        self._connect(objects, [one.values for one in connections.children], take)

    def _connect(self, objects: Record, links: list[list[Any]], take: str) -> None:
        kinds = {one.values[0]: one for one in objects.children}
        layers = {
            link[1]
            for link in links
            if link[2] in kinds
            and kinds[link[2]].name == "AnimationStack"
            and kinds[link[2]].values[1].split("\0")[0] == take
        }
        mine = {link[1] for link in links if link[2] in layers}
        moved = {
            link[1]: (link[2], link[3]) for link in links if link[0] == "OP" and link[1] in mine
        }
        for link in links:
            if link[0] == "OO" and link[1] in self.models and link[2] in self.models:
                self.parents[link[1]] = link[2]
            elif link[0] == "OP" and link[2] in moved:
                model, what = moved[link[2]]
                axis = link[3].removeprefix("d|")
                self.curves[model, what, axis] = Curve(kinds[link[1]])

    def vector(self, model: int, name: str, time: float, rest: float = 0.0) -> Matrix:
        vector = np.array(self.properties[model].get(name, [rest] * 3)[:3], dtype=np.float64)
        for index, axis in enumerate("XYZ"):
            if (model, name, axis) in self.curves:
                vector[index] = self.curves[model, name, axis].at(time)
        return vector

    def local(self, model: int, time: float) -> Matrix:
        """Return the matrix from a model to its parent, in the file's unit."""

        def moved(name: str) -> Matrix:
            matrix = np.eye(4)
            matrix[:3, 3] = self.vector(model, name, time)
            return matrix

        def turned(name: str, order: str) -> Matrix:
            matrix = np.eye(4)
            for axis in order:
                angle = np.radians(self.vector(model, name, time)["XYZ".index(axis)])
                matrix = _turn(axis, angle) @ matrix
            return matrix

        order = ORDERS[int(self.properties[model].get("RotationOrder", [0])[0])]
        active = bool(self.properties[model].get("RotationActive", [0])[0])
        before = turned("PreRotation", "XYZ") if active else np.eye(4)
        after = turned("PostRotation", "XYZ") if active else np.eye(4)
        rotation = turned("Lcl Rotation", order if active else "XYZ")
        scale = np.diag([*self.vector(model, "Lcl Scaling", time, 1.0), 1.0])
        pivot, scaling = moved("RotationPivot"), moved("ScalingPivot")
        turn = pivot @ before @ rotation @ np.linalg.inv(after) @ np.linalg.inv(pivot)
        sized = moved("ScalingOffset") @ scaling @ scale @ np.linalg.inv(scaling)
        return moved("Lcl Translation") @ moved("RotationOffset") @ turn @ sized

    def world(self, model: int, time: float) -> Matrix:
        matrix = self.local(model, time)
        while (model := self.parents.get(model, 0)) in self.models:
            matrix = self.local(model, time) @ matrix
        return matrix

    def positions(self, name: str, times: Matrix) -> Matrix:
        """Return where the model of this name is [m], shape (times, 3)."""
        (model,) = (key for key, one in self.names.items() if one == name)
        return self.metres * np.array([self.world(model, float(t))[:3, 3] for t in times])


def _turn(axis: str, angle: float) -> Matrix:
    matrix = np.eye(4)
    one, other = {"X": (1, 2), "Y": (2, 0), "Z": (0, 1)}[axis]
    matrix[one, one] = matrix[other, other] = np.cos(angle)
    matrix[other, one] = np.sin(angle)
    matrix[one, other] = -np.sin(angle)
    return matrix


def _properties(record: Record) -> dict[str, list[Any]]:
    listed = record.child("Properties70")
    return {} if listed is None else {one.values[0]: one.values[4:] for one in listed.children}
