"""DeepMimic's motions in and out: JSON with a duration, the root's place and turns a frame."""

from __future__ import annotations

import gzip
from decimal import Decimal
from pathlib import Path
from typing import Any, cast

import numpy as np

from footfall.arrays import Floats, Rotations, Seconds
from footfall.errors import FileFormatError
from footfall.geometry import from_axis_angle, slerp
from footfall.io.atomic import write_atomically
from footfall.io.bvh_clip import clip_from_rig
from footfall.io.bvh_rig import BvhRig
from footfall.io.conclusions import Conclusion, Conclusions
from footfall.io.deepmimic_body import HUMANOID, WIDTHS, DeepMimicBody, read_character
from footfall.io.frame_rate import USUAL_RATES, conclude_rate
from footfall.io.gltf_nodes import unit_rotations
from footfall.io.joint_order import named_like
from footfall.io.json_record import GREATEST, JsonRecord, parse_json
from footfall.io.key_rate import conclude_key_rate, frame_times
from footfall.io.raw_file import read_bytes
from footfall.io.stated import Stated
from footfall.io.units import parse_unit
from footfall.motion import Clip

__all__ = ["load_deepmimic", "read_deepmimic", "save_deepmimic"]

HINGE = np.radians(1.0)
"""A hinge may be turned about other axes by this much: rounding, and what nobody sees [rad]."""

STEADY = 1e-6
"""Durations that differ by less are one [s]: rounding in the files."""

CUT_SHORT = 1e-4
"""A rate is a usual one if it is within this share of it: files write 1/60 s as 0.016666."""

SAME_BONE = 0.001
"""A bone is the humanoid's if its end is within this of the humanoid's [m]."""


def load_deepmimic(path: Path | str, **known: Any) -> Clip:
    """Read a motion of DeepMimic; arguments and errors are those of `read_deepmimic`."""
    return read_deepmimic(path, **known)[0]


def read_deepmimic(
    path: Path | str,
    *,
    character: Path | str | None = None,
    unit: str | float | None = None,
    up: str | None = None,
    fps: float | None = None,
) -> tuple[Clip, Conclusions]:
    """Read a motion of DeepMimic, plain or gzip-packed, and conclude what it means.

    Args:
        path: The file.
        character: The file of the body; None: DeepMimic's own humanoid.
        unit: Its unit of length, where it is not the metre.
        up: Its upward axis, where it is not y.
        fps: Its frame rate, where the durations in it are wrong.

    Returns:
        The clip in metres, y up, joint 0 the pelvis; and everything that was concluded.

    Raises:
        FileFormatError: If a file breaks the rules of the format.
        ArgumentError: If `unit`, `up` or `fps` is impossible.
    """
    path = Path(path)
    root = parse_json(read_bytes(path), path)
    body = HUMANOID if character is None else read_character(Path(character))
    rows = _rows(root, body)
    rotations = _rotations(rows, body, root)
    keys = np.concatenate([[0.0], np.cumsum(rows[:-1, 0])])
    rate, times = _frames(keys, fps, root)
    places = np.stack([np.interp(times, keys, rows[:, axis]) for axis in (1, 2, 3)], axis=-1)
    before = np.clip(
        np.searchsorted(keys, times + 1e-6, side="right") - 1, 0, max(len(keys) - 2, 0)
    )
    after = np.minimum(before + 1, len(keys) - 1)
    part = (times - keys[before]) / np.where(after > before, keys[after] - keys[before], 1.0)
    rotations = slerp(rotations[before], rotations[after], np.clip(part, 0.0, 1.0)[:, np.newaxis])
    rig = BvhRig(
        body.names, body.parents, body.offsets, body.tips, rotations, {0: places}, len(places),
        Decimal(1) / Decimal(rate.value),
    )  # fmt: skip
    return clip_from_rig(
        rig, path, unit=unit, up=up, stated=_stated(root, rate, rows, len(times), character)
    )


def _frames(
    keys: Seconds, fps: float | None, root: JsonRecord
) -> tuple[Conclusion[float], Seconds]:
    """Return the rate, and when the frames are: as in the file, where all last equally long."""
    durations = np.diff(keys)
    if fps is not None:
        seconds = keys[-1] / len(durations) if len(durations) else 1.0 / 30.0
        return conclude_rate(Decimal(f"{seconds:.12g}"), fps), keys
    if len(durations) and np.ptp(durations) < STEADY:
        mean = len(durations) / float(keys[-1])
        usual = min(USUAL_RATES, key=lambda one: abs(one - mean))
        if abs(usual - mean) < CUT_SHORT * mean:
            reason = (
                f"{usual} frames per second: each lasts {1.0 / mean:.6g} s, which is 1/{usual} s"
            )
            return Conclusion(float(usual), reason), keys
        return Conclusion(mean, f"{mean:.9g} frames per second, as they last"), keys
    rate = conclude_key_rate(keys, None)
    times = frame_times(keys, rate.value, 16 * len(keys))
    if times is None:
        root.fail("Frames", "last between one moment and many times as long; pass fps=")
    return rate, times


def _stated(
    root: JsonRecord,
    rate: Conclusion[float],
    rows: Floats,
    frames: int,
    character: Path | str | None,
) -> Stated:
    once = root.text("Loop", "none") != "wrap"
    told = f"{frames}, as the file holds"
    if frames != len(rows):
        told = f"{frames}, in steps of one length: the {len(rows)} of the file last unequally long"
    whose = "DeepMimic's own humanoid" if character is None else f"that of {Path(character).name}"
    return Stated(
        Conclusion(parse_unit("m"), "m, as always in DeepMimic"),
        Conclusion("y", "y, as always in DeepMimic"),
        rate,
        Conclusion(frames, told),
        Conclusion(False, "not cyclic, as the file says") if once else None,
        notes=(f"body: {whose}",),
    )


