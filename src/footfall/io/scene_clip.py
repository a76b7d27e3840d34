"""From the skeleton of a scene file to a clip: such a file says its unit, axis and rate itself."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from footfall.errors import ArgumentError, FileFormatError
from footfall.io.bvh_clip import clip_from_rig
from footfall.io.conclusions import Conclusion, Conclusions
from footfall.io.scene_nodes import SceneNodes, rig_of_scene
from footfall.io.units import UNITS, Unit, parse_unit
from footfall.motion import Clip

__all__ = ["clip_of_scene", "refuse_axis_and_rate"]


def refuse_axis_and_rate(path: Path, up: str | None, fps: float | None) -> None:
    """Refuse to be told what the file knows.

    Raises:
        ArgumentError: If `up` or `fps` is given.
    """
    if not (up is None and fps is None):
        raise ArgumentError(
            f"{path} knows its upward axis and rate; up= and fps= are for other files"
        )


def clip_of_scene(
    nodes: SceneNodes,
    path: Path,
    *,
    metres_per_unit: float,
    up: str,
    unit: str | float | None = None,
    notes: tuple[str, ...] = (),
) -> tuple[Clip, Conclusions]:
    """Conclude what a scene means.

    Args:
        nodes: The scene, in metres and with y up by what the file says of itself.
        path: The file, for messages and the clip's name.
        metres_per_unit: What the file says its unit is [m].
        up: What the file says its upward axis is, ``"y"`` or ``"z"``.
        unit: Its true unit, if the file is known to be wrong.
        notes: What else to remember of the reading.

    Returns:
        The clip and what was concluded.

    Raises:
        FileFormatError: If the scene holds no usable skeleton.
        ArgumentError: If `unit` is impossible.
    """
    declared = _named(metres_per_unit, path)
    used = declared if unit is None else parse_unit(unit)
    rig, others = rig_of_scene(nodes, path)
    clip, found = clip_from_rig(rig, path, unit=used.metres / metres_per_unit, up="y")
    reason = (
        f"{declared.name} ({declared.metres:.6g} m), as the file says"
        if unit is None
        else f"{used.name}, as asked for; the file says {declared.name}"
    )
    found = replace(
        found,
        unit=Conclusion(used, reason),
        up=Conclusion(up, f"{up}, as the file says"),
        fps=Conclusion(clip.fps, f"{clip.fps:.9g} frames per second, as the file says"),
    )
    first = (
        f"read from {path.name}: unit {used.name}, {up} up, {clip.fps:g} frames per second, "
        f"pelvis {found.root.value!r}"
    )
    lines = (first, *notes, *([others] if others else []), *clip.provenance[1:])
    return clip.evolve(name=_name(path), provenance=lines), found


def _named(metres: float, path: Path) -> Unit:
    for unit in UNITS:
        if abs(unit.metres - metres) < 1e-6 * metres:
            return unit
    try:
        return parse_unit(metres)
    except ArgumentError as error:
        raise FileFormatError(f"says of itself: {error}", path=path) from error


def _name(path: Path) -> str:
    name = path.name
    for suffix in (".gz", ".fbx", ".usda", ".usdc", ".usdz", ".usd"):
        if name.lower().endswith(suffix):
            name = name[: -len(suffix)]
    return name or "clip"
