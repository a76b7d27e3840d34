"""What reads and writes motions, by the suffix of their files.

A new form of file is one entry of a table here.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from footfall.errors import ArgumentError
from footfall.io.amass import is_amass, read_amass, save_amass
from footfall.io.bvh import read_bvh, save_bvh
from footfall.io.clip_choice import split_choice
from footfall.io.conclusions import Conclusions
from footfall.io.deepmimic import read_deepmimic, save_deepmimic
from footfall.io.fbx import read_fbx
from footfall.io.gltf import save_gltf
from footfall.io.gltf_clip import read_gltf
from footfall.io.native import load_native, save_native
from footfall.io.stored_conclusions import conclude_stored
from footfall.io.usd import read_usd
from footfall.io.usd_writer import save_usd
from footfall.motion import Clip

__all__ = ["BODY_READERS", "READERS", "WRITERS"]

Reader = Callable[[Path, str | float | None, str | None, float | None], tuple[Clip, Conclusions]]
Writer = Callable[[Clip, Path], None]


def _read_bvh(
    path: Path, unit: str | float | None, up: str | None, fps: float | None
) -> tuple[Clip, Conclusions]:
    return read_bvh(path, unit=unit, up=up, fps=fps)


def _read_gltf(
    path: Path, unit: str | float | None, up: str | None, fps: float | None
) -> tuple[Clip, Conclusions]:
    file, animation = split_choice(path)
    return read_gltf(file, animation=animation, unit=unit, up=up, fps=fps)


def _read_deepmimic(
    path: Path,
    unit: str | float | None,
    up: str | None,
    fps: float | None,
    body: Path | None = None,
) -> tuple[Clip, Conclusions]:
    return read_deepmimic(path, character=body, unit=unit, up=up, fps=fps)


def _read_npz(
    path: Path,
    unit: str | float | None,
    up: str | None,
    fps: float | None,
    body: Path | None = None,
) -> tuple[Clip, Conclusions]:
    if is_amass(path):
        return read_amass(path, model=body, unit=unit, up=up, fps=fps)
    if body is not None:
        raise ArgumentError(f"{path} knows its body; body= is for motions of AMASS and DeepMimic")
    if not (unit is None and up is None and fps is None):
        raise ArgumentError(
            f"{path} knows its unit, upward axis and rate; unit=, up= and fps= are for other files"
        )
    clip = load_native(path)
    return clip, conclude_stored(clip)


def _read_fbx(
    path: Path, unit: str | float | None, up: str | None, fps: float | None
) -> tuple[Clip, Conclusions]:
    file, take = split_choice(path)
    return read_fbx(file, take=take, unit=unit, up=up, fps=fps)


def _read_usd(
    path: Path, unit: str | float | None, up: str | None, fps: float | None
) -> tuple[Clip, Conclusions]:
    return read_usd(path, unit=unit, up=up, fps=fps)


READERS: dict[str, Reader] = {
    ".bvh": _read_bvh,
    ".bvh.gz": _read_bvh,
    ".fbx": _read_fbx,
    ".fbx.gz": _read_fbx,
    ".glb": _read_gltf,
    ".gltf": _read_gltf,
    ".npz": _read_npz,
    ".txt": _read_deepmimic,
    ".txt.gz": _read_deepmimic,
    ".usd": _read_usd,
    ".usda": _read_usd,
    ".usdc": _read_usd,
    ".usdz": _read_usd,
}
"""What reads a file, by its suffix in lower case."""

BODY_READERS = {".npz": _read_npz, ".txt": _read_deepmimic, ".txt.gz": _read_deepmimic}
"""What reads a file whose body may be in another file, by its suffix."""

WRITERS: dict[str, Writer] = {
    ".amass.npz": save_amass,
    ".bvh": save_bvh,
    ".bvh.gz": save_bvh,
    ".glb": save_gltf,
    ".npz": save_native,
    ".txt": save_deepmimic,
    ".txt.gz": save_deepmimic,
    ".usd": save_usd,
    ".usda": save_usd,
    ".usdc": save_usd,
}
"""What writes a file, by its suffix in lower case."""
