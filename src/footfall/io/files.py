"""Any file in and out: its suffix says how.

A new form of file is one entry of a table here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from footfall.errors import ArgumentError, FileFormatError
from footfall.io.amass import is_amass, read_amass, save_amass
from footfall.io.annotation import read_annotation, write_annotation
from footfall.io.bvh import read_bvh, save_bvh
from footfall.io.clip_choice import CHOOSING, split_choice
from footfall.io.conclusions import Conclusions
from footfall.io.deepmimic import read_deepmimic, save_deepmimic
from footfall.io.gltf import save_gltf
from footfall.io.gltf_clip import read_gltf
from footfall.io.native import load_native, load_native_supports, save_native
from footfall.io.stored_conclusions import conclude_stored
from footfall.motion import Clip
from footfall.support import SupportSequence

__all__ = [
    "load",
    "load_supports",
    "load_with_conclusions",
    "readable_suffixes",
    "save",
    "save_supports",
    "writable_suffixes",
]

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


READERS: dict[str, Reader] = {
    ".bvh": _read_bvh,
    ".bvh.gz": _read_bvh,
    ".glb": _read_gltf,
    ".gltf": _read_gltf,
    ".npz": _read_npz,
    ".txt": _read_deepmimic,
    ".txt.gz": _read_deepmimic,
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
}
"""What writes a file, by its suffix in lower case."""


def load(
    path: Path | str,
    *,
    animation: str | int | None = None,
    body: Path | str | None = None,
    unit: str | float | None = None,
    up: str | None = None,
    fps: float | None = None,
) -> Clip:
    """Read a motion file: always a clip in metres, y up, whatever the file is.

    What was concluded is in the clip's provenance in short; `load_with_conclusions` returns it
    whole.

    Args:
        path: The file; its suffix says what it is. Of a glTF file with several animations,
            ``walk.glb#Walk_Loop`` names one.
        animation: The same, by its name or its number from 0.
        body: The file that holds the body's joints, where the motion's own file does not: a SMPL
            model for AMASS, a character for DeepMimic.
        unit: Its unit of length, if known: m, foot, dm, cmu, inch, cm, mm, or metres.
        up: Its upward axis, if known: ``"y"`` or ``"z"``.
        fps: Its frame rate, if known better than the file knows it.

    Raises:
        FileFormatError: If the file is missing, of an unknown suffix, or breaks the rules of its
            format, or if its unit or upward axis can be neither found nor was given.
        UnknownNameError: If there is no such animation in it.
        ArgumentError: If `animation`, `body`, `unit`, `up` or `fps` is impossible, or not for this
            file.
    """
    return load_with_conclusions(path, animation=animation, body=body, unit=unit, up=up, fps=fps)[0]


def load_with_conclusions(
    path: Path | str,
    *,
    animation: str | int | None = None,
    body: Path | str | None = None,
    unit: str | float | None = None,
    up: str | None = None,
    fps: float | None = None,
) -> tuple[Clip, Conclusions]:
    """Read a motion file, and say everything that was concluded about it, with reasons.

    Arguments and errors are those of `load`.
    """
    path = Path(path)
    suffix = _suffix(split_choice(path)[0], READERS, "read as a motion")
    if animation is not None:
        if suffix not in CHOOSING:
            raise ArgumentError(f"{path} holds one motion; animation= is for {', '.join(CHOOSING)}")
        path = Path(f"{path}#{animation}")
    if body is None:
        return READERS[suffix](path, unit, up, fps)
    if suffix not in BODY_READERS:
        raise ArgumentError(f"{path} knows its body; body= is for motions of AMASS and DeepMimic")
    return BODY_READERS[suffix](path, unit, up, fps, Path(body))


def readable_suffixes() -> tuple[str, ...]:
    """Return the suffixes of the files that a motion can be read from."""
    return tuple(sorted(READERS))


def writable_suffixes() -> tuple[str, ...]:
    """Return the suffixes of the files that a motion can be written to."""
    return tuple(sorted(WRITERS))


def save(clip: Clip, path: Path | str) -> None:
    """Write a clip; the suffix says as what.

    Raises:
        FileFormatError: If the suffix is unknown, or the file cannot be written.
    """
    path = Path(path)
    WRITERS[_suffix(path, WRITERS, "written")](clip, path)


def load_supports(path: Path | str) -> SupportSequence:
    """Read the supports of a motion: a ``.supports`` file, or those in a ``.npz``.

    Raises:
        FileFormatError: If there are none, or the file breaks the rules of its format.
    """
    path = Path(path)
    suffix = _suffix(path, (".supports", ".npz"), "read as supports")
    if suffix == ".supports":
        return read_annotation(path)
    supports = load_native_supports(path)
    if supports is None:
        raise FileFormatError("holds a motion without supports; detect them", path=path)
    return supports


def save_supports(sequence: SupportSequence, path: Path | str) -> None:
    """Write supports as text, to be edited by hand.

    Raises:
        FileFormatError: If the suffix is not ``.supports``, or the file cannot be written.
    """
    path = Path(path)
    _suffix(path, (".supports",), "written as supports")
    write_annotation(sequence, path)


def _suffix(path: Path, known: Iterable[str], what: str) -> str:
    """Return the longest known suffix of a file's name."""
    name = path.name.lower()
    for suffix in sorted(known, key=len, reverse=True):
        if name.endswith(suffix):
            return suffix
    raise FileFormatError(
        f"cannot be {what}: its suffix is none of {', '.join(sorted(known))}", path=path
    )
