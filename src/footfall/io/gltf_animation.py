"""Animations of glTF files that are written: linear keys, one a frame [glTF 2.0, 3.11]."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from footfall.arrays import Floats
from footfall.io.gltf_buffers import BufferBuilder
from footfall.motion import Clip

__all__ = ["animation_record"]


def animation_record(
    clip: Clip,
    supports: str | None,
    tracks: Sequence[tuple[int, str, Floats]],
    buffers: BufferBuilder,
) -> dict[str, Any]:
    """Append the keys of an animation to a buffer, and return what the document says of it.

    Args:
        clip: The motion: its name, its rate, and whether it is cyclic.
        supports: What carries the body, one of ``R L D -`` a frame; None if that is not known.
        tracks: Node, ``"translation"`` or ``"rotation"``, and a value a frame; rotations wxyz
            and without changes of sign.
        buffers: Where the keys go.
    """
    times = buffers.add(np.arange(clip.frames) / clip.fps, "f4", bounds=True)
    samplers: list[dict[str, Any]] = []
    channels: list[dict[str, Any]] = []
    for node, path, values in tracks:
        stored = np.roll(values, -1, axis=-1) if path == "rotation" else values
        channels.append({"sampler": len(samplers), "target": {"node": node, "path": path}})
        samplers.append(
            {"input": times, "output": buffers.add(stored, "f4"), "interpolation": "LINEAR"}
        )
    facts: dict[str, Any] = {"fps": clip.fps, "cyclic": clip.cyclic}
    if supports is not None:
        facts["supports"] = supports
    return {
        "name": clip.name,
        "samplers": samplers,
        "channels": channels,
        "extras": {"footfall": facts},
    }
