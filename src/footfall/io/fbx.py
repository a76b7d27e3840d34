"""FBX files in: the skeleton and one take, baked to frames."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from footfall.extras import extra_module
from footfall.io.conclusions import Conclusions
from footfall.io.guarded_process import read_guarded
from footfall.io.raw_file import read_bytes
from footfall.io.rigid_frames import matrices_of
from footfall.io.scene_clip import clip_of_scene, refuse_axis_and_rate
from footfall.io.scene_nodes import SceneNodes
from footfall.motion import Clip

__all__ = ["read_fbx", "read_fbx_nodes"]

CHILD = Path(__file__).with_name("fbx_child.py")


def read_fbx(
    path: Path | str,
    *,
    unit: str | float | None = None,
    up: str | None = None,
    fps: float | None = None,
    take: str | None = None,
) -> tuple[Clip, Conclusions]:
    """Read an FBX file, plain or gzip-packed: its largest skeleton, and one take.

    The curves are evaluated at the file's own frame rate, pivots, pre-rotations and layers
    included. Bones get fixed lengths, and what that loses is told, as with BVH.

    Args:
        path: The file.
        unit: Its unit of length, if the file is known to be wrong about it.
        up: Not for this format.
        fps: Not for this format.
        take: The name of the take; the first one where not given.

    Returns:
        The clip in metres, y up, joint 0 the pelvis; and everything that was concluded.

    Raises:
        FileFormatError: If the file is damaged, holds no skeleton, or makes the parser crash.
        MissingExtraError: If ufbx is not installed.
        ArgumentError: If `unit` is impossible, or `up` or `fps` is given.
    """
    path = Path(path)
    refuse_axis_and_rate(path, up, fps)
    nodes, header = read_fbx_nodes(path, take)
    takes: list[str] = header["takes"]
    notes: tuple[str, ...] = ()
    if len(takes) > 1:
        others = ", ".join(repr(one) for one in takes if one != header["take"])
        notes = (f"take {header['take']!r} is read; the file also holds {others}",)
    metres = float(header["metres_per_unit"])
    return clip_of_scene(
        nodes, path, metres_per_unit=metres, up=str(header["up"]), unit=unit, notes=notes
    )


def read_fbx_nodes(path: Path, take: str | None = None) -> tuple[SceneNodes, dict[str, Any]]:
    """Read all nodes of an FBX file, in metres and with y up, and what it says of itself.

    Raises:
        FileFormatError: If the file is damaged or makes the parser crash.
        MissingExtraError: If ufbx is not installed.
    """
    extra_module("ufbx", f"reading {path.name}", extra="fbx")
    data = read_bytes(path)
    words = [] if take is None else [take]
    header, arrays = read_guarded(CHILD, words, data, path, size=len(data))
    matrices = matrices_of(arrays["rotations"], arrays["translations"], arrays["scales"])
    names = tuple(str(name) for name in header["names"])
    fps = float(header["fps"])
    return SceneNodes(names, arrays["parents"], arrays["joints"], matrices, fps), header