def _rows(root: JsonRecord, body: DeepMimicBody) -> Floats:
    """Return the frames, shape (frames, numbers)."""
    frames: Any = root.content.get("Frames")
    if not isinstance(frames, list) or not frames:
        root.fail("Frames", "is missing; a motion needs at least one frame")
    rows = cast(list[Any], frames)
    for index, row in enumerate(rows):
        items: list[Any] = cast(list[Any], row) if isinstance(row, list) else []
        if len(items) != body.width:
            root.fail(f"Frames[{index}]", f"has {len(items)} numbers; the body needs {body.width}")
        for item in items:
            if type(item) not in (int, float) or not abs(item) < GREATEST:
                root.fail(f"Frames[{index}]", "holds what is no finite number below 1e12")
    table = np.array(rows, dtype=np.float64)
    wrong = np.flatnonzero(~((table[:-1, 0] >= 1e-6) & (table[:-1, 0] <= 1e6)))
    if wrong.size:
        seconds = table[wrong[0], 0]
        root.fail(f"Frames[{wrong[0]}]", f"lasts {seconds:g} s; it must last longer than zero")
    return table


def _rotations(rows: Floats, body: DeepMimicBody, root: JsonRecord) -> Rotations:
    """Return how the joints are turned in their parents, shape (frames, joints, 4)."""
    rotations = np.zeros((len(rows), len(body.names), 4))
    rotations[..., 0] = 1.0
    column = 4
    for joint, kind in enumerate(body.kinds):
        values = rows[:, column : column + WIDTHS[kind]]
        if kind == "revolute":
            rotations[:, joint] = from_axis_angle(np.array([0.0, 0.0, 1.0]), values[:, 0])
        elif kind == "spherical":
            rotations[:, joint] = unit_rotations(values, root, f"Frames (joint {joint})")
        column += WIDTHS[kind]
    return rotations


def save_deepmimic(clip: Clip, path: Path | str, *, character: Path | str | None = None) -> None:
    """Write a motion of DeepMimic, gzip-packed where the name ends in ``.gz``.

    The turn of a fixed joint, such as a wrist, has no place in the format.

    Args:
        clip: The motion, on the body that it is written for.
        path: The file.
        character: The file of that body; None: DeepMimic's own humanoid.

    Raises:
        FileFormatError: If the file cannot be written, the body is another one, or a hinge is
            turned about another axis than its own.
    """
    path = Path(path)
    body = HUMANOID if character is None else read_character(Path(character))
    order = _order(clip, body, path)
    columns = [np.full((clip.frames, 1), 1.0 / clip.fps), clip.pelvis_positions]
    # The last frame ends the motion: nothing follows for it to last until.
    columns[0][-1] = 0.0
    for joint, kind in enumerate(body.kinds):
        turns = clip.local_rotations[:, order[joint]]
        if kind == "spherical":
            columns.append(turns)
            continue
        if kind == "revolute":
            columns.append(_hinge_angles(turns, body.names[joint], path)[:, np.newaxis])
    rows = np.concatenate(columns, axis=1).tolist()
    lines = ",\n".join("[" + ", ".join(f"{value:.10f}" for value in row) + "]" for row in rows)
    loop = "wrap" if clip.cyclic else "none"
    data = f'{{\n"Loop": "{loop}",\n"Frames":\n[\n{lines}\n]\n}}\n'.encode()
    write_atomically(path, gzip.compress(data, mtime=0) if path.suffix == ".gz" else data)


def _hinge_angles(turns: Rotations, name: str, path: Path) -> Floats:
    """Return how far a hinge is turned about its z axis, without leaps, shape (frames,)."""
    stray = 2.0 * np.arcsin(np.clip(np.linalg.norm(turns[:, 1:3], axis=-1), 0.0, 1.0)).max()
    if stray > HINGE:
        raise FileFormatError(
            f"cannot be written: {name!r} is a hinge, and is turned by {np.degrees(stray):.1f} "
            "degrees about other axes than its own; retarget the motion onto a body with hinges",
            path=path,
        )
    return np.unwrap(2.0 * np.arctan2(turns[:, 3], turns[:, 0]))


def _order(clip: Clip, body: DeepMimicBody, path: Path) -> list[int]:
    """Return the joint of the clip for each joint of the body.

    Raises:
        FileFormatError: If the clip's body is another one.
    """
    names = clip.skeleton.names
    order = named_like(clip.skeleton, body.names, body.parents)
    if order is None:
        raise FileFormatError(
            f"cannot be written: DeepMimic's body has the joints {', '.join(body.names)}; this "
            f"one has {', '.join(names[:8])}, ...; retarget the motion onto it first",
            path=path,
        )
    away = np.linalg.norm(clip.skeleton.rest_offsets[order] - body.offsets, axis=-1)
    if away.max() > SAME_BONE:
        joint = int(away.argmax())
        raise FileFormatError(
            f"cannot be written: {body.names[joint]!r} is {away[joint] * 1000.0:.1f} mm from where "
            "DeepMimic's body has it; retarget the motion onto it first",
            path=path,
        )
    return order
