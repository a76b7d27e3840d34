"""USD files in: the largest skeleton (UsdSkel) and its animation."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from footfall.arrays import Flags, Floats
from footfall.extras import extra_module
from footfall.io.conclusions import Conclusions
from footfall.io.guarded_process import read_guarded
from footfall.io.raw_file import read_bytes
from footfall.io.scene_clip import clip_of_scene, refuse_axis_and_rate
from footfall.io.scene_nodes import SceneNodes
from footfall.motion import Clip

__all__ = ["read_usd", "read_usd_nodes"]

CHILD = Path(__file__).with_name("usd_child.py")

TO_Y_UP = np.array(
    [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, -1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
)
"""Takes z to y, and y to -z."""


def read_usd(
    path: Path | str,
    *,
    unit: str | float | None = None,
    up: str | None = None,
    fps: float | None = None,
) -> tuple[Clip, Conclusions]:
    """Read a .usd, .usda, .usdc or .usdz file: its largest skeleton and what animates it.

    Args:
        path: The file. What it references is read with it.
        unit: Its unit of length, if the file is known to be wrong about it.
        up: Not for this format.
        fps: Not for this format.

    Returns:
        The clip in metres, y up, joint 0 the pelvis; and everything that was concluded.

    Raises:
        FileFormatError: If the file is damaged, holds no skeleton, or makes the library crash.
        MissingExtraError: If usd-core is not installed.
        ArgumentError: If `unit` is impossible, or `up` or `fps` is given.
    """
    path = Path(path)
    refuse_axis_and_rate(path, up, fps)
    nodes, header = read_usd_nodes(path)
    return clip_of_scene(
        nodes,
        path,
        metres_per_unit=float(header["metres_per_unit"]),
        up=str(header["up"]),
        unit=unit,
    )


def read_usd_nodes(path: Path) -> tuple[SceneNodes, dict[str, Any]]:
    """Read all skeletons of a USD file, in metres and with y up, and what it says of itself.

    Raises:
        FileFormatError: If the file is damaged or makes the library crash.
        MissingExtraError: If usd-core is not installed.
    """
    extra_module("pxr", f"reading {path.name}", extra="usd", library="usd-core")
    size = len(read_bytes(path))
    words = [str(path.resolve())]
    header, arrays = read_guarded(CHILD, words, b"", path, size=size)
    names = tuple(str(name) for name in header["names"])
    matrices = _in_metres(arrays["matrices"], arrays["parents"] < 0, header)
    return SceneNodes(
        names, arrays["parents"], arrays["joints"], matrices, float(header["fps"])
    ), header


def _in_metres(matrices: Floats, tops: Flags, header: dict[str, Any]) -> Floats:
    """Return the matrices with places in metres, and those to the world with y up."""
    matrices = matrices.copy()
    # What is not finite is told where it matters: in a joint of the body.
    with np.errstate(invalid="ignore", over="ignore"):
        matrices[..., :3, 3] *= float(header["metres_per_unit"])
        if header["up"] == "z":
            matrices[:, tops] = TO_Y_UP @ matrices[:, tops]
    return matrices
