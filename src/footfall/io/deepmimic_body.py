"""The humanoid that DeepMimic's motions are made for, and other characters of its format.

A motion file holds turns only; joints, their kinds and their places are in a character file.
The humanoid's own numbers stand here, so that a motion can be read by itself: Peng et al. 2018,
"DeepMimic", data/characters/humanoid3d.txt (MIT license). It faces +x, its left is -z.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from footfall.arrays import Indices, Positions
from footfall.io.json_record import JsonRecord, parse_json
from footfall.io.raw_file import read_bytes

__all__ = ["HUMANOID", "DeepMimicBody", "read_character"]

WIDTHS = {"spherical": 4, "revolute": 1, "fixed": 0}
"""How many numbers of a frame turn a joint of each kind."""


@dataclass(frozen=True, eq=False)
class DeepMimicBody:
    """The joints in the order of a frame."""

    names: tuple[str, ...]
    """What they are called; the first one is the root."""

    kinds: tuple[str, ...]
    """A key of `WIDTHS` each; the root is spherical. A revolute joint turns about its z axis."""

    parents: Indices
    """Parent of each; -1 for the root. Shape (joints,)."""

    offsets: Positions
    """Where each stands in its parent [m], shape (joints, 3)."""

    tips: Positions
    """Where a foot ends in its ankle [m], shape (joints, 3); zero for others."""

    @property
    def width(self) -> int:
        """How many numbers a frame has: its duration, the root's place, and the turns."""
        return 4 + sum(WIDTHS[kind] for kind in self.kinds)


def _humanoid() -> DeepMimicBody:
    trunk = [
        ("root", "spherical", -1, (0.0, 0.0, 0.0)),
        ("chest", "spherical", 0, (0.0, 0.236151, 0.0)),
        ("neck", "spherical", 1, (0.0, 0.223894, 0.0)),
    ]
    for side, z, first in (("right", 1.0, 3), ("left", -1.0, 9)):
        trunk += [
            (f"{side}_hip", "spherical", 0, (0.0, 0.0, 0.084887 * z)),
            (f"{side}_knee", "revolute", first, (0.0, -0.421546, 0.0)),
            (f"{side}_ankle", "spherical", first + 1, (0.0, -0.40987, 0.0)),
            (f"{side}_shoulder", "spherical", 1, (-0.02405, 0.2435, 0.18311 * z)),
            (f"{side}_elbow", "revolute", first + 3, (0.0, -0.274788, 0.0)),
            (f"{side}_wrist", "fixed", first + 4, (0.0, -0.258947, 0.0)),
        ]
    tips = np.zeros((len(trunk), 3))
    # The lower front edge of the box that is the foot.
    tips[[5, 11]] = (0.045 + 0.177 / 2.0, -0.0225 - 0.055 / 2.0, 0.0)
    return DeepMimicBody(
        tuple(name for name, _, _, _ in trunk),
        tuple(kind for _, kind, _, _ in trunk),
        np.array([parent for _, _, parent, _ in trunk], dtype=np.int64),
        np.array([offset for _, _, _, offset in trunk]),
        tips,
    )


HUMANOID = _humanoid()
"""The body of ``humanoid3d_*.txt``."""


def read_character(path: Path) -> DeepMimicBody:
    """Read a character file of DeepMimic, plain or gzip-packed.

    Raises:
        FileFormatError: If a joint is of a kind that is not known, stands before its parent, or is
            turned where it is attached.
    """
    root = parse_json(read_bytes(path), path)
    skeleton = root.record("Skeleton")
    records = [] if skeleton is None else skeleton.records("Joints")
    if not records:
        root.fail("Skeleton.Joints", "is missing; a character needs joints")
    kinds: list[str] = []
    parents: list[int] = []
    for index, record in enumerate(records):
        kind = record.text("Type") if index else "spherical"
        if kind not in WIDTHS:
            record.fail("Type", f"is {kind[:20]!r}; it must be one of {', '.join(WIDTHS)}")
        if any(record.number(f"AttachTheta{axis}", 0.0) != 0.0 for axis in "XYZ"):
            record.fail("AttachTheta", "turns the joint where it is attached, which is not read")
        kinds.append(kind)
        # A parent stands before its child, so that the limit is the joint's own index.
        parents.append(record.integer("Parent", least=0, below=index) if index else -1)
    return DeepMimicBody(
        tuple(record.text("Name") for record in records),
        tuple(kinds),
        np.array(parents, dtype=np.int64),
        np.array([[record.number(f"Attach{axis}", 0.0) for axis in "XYZ"] for record in records]),
        _foot_tips(root, len(records), parents),
    )


def _foot_tips(root: JsonRecord, count: int, parents: list[int]) -> Positions:
    """Return the lower front edges of boxes that end a limb."""
    tips = np.zeros((count, 3))
    for index, body in enumerate(root.records("BodyDefs")[:count]):
        if body.text("Shape", "") == "box" and index not in parents:
            length, height = body.number("Param0", 0.0), body.number("Param1", 0.0)
            x, y, z = (body.number(f"Attach{axis}", 0.0) for axis in "XYZ")
            tips[index] = (x + 0.5 * length, y - 0.5 * height, z)
    return tips
