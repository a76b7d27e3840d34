"""From what a file says, joint by joint, to a clip: each conclusion in turn, with its reason."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from footfall.arrays import Positions
from footfall.errors import ArgumentError, ClipError, FileFormatError, SkeletonError
from footfall.io.bvh_rig import BvhRig
from footfall.io.conclusions import Conclusion, Conclusions
from footfall.io.fixed_bones import fix_bones
from footfall.io.frame_rate import conclude_rate
from footfall.io.observations import (
    conclude_cyclic,
    conclude_feet,
    conclude_first_frame,
    conclude_floor,
    legs_or_reason,
)
from footfall.io.root_layout import depth_first, fold_root, rest_skeleton
from footfall.io.stated import Stated
from footfall.io.units import UNITS, Unit, parse_unit, unit_of_leg
from footfall.io.up_axis import conclude_up, turned_up
from footfall.motion import Clip
from footfall.skeleton import Anatomy, Skeleton, leg_length, world_poses

__all__ = ["clip_from_rig"]

WORTH_TELLING = 0.001
"""Bones that stray further than this are named in the clip's provenance [m]."""


def clip_from_rig(
    rig: BvhRig,
    path: Path,
    *,
    unit: str | float | None = None,
    up: str | None = None,
    fps: float | None = None,
    stated: Stated | None = None,
) -> tuple[Clip, Conclusions]:
    """Conclude what a file means.

    Args:
        rig: What it says.
        path: Its name, for messages and the clip's name.
        unit: Its unit, if known: a name of `footfall.io.units.UNITS`, or metres.
        up: Its upward axis, if known: ``"y"`` or ``"z"``.
        fps: Its frame rate, if known.
        stated: What its form says already; `unit` and `up` override it, `fps` does not.

    Returns:
        The clip and what was concluded.

    Raises:
        FileFormatError: If something can be neither found nor was given.
        ArgumentError: If `unit`, `up` or `fps` is impossible.
    """
    stated = stated or Stated()
    if unit is not None:
        stated = replace(stated, unit=_asked_unit(unit))
    if up not in (None, "y", "z"):
        raise ArgumentError(f"up={up!r} is unknown; use 'y' or 'z'")
    if up is not None:
        stated = replace(stated, up=Conclusion(up, f"{up}, as asked for"))
    if stated.fps is None:
        stated = replace(stated, fps=conclude_rate(rig.frame_time, fps))
    try:
        rig = depth_first(rig)
        found = legs_or_reason(rest_skeleton(rig))
        folded, root = fold_root(rig, None if isinstance(found, str) else found)
        anatomy = found if folded is rig else legs_or_reason(rest_skeleton(folded))
        if isinstance(anatomy, str):
            _ask_without_legs(stated, path)
        fixed, bones = fix_bones(folded, None if isinstance(anatomy, str) else anatomy, path)
        return _assembled(fixed, anatomy, path, stated, (root, bones))
    except (SkeletonError, ClipError) as error:
        raise FileFormatError(str(error), path=path) from error


def _asked_unit(unit: str | float) -> Conclusion[Unit]:
    found = parse_unit(unit)
    return Conclusion(found, f"{found.name}, as asked for")


def _ask_without_legs(stated: Stated, path: Path) -> None:
    """Complain that the unit and the upward axis are neither known nor to be found."""
    missing: list[str] = []
    if stated.unit is None:
        missing.append(f"unit= ({', '.join(known.name for known in UNITS)}, or a number of metres)")
    if stated.up is None:
        missing.append("up= ('y' or 'z')")
    if missing:
        raise FileFormatError(
            "no two legs are found, from which unit and upward axis are concluded; pass "
            + " and ".join(missing),
            path=path,
        )


