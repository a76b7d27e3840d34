"""BVH files in and out."""

from __future__ import annotations

import gzip
from pathlib import Path

from footfall.io.atomic import write_atomically
from footfall.io.bvh_clip import clip_from_rig
from footfall.io.bvh_rig import parse_bvh
from footfall.io.bvh_text import bvh_text
from footfall.io.conclusions import Conclusions
from footfall.io.raw_file import read_bytes
from footfall.io.units import parse_unit
from footfall.motion import Clip

__all__ = ["load_bvh", "read_bvh", "save_bvh"]


def load_bvh(
    path: Path | str,
    *,
    unit: str | float | None = None,
    up: str | None = None,
    fps: float | None = None,
) -> Clip:
    """Read a BVH file; arguments and errors are those of `read_bvh`."""
    return read_bvh(path, unit=unit, up=up, fps=fps)[0]


def read_bvh(
    path: Path | str,
    *,
    unit: str | float | None = None,
    up: str | None = None,
    fps: float | None = None,
) -> tuple[Clip, Conclusions]:
    """Read a BVH file, plain or gzip-packed, and conclude what it means.

    Position channels stand in place of a joint's OFFSET; rotation channels turn in the order of
    the file, the first one last; a joint without channels keeps its place and turn.

    Args:
        path: The file.
        unit: Its unit of length, if known: m, foot, dm, cmu, inch, cm, mm, or metres.
        up: Its upward axis, if known: ``"y"`` or ``"z"``.
        fps: Its frame rate, if known better than the file knows it.

    Returns:
        The clip in metres, y up, joint 0 the pelvis; and everything that was concluded.

    Raises:
        FileFormatError: If the file breaks the rules of BVH, or its unit or upward axis can be
            neither found nor was given.
        ArgumentError: If `unit`, `up` or `fps` is impossible.
    """
    path = Path(path)
    rig = parse_bvh(read_bytes(path), path)
    return clip_from_rig(rig, path, unit=unit, up=up, fps=fps)


def save_bvh(clip: Clip, path: Path | str, *, unit: str | float = "m") -> None:
    """Write a clip as BVH, gzip-packed where the name ends in ``.gz``.

    Reading it again gives the clip within 1e-6 m and 1e-6 rad, and the same frame rate. That it
    is cyclic, its name and its provenance have no place in BVH.

    Args:
        clip: The clip.
        path: The file.
        unit: The unit of length to write: m, foot, dm, cmu, inch, cm, mm, or metres.

    Raises:
        FileFormatError: If the file cannot be written, or a joint's name cannot stand in it.
        ArgumentError: If `unit` is unknown.
    """
    path = Path(path)
    data = bvh_text(clip, parse_unit(unit), path).encode()
    if path.suffix.lower() == ".gz":
        data = gzip.compress(data, mtime=0)
    write_atomically(path, data)
