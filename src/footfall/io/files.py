"""Any file in and out: its suffix says how."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from footfall.errors import ArgumentError, FileFormatError
from footfall.io.clip_choice import CHOOSING, split_choice
from footfall.io.conclusions import Conclusions
from footfall.io.motion_formats import BODY_READERS, READERS, WRITERS
from footfall.io.support_formats import SUPPORT_READERS, SUPPORT_WRITERS
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
    """Read the supports of a motion: a ``.supports`` file, a table, or those in a ``.npz``.

    A table is a ``.csv`` or a ``.parquet`` file with one row a phase or one row a frame; see
    `footfall.io.label_table`.

    Raises:
        FileFormatError: If there are none, or the file breaks the rules of its format.
        MissingExtraError: If the library for a table is not installed.
    """
    path = Path(path)
    return SUPPORT_READERS[_suffix(path, SUPPORT_READERS, "read as supports")](path)


def save_supports(sequence: SupportSequence, path: Path | str) -> None:
    """Write supports: ``.supports`` is text to be edited by hand, ``.csv`` and ``.parquet`` tables.

    Raises:
        FileFormatError: If the suffix is none of these, or the file cannot be written.
        MissingExtraError: If the library for a table is not installed.
    """
    path = Path(path)
    SUPPORT_WRITERS[_suffix(path, SUPPORT_WRITERS, "written as supports")](sequence, path)


def _suffix(path: Path, known: Iterable[str], what: str) -> str:
    """Return the longest known suffix of a file's name."""
    name = path.name.lower()
    for suffix in sorted(known, key=len, reverse=True):
        if name.endswith(suffix):
            return suffix
    raise FileFormatError(
        f"cannot be {what}: its suffix is none of {', '.join(sorted(known))}", path=path
    )
