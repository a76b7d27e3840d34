"""One layer of a motion library: a clip as the difference to a pose, on parts of the upper body."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from footfall.arrays import Floats, Rotations, SmallFloats, frozen
from footfall.compilation import records
from footfall.engine.entry import entry_type
from footfall.engine.layer_record import LayerShelf
from footfall.engine.priorities import PART_NAMES
from footfall.errors import ArgumentError, UnknownNameError
from footfall.geometry import conjugate, continuous, multiply
from footfall.motion import Clip
from footfall.skeleton import Anatomy, BodyPart
from footfall.skeleton.normalized import by_component, channel_count

__all__ = ["UPPER_BODY", "Layer", "layer_shelf_of", "pack_turns", "parse_parts"]

UPPER_BODY = ("trunk", "head", "arms")
"""The body parts that a layer may turn."""


@dataclass(frozen=True, eq=False)
class Layer:
    """A motion that can be laid over others."""

    name: str
    """What commands call it."""

    clip: Clip
    """The motion."""

    parts: Floats
    """1 for each body part that it turns, else 0, shape (parts,)."""

    fade_in: float
    """How long a start takes to become complete [s]."""

    fade_out: float
    """How long a stop takes to become complete [s]."""

    keys: SmallFloats
    """By how much each joint is turned, as rotations of normalized poses, (frames, channels)."""

    @property
    def lasts(self) -> bool:
        """Whether it lies until it is stopped: a cycle, or a single pose."""
        return self.clip.cyclic or self.clip.frames == 1


def parse_parts(label: str, parts: Sequence[str]) -> Floats:
    """Return 1 for each body part that is named, else 0, shape (parts,).

    Args:
        label: What messages call the layer.
        parts: Names such as those of `UPPER_BODY`, or left_arm and right_arm.

    Raises:
        ArgumentError: If none is named, or the legs are.
        UnknownNameError: If there is no such part.
    """
    named = [parts] if isinstance(parts, str) else list(parts)
    values = np.zeros(len(BodyPart))
    for part in named:
        if part not in PART_NAMES:
            raise UnknownNameError("body part", part, PART_NAMES)
        values[list(PART_NAMES[part])] = 1.0
    if values[BodyPart.LEGS] or not values.any():
        problem = "is to turn the legs" if values.any() else "turns no body part"
        raise ArgumentError(
            f"{label} {problem}; a layer moves no foot: its parts are some of "
            "trunk, head, arms, left_arm and right_arm"
        )
    return frozen(values)


def pack_turns(clip: Clip, reference: Clip, anatomy: Anatomy, parts: Floats) -> SmallFloats:
    """Return by how much each joint of some body parts is turned from a reference pose.

    Args:
        clip: The motion.
        reference: Of the same family; its first frame is the pose.
        anatomy: What its joints are.
        parts: 1 for each body part that may be turned, else 0, shape (parts,).

    Returns:
        Rotations in the frames of the joints' parents, as those of normalized poses; the feet,
        which come last, are not turned. Shape (frames, channels).
    """
    turns = np.zeros((clip.frames, clip.skeleton.count, 4))
    turns[..., 0] = 1.0
    moved = np.flatnonzero(parts[np.asarray(anatomy.parts, dtype=np.int64)] > 0.0)
    turns[:, moved] = _turns(clip.local_rotations[:, moved], reference.local_rotations[0, moved])
    keys = np.zeros((clip.frames, channel_count(clip.skeleton.count)), dtype=np.float32)
    keys[:, : turns[0].size] = turns.reshape(clip.frames, -1)
    keys[:, turns[0].size : turns[0].size + 8 : 4] = 1.0
    return keys


def _turns(rotations: Rotations, reference: Rotations) -> Rotations:
    """Return the turns from a pose, each on the way of the one before, the first by the short way.

    So a joint that is turned on past half a turn does not leap where it is turned by a part of it.
    """
    turns = multiply(rotations, conjugate(reference))
    turns[0] = np.where(turns[0, :, :1] < 0.0, -turns[0], turns[0])
    return continuous(turns)


def layer_shelf_of(layers: Sequence[Layer], joints: int) -> LayerShelf:
    """Return layers as the kernels take them, for bodies of so many joints."""
    entries: Any = records(np.zeros(len(layers), dtype=entry_type))
    frame = 0
    for entry, layer in zip(entries, layers, strict=True):
        entry["first_frame"], entry["frame_count"] = frame, layer.clip.frames
        entry["fps"], entry["duration"] = layer.clip.fps, layer.clip.duration
        entry["cyclic"] = layer.lasts
        entry["fade_in"], entry["fade_out"] = layer.fade_in, layer.fade_out
        frame += layer.clip.frames
    nothing = np.zeros((0, channel_count(joints)), dtype=np.float32)
    keys = np.concatenate([nothing, *(layer.keys for layer in layers)])
    return LayerShelf(by_component(keys, joints), entries)
