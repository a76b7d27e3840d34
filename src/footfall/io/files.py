"""Any file in and out: its suffix says how.

A new form of file is one entry of a table here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from footfall.errors import ArgumentError, FileFormatError
from footfall.io.annotation import read_annotation, write_annotation
from footfall.io.bvh import read_bvh, save_bvh
from footfall.io.conclusions import Conclusions
from footfall.io.fbx import read_fbx
from footfall.io.gltf import save_gltf
from footfall.io.label_table import phase_columns, supports_of
from footfall.io.native import load_native, load_native_supports, save_native
from footfall.io.stored_conclusions import conclude_stored
from footfall.io.table_files import read_csv, read_parquet, write_csv, write_parquet
from footfall.io.usd import read_usd
from footfall.io.usd_writer import save_usd
from footfall.motion import Clip
from footfall.support import SupportSequence

__all__ = [
    "load",
    "load_supports",
    "load_with_conclusions",
    "save",
    "save_supports",
]

Reader = Callable[[Path, str | float | None, str | None, float | None], tuple[Clip, Conclusions]]
Writer = Callable[[Clip, Path], None]


def _read_bvh(
    path: Path, unit: str | float | None, up: str | None, fps: float | None
) -> tuple[Clip, Conclusions]:
    return read_bvh(path, unit=unit, up=up, fps=fps)


def _read_native(
    path: Path, unit: str | float | None, up: str | None, fps: float | None
) -> tuple[Clip, Conclusions]:
    if not (unit is None and up is None and fps is None):
        raise ArgumentError(
            f"{path} knows its unit, upward axis and rate; unit=, up= and fps= are for other files"
        )
    clip = load_native(path)
    return clip, conclude_stored(clip)


def _read_fbx(
    path: Path, unit: str | float | None, up: str | None, fps: float | None
) -> tuple[Clip, Conclusions]:
    return read_fbx(path, unit=unit, up=up, fps=fps)


def _read_usd(
    path: Path, unit: str | float | None, up: str | None, fps: float | None
) -> tuple[Clip, Conclusions]:
    return read_usd(path, unit=unit, up=up, fps=fps)


READERS: dict[str, Reader] = {
    ".bvh": _read_bvh,
    ".bvh.gz": _read_bvh,
    ".fbx": _read_fbx,
    ".fbx.gz": _read_fbx,
    ".npz": _read_native,
    ".usd": _read_usd,
    ".usda": _read_usd,
    ".usdc": _read_usd,
    ".usdz": _read_usd,
}
"""What reads a file, by its suffix in lower case."""

WRITERS: dict[str, Writer] = {
    ".bvh": save_bvh,
    ".bvh.gz": save_bvh,
    ".glb": save_gltf,
    ".npz": save_native,
    ".usd": save_usd,
    ".usda": save_usd,
    ".usdc": save_usd,
}
"""What writes a file, by its suffix in lower case."""


def load(
    path: Path | str,
    *,
    unit: str | float | None = None,
    up: str | None = None,
    fps: float | None = None,
) -> Clip:
    """Read a motion file: always a clip in metres, y up, whatever the file is.

    What was concluded is in the clip's provenance in short; `load_with_conclusions` returns it
    whole.

    Args:
        path: The file; its suffix says what it is.
        unit: Its unit of length, if known: m, foot, dm, cmu, inch, cm, mm, or metres.
        up: Its upward axis, if known: ``"y"`` or ``"z"``.
        fps: Its frame rate, if known better than the file knows it.

    Raises:
        FileFormatError: If the file is missing, of an unknown suffix, or breaks the rules of its
            format, or if its unit or upward axis can be neither found nor was given.
        ArgumentError: If `unit`, `up` or `fps` is impossible, or not for this file.
    """
    return load_with_conclusions(path, unit=unit, up=up, fps=fps)[0]


def load_with_conclusions(
    path: Path | str,
    *,
    unit: str | float | None = None,
    up: str | None = None,
    fps: float | None = None,
) -> tuple[Clip, Conclusions]:
    """Read a motion file, and say everything that was concluded about it, with reasons.

    Arguments and errors are those of `load`.
    """
    path = Path(path)
    reader = READERS[_suffix(path, READERS, "read as a motion")]
    return reader(path, unit, up, fps)


def save(clip: Clip, path: Path | str) -> None:
    """Write a clip; the suffix says as what.

    Raises:
        FileFormatError: If the suffix is unknown, or the file cannot be written.
    """
    path = Path(path)
    WRITERS[_suffix(path, WRITERS, "written")](clip, path)


def load_supports(path: Path | str) -> SupportSequence:
    """Read the supports of a motion: a ``.supports`` file, a table, or those in a ``.npz``.

    A table is a ``.csv`` or a ``.parquet`` file with one row a phase or one row a frame; see
    `footfall.io.label_table`.

    Raises:
        FileFormatError: If there are none, or the file breaks the rules of its format.
        MissingExtraError: If the library for a table is not installed.
    """
    path = Path(path)
    return SUPPORT_READERS[_suffix(path, SUPPORT_READERS, "read as supports")](path)


def _read_npz_supports(path: Path) -> SupportSequence:
    supports = load_native_supports(path)
    if supports is None:
        raise FileFormatError("holds a motion without supports; detect them", path=path)
    return supports


def save_supports(sequence: SupportSequence, path: Path | str) -> None:
    """Write supports: ``.supports`` is text to be edited by hand, ``.csv`` and ``.parquet`` tables.

    Raises:
        FileFormatError: If the suffix is none of these, or the file cannot be written.
        MissingExtraError: If the library for a table is not installed.
    """
    path = Path(path)
    SUPPORT_WRITERS[_suffix(path, SUPPORT_WRITERS, "written as supports")](sequence, path)


SUPPORT_READERS: dict[str, Callable[[Path], SupportSequence]] = {
    ".csv": lambda path: supports_of(read_csv(path), path),
    ".npz": _read_npz_supports,
    ".parquet": lambda path: supports_of(read_parquet(path), path),
    ".supports": read_annotation,
}
"""What reads supports, by the file's suffix in lower case."""

SUPPORT_WRITERS: dict[str, Callable[[SupportSequence, Path], None]] = {
    ".csv": lambda sequence, path: write_csv(phase_columns(sequence), path),
    ".parquet": lambda sequence, path: write_parquet(phase_columns(sequence), path),
    ".supports": write_annotation,
}
"""What writes supports, by the file's suffix in lower case."""


def _suffix(path: Path, known: Iterable[str], what: str) -> str:
    """Return the longest known suffix of a file's name."""
    name = path.name.lower()
    for suffix in sorted(known, key=len, reverse=True):
        if name.endswith(suffix):
            return suffix
    raise FileFormatError(
        f"cannot be {what}: its suffix is none of {', '.join(sorted(known))}", path=path
    )
