"""Motions from one form of file to another: `convert`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from footfall.cli.inputs import Known, about, read_motion
from footfall.cli.outputs import check_output, save_motion
from footfall.cli.performers import Performance, performed, read_performer, save_performance
from footfall.detection import detect_supports, frame_symbols
from footfall.io import readable_suffixes, writable_suffixes
from footfall.motion import Clip
from footfall.support import SupportSequence

__all__ = ["convert"]

READ = (
    f"A motion file ({', '.join(readable_suffixes())}), or sample:NAME. Of a glTF file with "
    "several animations, walk.glb#Walk_Loop chooses one."
)

WRITTEN = f"The file to write ({', '.join(writable_suffixes())})."


def convert(
    source: Annotated[str, Parameter(help=READ)],
    output: Annotated[Path, Parameter(help=WRITTEN)],
    /,
    *,
    body: str | None = None,
    known: Known | None = None,
) -> None:
    """Write a motion as another form of file; the suffixes say which.

    Supports that travel with the motion, in it or beside it, travel on.

    Parameters
    ----------
    body
        Play it on this body on the way: a motion file of that body, a .glb or .gltf file of a
        character, or sample:NAME. A character keeps its skin in a .glb file.
    """
    check_output(output)
    clip, supports = read_motion(source, known)
    if body is None:
        symbols = None if supports is None else frame_symbols(supports, clip.fps, clip.frames)
        save_motion(clip, output, supports, symbols)
    else:
        performance = _performed_by(body, source, clip, supports)
        clip = performance.clip
        save_performance(performance, output, supports)
    print(f"{output}: {clip.frames} frames, {clip.duration:.3f} s, {clip.fps:g} per second")
    for sentence in clip.provenance:
        print(f"  {sentence}")
    if supports is not None:
        print(f"  supports as they came with the motion: {supports}")


def _performed_by(
    body: str, source: str, clip: Clip, supports: SupportSequence | None
) -> Performance:
    """Return a motion as another body performs it, its supports detected where it has none."""
    performer = read_performer(body)
    with about(source):
        carried = detect_supports(clip) if supports is None else supports
    return performed(clip, carried, performer)
