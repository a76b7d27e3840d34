"""Keys of glTF animations: read from the file, and evaluated at any times [glTF 2.0, 3.11]."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Indices, Seconds
from footfall.geometry import slerp
from footfall.io.gltf_accessors import floats
from footfall.io.gltf_document import GltfDocument
from footfall.io.gltf_nodes import unit_rotations
from footfall.io.json_record import JsonRecord

__all__ = ["Channel", "read_channels"]

_WIDTHS = {"translation": 3, "rotation": 4, "scale": 3}

JITTER = 1e-6
"""A key this little after a frame counts as on it [s]: times are stored in single precision."""


@dataclass(frozen=True, eq=False)
class Channel:
    """How one property of one node changes."""

    node: int
    """The node."""

    path: str
    """translation, rotation or scale."""

    times: Seconds
    """When its keys are, rising, shape (keys,)."""

    values: Floats
    """The keys, rotations wxyz, shape (keys, 3 or 4); with cubic splines the tangent before, the
    value and the tangent after, shape (keys, 3, 3 or 4)."""

    interpolation: str
    """LINEAR, STEP or CUBICSPLINE."""

    def at(self, times: Seconds) -> Floats:
        """Return the property at these times [s], held before its first and after its last key.

        Args:
            times: Shape (frames,).

        Returns:
            Shape (frames, 3 or 4); rotations are of unit length.
        """
        last = len(self.times) - 1
        before = np.clip(np.searchsorted(self.times, times + JITTER, side="right") - 1, 0, last)
        after = np.minimum(before + 1, last)
        span = self.times[after] - self.times[before]
        part = np.where(after > before, times - self.times[before], 0.0)
        fraction = np.clip(part / np.where(span > 0.0, span, 1.0), 0.0, 1.0)
        if self.interpolation == "CUBICSPLINE":
            return self._spline(before, after, fraction[:, np.newaxis], span[:, np.newaxis])
        if self.interpolation == "STEP":
            return self.values[before]
        one, other = self.values[before], self.values[after]
        if self.path == "rotation":
            return slerp(one, other, fraction)
        return one + fraction[:, np.newaxis] * (other - one)

    def _spline(self, before: Indices, after: Indices, u: Floats, span: Floats) -> Floats:
        """Return the Hermite splines through the keys [glTF 2.0, appendix C.4]."""
        one, other = self.values[before], self.values[after]
        result: Floats = (
            (2.0 * u**3 - 3.0 * u**2 + 1.0) * one[:, 1]
            + span * (u**3 - 2.0 * u**2 + u) * one[:, 2]
            + (3.0 * u**2 - 2.0 * u**3) * other[:, 1]
            + span * (u**3 - u**2) * other[:, 0]
        )
        if self.path != "rotation":
            return result
        lengths = np.linalg.norm(result, axis=-1, keepdims=True)
        # Tangents may lead a spline through zero, where it has no direction: the key holds.
        return np.where(lengths > 1e-9, result / np.maximum(lengths, 1e-9), one[:, 1])


def read_channels(document: GltfDocument, animation: JsonRecord) -> list[Channel]:
    """Return the channels of an animation that move nodes; those of morph weights are left out.

    Raises:
        FileFormatError: If a key is not finite, times do not rise, or counts disagree.
    """
    samplers = animation.records("samplers")
    node_count = len(document.root.records("nodes"))
    channels: list[Channel] = []
    seen: set[tuple[int, str]] = set()
    for record in animation.records("channels"):
        target = record.record("target")
        if target is None:
            record.fail("target", "is missing")
        path = target.text("path")
        if path not in _WIDTHS or not target.has("node"):
            continue
        node = target.integer("node", below=max(node_count, 1))
        if (node, path) in seen:
            target.fail("path", f"is {path} of node {node}, which another channel moves already")
        seen.add((node, path))
        number = record.integer("sampler")
        if number >= len(samplers):
            record.fail("sampler", f"is {number}, but there are {len(samplers)}")
        channels.append(_channel(document, samplers[number], node, path))
    return channels


def _channel(document: GltfDocument, sampler: JsonRecord, node: int, path: str) -> Channel:
    interpolation = sampler.text("interpolation", "LINEAR")
    if interpolation not in ("LINEAR", "STEP", "CUBICSPLINE"):
        sampler.fail("interpolation", f"is {interpolation[:20]!r}, which glTF does not know")
    times = floats(document, sampler.integer("input"), 1)[:, 0]
    if not (np.diff(times) > 0.0).all() or times[0] < 0.0:
        sampler.fail("input", "holds times that do not rise from zero or later")
    width = _WIDTHS[path]
    values = floats(document, sampler.integer("output"), width)
    spline = interpolation == "CUBICSPLINE"
    if len(values) != len(times) * (3 if spline else 1):
        sampler.fail("output", f"holds {len(values)} values for {len(times)} keys")
    if path == "rotation":
        values = np.roll(values, 1, axis=-1)
        if not spline:
            values = unit_rotations(values, sampler, "output")
    if spline:
        values = values.reshape(len(times), 3, width)
        if path == "rotation":
            values[:, 1] = unit_rotations(values[:, 1], sampler, "output")
    return Channel(node, path, times, values, interpolation)
