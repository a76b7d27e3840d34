"""glTF files in: an animation and the body that it moves."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from footfall.arrays import Seconds
from footfall.errors import FileFormatError, UnknownNameError
from footfall.io.bvh_clip import clip_from_rig
from footfall.io.conclusions import Conclusion, Conclusions
from footfall.io.gltf_document import GltfDocument, read_document
from footfall.io.gltf_joints import GltfJoints, find_joints
from footfall.io.gltf_keys import Channel, read_channels
from footfall.io.gltf_nodes import GltfNodes, read_nodes
from footfall.io.gltf_rig import rig_at
from footfall.io.json_record import JsonRecord
from footfall.io.key_rate import conclude_key_rate, frame_times
from footfall.io.stated import Stated
from footfall.io.units import parse_unit
from footfall.motion import Clip

__all__ = ["GltfBody", "gltf_animations", "gltf_body", "load_gltf", "read_gltf"]

JOINT_FRAMES = 150_000
"""So many joints times frames are read from a file of any size, and one more for every 16 bytes:
a few bytes can ask for keys a million years apart."""


@dataclass(frozen=True, eq=False)
class GltfBody:
    """A glTF file and which of its nodes are joints."""

    document: GltfDocument
    """The file."""

    nodes: GltfNodes
    """Its nodes."""

    joints: GltfJoints
    """Those that move the body."""

    animations: tuple[str, ...]
    """What its animations are called, all different."""

    def channels(self, animation: int) -> list[Channel]:
        """Return how an animation moves the nodes."""
        return read_channels(self.document, self.document.item("animations", animation))


def gltf_animations(path: Path | str) -> tuple[str, ...]:
    """Return the names of the animations of a .glb or .gltf file, in its order.

    Raises:
        FileFormatError: If the file breaks the rules of glTF.
    """
    return _names(read_document(Path(path)))


def load_gltf(path: Path | str, **known: Any) -> Clip:
    """Read an animation of a glTF file; arguments and errors are those of `read_gltf`."""
    return read_gltf(path, **known)[0]


def read_gltf(
    path: Path | str,
    *,
    animation: str | int | None = None,
    unit: str | float | None = None,
    up: str | None = None,
    fps: float | None = None,
) -> tuple[Clip, Conclusions]:
    """Read an animation of a .glb or .gltf file, and conclude what it means.

    Keys become frames at a steady rate. A file without animations gives one frame, the pose in
    which it stands.

    Args:
        path: The file.
        animation: Its name, or its number from 0; may be left out where there is one at most.
        unit: The unit of length, where the file breaks glTF's rule that it is the metre.
        up: The upward axis, ``"y"`` or ``"z"``, where the file breaks the rule that it is y.
        fps: The rate at which to sample the keys.

    Returns:
        The clip in metres, y up, joint 0 the pelvis; and everything that was concluded.

    Raises:
        FileFormatError: If the file breaks the rules of glTF, has several animations of which
            none was named, or its joints cannot be said by bones and rotations.
        UnknownNameError: If it has no animation of this name or number.
        ArgumentError: If `unit`, `up` or `fps` is impossible.
    """
    body = gltf_body(read_document(Path(path)))
    number = _chosen(body, animation)
    channels = [] if number is None else body.channels(number)
    keys = _keys(body, channels)
    rate = conclude_key_rate(keys, fps if number is not None or fps is None else None)
    facts = _own_facts(body.document, number)
    if fps is None and isinstance(own := facts.get("fps"), int | float) and 0.1 < own < 1e4:
        rate = Conclusion(float(own), f"{own:.9g} frames per second, as the file says")
    count = len(body.joints.nodes)
    limit = (JOINT_FRAMES + body.document.size // 16) // count
    times = frame_times(keys, rate.value, limit)
    if times is None:
        raise FileFormatError(
            f"its keys span {keys[-1] - keys[0]:.6g} s, which at {rate.value:g} frames per second "
            f"and {count} joints is more than so small a file is believed to mean; pass a "
            "smaller fps=",
            path=body.document.path,
        )
    rig = rig_at(body.document, body.nodes, body.joints, channels, times, rate.value)
    stated = Stated(
        Conclusion(parse_unit("m"), "m, as always in glTF") if unit is None else None,
        Conclusion("y", "y, as always in glTF") if up is None else None,
        rate,
        _conclude_frames(body, number, len(times)),
        _conclude_loop(facts),
        None if number is None else body.animations[number],
    )
    return clip_from_rig(rig, body.document.path, unit=unit, up=up, stated=stated)


def gltf_body(document: GltfDocument) -> GltfBody:
    """Find the joints of a glTF file.

    Raises:
        FileFormatError: If there are none, or the file breaks the rules of glTF.
    """
    nodes = read_nodes(document)
    animated: set[int] = set()
    for animation in document.root.records("animations"):
        for channel in animation.records("channels"):
            target = channel.record("target")
            if target is not None and target.has("node") and target.text("path") != "weights":
                animated.add(target.integer("node", below=max(nodes.count, 1)))
    return GltfBody(document, nodes, find_joints(document, nodes, animated), _names(document))


def _names(document: GltfDocument) -> tuple[str, ...]:
    names: list[str] = []
    for index, record in enumerate(document.root.records("animations")):
        name = " ".join(record.text("name", "").split()) or f"animation {index}"
        names.append(name if name not in names else f"{name}_{index}")
    return tuple(names)


def _chosen(body: GltfBody, animation: str | int | None) -> int | None:
    """Return the number of the animation that is meant; None where there is none at all."""
    names = body.animations
    if animation is None:
        if len(names) > 1:
            raise FileFormatError(
                f"holds {len(names)} animations; choose one by its name, such as "
                f"{body.document.path.name}#{names[0]}, or its number: {', '.join(names)}",
                path=body.document.path,
            )
        return 0 if names else None
    if animation in names:
        return names.index(str(animation))
    digits = str(animation)
    if digits.isascii() and digits.isdigit() and len(digits) < 6 and int(digits) < len(names):
        return int(digits)
    raise UnknownNameError(f"animation in {body.document.path}", digits, names)


def _keys(body: GltfBody, channels: list[Channel]) -> Seconds:
    """Return when the joints have keys, in order."""
    moved = [c.times for c in channels if body.joints.index(c.node) is not None]
    if not moved:
        return np.zeros(1)
    keys = np.unique(np.concatenate(moved))
    # Two channels may say the same time in two roundings.
    return keys[np.concatenate([[True], np.diff(keys) > 2e-5])]


def _own_facts(document: GltfDocument, number: int | None) -> dict[str, Any]:
    """Return what this project wrote beside an animation."""
    record: JsonRecord | None = None if number is None else document.item("animations", number)
    for name in ("extras", "footfall"):
        content = None if record is None else record.content.get(name)
        record = JsonRecord(content, name, document.path) if isinstance(content, dict) else None  # pyright: ignore[reportUnknownArgumentType]
    return {} if record is None else record.content


def _conclude_loop(facts: dict[str, Any]) -> Conclusion[bool] | None:
    cyclic = facts.get("cyclic")
    if not isinstance(cyclic, bool):
        return None
    return Conclusion(cyclic, f"{'cyclic' if cyclic else 'not cyclic'}, as the file says")


def _conclude_frames(body: GltfBody, number: int | None, frames: int) -> Conclusion[int]:
    if number is None:
        return Conclusion(1, "1, the pose of the file: it holds no animation")
    name = body.animations[number]
    others = len(body.animations) - 1
    more = f"; the file holds {others} more animations" if others else ""
    return Conclusion(frames, f"{frames}, sampled from animation {name!r}{more}")
