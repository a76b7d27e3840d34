"""What a BVH file holds, joint by joint: turned and placed, still in its own unit and axes."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path

import numpy as np

from footfall.arrays import Floats, Indices, Positions, Rotations
from footfall.errors import FileFormatError
from footfall.geometry import from_euler
from footfall.io.bvh_hierarchy import BvhJoint, HierarchyReader
from footfall.io.bvh_motion import BvhMotion, parse_motion
from footfall.io.raw_file import decoded

__all__ = ["BvhRig", "parse_bvh"]


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
    text = decoded(data).replace("\r\n", "\n").replace("\r", "\n")
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
    rotations = np.zeros((len(motion.values), len(joints), 4))
    rotations[..., 0] = 1.0
    translations: dict[int, Positions] = {}
    turning: dict[str, list[tuple[int, list[int]]]] = {}
    column = 0
    for index, joint in enumerate(joints):
        order, columns = "", list[int]()
        for channel in joint.channels or ():
            if channel.endswith("rotation"):
                order += channel[0]
                columns.append(column)
            else:
                place = translations.setdefault(
                    index, np.tile(offsets[index], (len(motion.values), 1))
                )
                place[:, "XYZ".index(channel[0])] = motion.values[:, column]
            column += 1
        if order:
            turning.setdefault(order, []).append((index, columns))
    for order, members in turning.items():
        _turn(rotations, motion.values, order, members)
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


def _turn(
    rotations: Rotations, values: Floats, order: str, members: list[tuple[int, list[int]]]
) -> None:
    """Write the rotations of the joints that share an order of channels."""
    for index, columns in members:
        rotations[:, index] = from_euler(order, np.radians(values[:, columns]))
