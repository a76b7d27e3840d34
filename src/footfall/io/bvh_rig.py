"""What a BVH file holds, joint by joint: turned and placed, still in its own unit and axes."""

from __future__ import annotations

import math
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path

import numpy as np

from footfall.arrays import Floats, Indices, Positions, Rotations
from footfall.compilation import kernel
from footfall.errors import FileFormatError
from footfall.geometry import quaternions
from footfall.io.bvh_hierarchy import BvhJoint, HierarchyReader
from footfall.io.bvh_motion import BvhMotion, parse_motion
from footfall.io.raw_file import decoded

__all__ = ["BvhRig", "parse_bvh", "turn_joints"]


@dataclass(frozen=True, slots=True)
class BvhRig:
    """All that a BVH file says, with nothing concluded from it."""

    names: tuple[str, ...]
    """The joints, as declared."""

    parents: Indices
    """Index of each joint's parent; -1 for the root. Shape (joints,)."""

    offsets: Positions
    """OFFSET of each joint, in the file's unit, shape (joints, 3)."""

    tips: Positions
    """OFFSET of its End Site, zero where there is none, shape (joints, 3)."""

    rotations: Rotations
    """Joints relative to their parents, shape (frames, joints, 4)."""

    translations: dict[int, Positions]
    """Joints that have position channels, and where they sit in their parent's frame, shape
    (frames, 3) each. They stand in place of OFFSET; an axis without a channel keeps it."""

    declared_frames: int
    """What ``Frames:`` says."""

    frame_time: Decimal
    """What ``Frame Time:`` says [s]."""

    @property
    def frames(self) -> int:
        """How many frames there are."""
        return len(self.rotations)


def parse_bvh(data: bytes, path: Path) -> BvhRig:
    """Read the bytes of a BVH file.

    Args:
        data: The content.
        path: The file, for messages.

    Raises:
        FileFormatError: If anything in it is not as BVH wants it.
    """
    text = decoded(data)
    if "\r" in text:
        text = text.replace("\r\n", "\n").replace("\r", "\n")
    lines = text.split("\n")
    while lines and not lines[-1].strip():
        lines.pop()
    reader = HierarchyReader(path)
    after = reader.read(lines)
    channels = sum(len(joint.channels or ()) for joint in reader.joints)
    if channels == 0:
        raise FileFormatError(
            "no joint has CHANNELS, so that nothing can move; the root needs six",
            path=path,
            line=after,
        )
    motion = parse_motion(lines, after, channels, path)
    return _assembled(reader.joints, motion)


def _assembled(joints: list[BvhJoint], motion: BvhMotion) -> BvhRig:
    offsets = np.array([joint.offset for joint in joints], dtype=np.float64)
    rotations = np.empty((len(motion.values), len(joints), 4))
    translations: dict[int, Positions] = {}
    turning: list[tuple[int, int, int]] = []
    column = 0
    for index, joint in enumerate(joints):
        for channel in joint.channels or ():
            axis = "XYZ".index(channel[0])
            if channel.endswith("rotation"):
                turning.append((index, axis, column))
            else:
                place = translations.setdefault(
                    index, np.tile(offsets[index], (len(motion.values), 1))
                )
                place[:, axis] = motion.values[:, column]
            column += 1
    turns = np.array(turning, dtype=np.int64).reshape(-1, 3)
    turn_joints(motion.values, turns, rotations)
    return BvhRig(
        tuple(joint.name for joint in joints),
        np.array([joint.parent for joint in joints], dtype=np.int64),
        offsets,
        np.array([joint.tip or (0.0, 0.0, 0.0) for joint in joints], dtype=np.float64),
        rotations,
        translations,
        motion.declared_frames,
        motion.frame_time,
    )


@kernel
def turn_joints(values: Floats, turns: Indices, rotations: Rotations) -> None:
    """Turn the joints as their rotation channels say, the first channel last.

    Args:
        values: The frames, shape (frames, channels); angles in degrees.
        turns: Joint, axis (0 to 2) and column of each rotation channel, in the order of the
            file, shape (rotation channels, 3).
        rotations: Written: the joints relative to their parents, shape (frames, joints, 4).
    """
    rotations[:] = 0.0
    rotations[:, :, 0] = 1.0
    for frame in range(values.shape[0]):
        for joint, axis, column in turns:
            half = 0.5 * math.radians(values[frame, column])
            w, x, y, z = rotations[frame, joint]
            sine = math.sin(half)
            w, x, y, z = quaternions.product(
                w,
                x,
                y,
                z,
                math.cos(half),
                sine if axis == 0 else 0.0,
                sine if axis == 1 else 0.0,
                sine if axis == 2 else 0.0,
            )
            rotations[frame, joint, 0] = w
            rotations[frame, joint, 1] = x
            rotations[frame, joint, 2] = y
            rotations[frame, joint, 3] = z
