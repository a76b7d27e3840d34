"""The text of a BVH file: a clip in the form that every tool reads."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from footfall.errors import FileFormatError
from footfall.geometry import to_euler
from footfall.io.frame_rate import frame_time_text
from footfall.io.units import Unit
from footfall.motion import Clip

__all__ = ["bvh_text"]

ORDER = "ZXY"
"""Order of the rotation channels: the middle one, which must not reach a right angle, is the
pitch, and bodies rarely point their bones straight up or down by it."""

_ROTATIONS = " ".join(f"{axis}rotation" for axis in ORDER)


def bvh_text(clip: Clip, unit: Unit, path: Path) -> str:
    """Return a clip as BVH: joint 0 with positions and rotations, all others with rotations.

    Args:
        clip: The clip.
        unit: The unit of length to write.
        path: The file it is for, for messages.

    Raises:
        FileFormatError: If a joint's name cannot stand in a BVH file.
    """
    for name in clip.skeleton.names:
        if not name or name != " ".join(name.split()) or "{" in name or "}" in name:
            raise FileFormatError(
                f"joint name {name!r} cannot stand in a BVH file; it must not be empty, hold "
                "braces, or begin or end with a blank",
                path=path,
            )
    scale = 1.0 / unit.metres
    joints = clip.skeleton.count
    degrees = np.degrees(to_euler(ORDER, clip.local_rotations)).reshape(clip.frames, 3 * joints)
    table = np.concatenate([clip.pelvis_positions * scale, degrees], axis=1)
    row = " ".join(["%.12g"] * 3 + ["%.10f"] * (3 * joints))
    values = "\n".join(row % tuple(frame) for frame in table.tolist())
    header = f"MOTION\nFrames: {clip.frames}\nFrame Time: {frame_time_text(clip.fps)}\n"
    return f"HIERARCHY\n{_hierarchy(clip, scale)}{header}{values}\n"


def _hierarchy(clip: Clip, scale: float) -> str:
    """Return the joints, each inside its parent."""
    skeleton = clip.skeleton
    lines: list[str] = []
    open_joints: list[int] = []
    for joint, name in enumerate(skeleton.names):
        while open_joints and open_joints[-1] != skeleton.parents[joint]:
            open_joints.pop()
            lines.append("\t" * len(open_joints) + "}")
        indent = "\t" * len(open_joints)
        channels = f"CHANNELS 3 {_ROTATIONS}"
        if joint == 0:
            channels = f"CHANNELS 6 Xposition Yposition Zposition {_ROTATIONS}"
        lines += [
            f"{indent}{'JOINT' if joint else 'ROOT'} {name}",
            f"{indent}{{",
            f"{indent}\t{_offset(skeleton.rest_offsets[joint], scale)}",
            f"{indent}\t{channels}",
        ]
        tip = skeleton.tip_offsets[joint]
        if tip.any() or not skeleton.children(joint):
            lines += [
                f"{indent}\tEnd Site",
                f"{indent}\t{{",
                f"{indent}\t\t{_offset(tip, scale)}",
                f"{indent}\t}}",
            ]
        open_joints.append(joint)
    while open_joints:
        open_joints.pop()
        lines.append("\t" * len(open_joints) + "}")
    return "\n".join(lines) + "\n"


def _offset(offset: np.ndarray, scale: float) -> str:
    x, y, z = (float(value) * scale for value in offset)
    return f"OFFSET {x:.12g} {y:.12g} {z:.12g}"