def _assembled(
    rig: BvhRig,
    anatomy: Anatomy | str,
    path: Path,
    stated: Stated,
    concluded: tuple[Conclusion[str], Conclusion[float]],
) -> tuple[Clip, Conclusions]:
    root, bones = concluded
    raw = rest_skeleton(rig)
    unit_found = _conclude_unit(raw, anatomy, stated.unit, path)
    metres = unit_found.value.metres
    places = metres * rig.translations.get(0, np.zeros((rig.frames, 3)))
    body = Skeleton(raw.names, raw.parents, metres * raw.rest_offsets, metres * raw.tip_offsets)
    up_found = stated.up or _conclude_up(body, anatomy, places, rig, path)
    skeleton, places, rotations = turned_up(body, places, rig.rotations, up_found.value)
    world_rotations, positions = world_poses(skeleton, places, rotations)
    anatomy = _found_anew(anatomy, skeleton)
    conclusions = Conclusions(
        unit=unit_found,
        up=up_found,
        root=root,
        bones=_in_metres(bones, metres),
        frames=stated.frames or _conclude_frames(rig),
        fps=stated.fps or conclude_rate(rig.frame_time, None),
        feet=conclude_feet(skeleton, anatomy),
        first_frame=conclude_first_frame(positions),
        floor=conclude_floor(anatomy, world_rotations, positions),
        cyclic=stated.cyclic or conclude_cyclic(positions),
    )
    clip = Clip(
        skeleton,
        places,
        rotations,
        conclusions.fps.value,
        cyclic=conclusions.cyclic.value,
        name=stated.name or _clip_name(path),
        provenance=(*_provenance(path, conclusions, rig), *stated.notes),
    )
    return clip, conclusions


def _conclude_up(
    body: Skeleton, anatomy: Anatomy | str, places: Positions, rig: BvhRig, path: Path
) -> Conclusion[str]:
    assert not isinstance(anatomy, str)
    return conclude_up(body, anatomy, places, rig.rotations, path)


def _found_anew(anatomy: Anatomy | str, skeleton: Skeleton) -> Anatomy | str:
    """Find the legs again: foot points are lengths, now in metres and with y up."""
    return anatomy if isinstance(anatomy, str) else legs_or_reason(skeleton)


def _conclude_unit(
    raw: Skeleton, anatomy: Anatomy | str, known: Conclusion[Unit] | None, path: Path
) -> Conclusion[Unit]:
    lengths = [] if isinstance(anatomy, str) else [leg_length(raw, leg) for leg in anatomy.legs]
    mean = sum(lengths) / max(len(lengths), 1)
    if known is not None:
        unit = known.value
        legs = f"; the legs are then {mean * unit.metres:.3f} m long" if lengths else ""
        return Conclusion(unit, f"{known.reason}{legs}")
    found = unit_of_leg(mean)
    if found is None:
        readings = ", ".join(f"{mean * known.metres:.3g} m in {known.name}" for known in UNITS)
        raise FileFormatError(
            f"the legs are {mean:.6g} long, which is a person's in no unit ({readings}); "
            "pass unit=",
            path=path,
        )
    return Conclusion(
        found,
        f"{found.name} ({found.metres:.6g} m): the legs are then {mean * found.metres:.3f} m long, "
        "and in any other unit no person's",
    )


def _in_metres(bones: Conclusion[float], metres: float) -> Conclusion[float]:
    if bones.value == 0.0:
        return bones
    stray = bones.value * metres
    return Conclusion(stray, f"{bones.reason}, by {stray * 1000.0:.1f} mm")


def _conclude_frames(rig: BvhRig) -> Conclusion[int]:
    if rig.frames == rig.declared_frames:
        return Conclusion(rig.frames, f"{rig.frames}, as the file declares")
    return Conclusion(
        rig.frames,
        f"{rig.frames}, though the file declares {rig.declared_frames}: one whole frame more "
        "follows, and is read",
    )


def _provenance(path: Path, conclusions: Conclusions, rig: BvhRig) -> tuple[str, ...]:
    """Return what to remember of the reading, the doubtful things in full."""
    lines = [
        f"read from {path.name}: unit {conclusions.unit.value.name}, {conclusions.up.value} up, "
        f"{conclusions.fps.value:g} frames per second, pelvis {conclusions.root.value!r}"
    ]
    if "IMPLAUSIBLE" in conclusions.fps.reason:
        lines.append(conclusions.fps.reason)
    if rig.frames != rig.declared_frames:
        lines.append(f"frames: {conclusions.frames.reason}")
    if conclusions.bones.value > WORTH_TELLING:
        lines.append(f"bones: {conclusions.bones.reason}")
    if conclusions.first_frame.value:
        lines.append(f"first frame: {conclusions.first_frame.reason}")
    return tuple(lines)


def _clip_name(path: Path) -> str:
    """Return a file's name without its folder and its suffixes."""
    name = path.name
    for suffix in (".gz", ".bvh", ".npz", ".glb", ".gltf", ".txt"):
        if name.lower().endswith(suffix):
            name = name[: -len(suffix)]
    return name or "clip"
