"""Motions from one form of file to another: `convert`."""

from __future__ import annotations

from pathlib import Path

from footfall.cli.inputs import Known, read_motion
from footfall.cli.outputs import check_output, save_motion
from footfall.detection import frame_symbols

__all__ = ["convert"]


def convert(source: str, output: Path, /, *, known: Known | None = None) -> None:
    """Write a motion as another form of file; the suffixes say which.

    Supports that travel with the motion, in it or beside it, travel on.

    Parameters
    ----------
    source
        A motion file, such as .bvh, .glb, .npz or .txt, or sample:NAME. Of a glTF file with
        several animations, walk.glb#Walk_Loop chooses one.
    output
        The file to write, such as .bvh, .bvh.gz, .glb, .npz, .amass.npz or .txt.
    """
    check_output(output)
    clip, supports = read_motion(source, known)
    symbols = None if supports is None else frame_symbols(supports, clip.fps, clip.frames)
    save_motion(clip, output, supports, symbols)
    print(f"{output}: {clip.frames} frames, {clip.duration:.3f} s, {clip.fps:g} per second")
    for sentence in clip.provenance:
        print(f"  {sentence}")
    if supports is not None:
        print(f"  supports as they came with the motion: {supports}")
