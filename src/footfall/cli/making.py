"""Make a motion out of another: `edit` and `clean`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from footfall.cli.inputs import Known, about, origin_of, read_motion
from footfall.cli.outputs import check_output, save_motion
from footfall.detection import clean_and_tell, detect_supports
from footfall.detection import travel as travel_clip
from footfall.errors import ArgumentError
from footfall.motion import Clip
from footfall.motion.cycle_closing import cut_cycle
from footfall.motion.editing import crop as crop_clip
from footfall.motion.editing import resample as resample_clip
from footfall.motion.mirroring import mirror as mirror_clip
from footfall.report import Spread, clip_trace, measure
from footfall.skeleton import find_anatomy

__all__ = ["clean", "edit"]


def edit(
    source: str,
    output: Path,
    /,
    *,
    crop: str | None = None,
    mirror: bool = False,
    resample: float | None = None,
    cycle: bool = False,
    travel: bool = False,
    known: Known | None = None,
) -> None:
    """Edit a motion: taken along, then cropped, mirrored, cut to a cycle, and last resampled.

    Parameters
    ----------
    source
        A motion file, such as .bvh, .glb or .npz, or sample:NAME.
    output
        The .bvh, .glb or .npz file to write.
    crop
        Keep what lies between two times, such as 0.5:1.8 [s].
    mirror
        Exchange left and right.
    resample
        Give it this many frames per second.
    cycle
        Find one clean cycle in it, cut it out and close it.
    travel
        It was captured in place: let its carrying feet take it along.
    """
    check_output(output)
    times = None if crop is None else _times(crop)
    original, supports = read_motion(source, known)
    with about(source):
        clip = travel_clip(original, supports) if travel else original
        clip = _edited(clip, times, mirror=mirror, cycle=cycle, resample=resample)
    save_motion(clip, output)
    print(f"{output}: {clip.frames} frames, {clip.duration:.3f} s, {clip.fps:g} per second")
    for sentence in clip.provenance[len(original.provenance) :]:
        print(f"  {sentence}")


def _edited(
    clip: Clip,
    times: tuple[float, float] | None,
    *,
    mirror: bool,
    cycle: bool,
    resample: float | None,
) -> Clip:
    if times is not None:
        clip = crop_clip(clip, *times)
    if mirror:
        clip = mirror_clip(clip, find_anatomy(clip.skeleton))
    if cycle:
        clip = cut_cycle(clip, find_anatomy(clip.skeleton))
    return clip if resample is None else resample_clip(clip, resample)


def _times(text: str) -> tuple[float, float]:
    start, colon, end = text.partition(":")
    try:
        times = float(start), float(end)
    except ValueError:
        times = None
    if not colon or times is None:
        raise ArgumentError(f"--crop is {text!r}; it must be two times in seconds, such as 0.5:1.8")
    return times


def clean(
    file: str,
    /,
    *,
    output: Annotated[Path, Parameter(name=("-o", "--output"))],
    known: Known | None = None,
) -> None:
    """Pin every planted foot of a motion, and tell its slip before and after.

    Parameters
    ----------
    file
        A motion file, such as .bvh, .glb or .npz, or sample:NAME. Its .supports beside it are
        used; else supports are detected.
    output
        The .bvh, .glb or .npz file to write; its .supports go beside it.
    """
    check_output(output)
    clip, given = read_motion(file, known)
    with about(file):
        anatomy = find_anatomy(clip.skeleton)
        supports = detect_supports(clip, anatomy) if given is None else given
        told = clean_and_tell(clip, supports, anatomy)
        slips = [
            measure(clip_trace(one, anatomy, supports)).slip.overall for one in (clip, told.clip)
        ]
    save_motion(told.clip, output, supports)
    print(f"{output}: supports {origin_of(given)}: {supports}")
    print(f"  {told}")
    for when, slip in zip(("before", "after"), slips, strict=True):
        print(f"  slip {when}: {_spread_text(slip)}")


def _spread_text(spread: Spread) -> str:
    if spread.median is None or spread.p95 is None or spread.maximum is None:
        return "no support span is long enough to be measured"
    return (
        f"median {spread.median:.1f} mm, p95 {spread.p95:.1f} mm, greatest "
        f"{spread.maximum:.1f} mm over {spread.count} support spans"
    )
