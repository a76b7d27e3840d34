"""Look into a motion: `info` and `detect`."""

from __future__ import annotations

import json as json_text
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from cyclopts import Parameter

from footfall.cli.inputs import Known, about, read_motion
from footfall.detection import (
    detect_limb_supports,
    detect_supports,
    hands_on_the_ground,
)
from footfall.errors import ArgumentError, FootfallError, SkeletonError
from footfall.io import (
    Conclusions,
    gltf_animations,
    load_with_conclusions,
    save_supports,
    split_choice,
    supports_text,
)
from footfall.io.clip_choice import CHOOSING
from footfall.motion import Clip
from footfall.skeleton import find_anatomy
from footfall.skeleton.landmarks import landmark_sentences
from footfall.support import Support, SupportSequence

__all__ = ["detect", "info"]

BODY_PARTS_WIDTH = len("right clavicle")


def info(file: str, /, *, json: bool = False, known: Known | None = None) -> None:
    """Say what is in a motion file: joints, rate, unit, axes, feet, cyclic or not, and why.

    Of a glTF file with several animations, all are listed; walk.glb#Walk_Loop chooses one, and
    without a choice the first one is described.

    Parameters
    ----------
    file
        A motion file, such as .bvh, .bvh.gz, .glb, .npz or .txt.
    json
        Print JSON.
    """
    options = (known or Known()).options()
    animations = _animations(file)
    path = f"{file}#0" if len(animations) > 1 and split_choice(file)[1] is None else file
    clip, conclusions = load_with_conclusions(path, **options)
    if json:
        print(json_text.dumps(_info_json(file, clip, conclusions, animations), indent=2))
        return
    print(f"{file}: {clip.frames} frames, {clip.duration:.3f} s, {clip.skeleton.count} joints")
    sentences = (*conclusions.sentences(), ("hands", _hands_sentence(_hands(clip))))
    width = max(len(name) for name, _ in sentences)
    for name, reason in sentences:
        print(f"  {name:<{width}}  {reason}")
    print(f"  {'joints':<{width}}  {', '.join(clip.skeleton.names)}")
    print("body map, by which motions of other bodies are played on this one:")
    for name, sentence in _body_map(clip):
        print(f"  {name:<{BODY_PARTS_WIDTH}}  {sentence}")
    if len(animations) > 1:
        print(f"  {'animations':<{width}}  {', '.join(animations)}")


def _body_map(clip: Clip) -> tuple[tuple[str, str], ...]:
    """Return what each landmark of a body is and why, or why there are none."""
    try:
        return landmark_sentences(clip.skeleton)
    except SkeletonError as error:
        return (("refused", str(error)),)


def _animations(file: str) -> tuple[str, ...]:
    """Return the names of the animations among which one can choose."""
    path, _ = split_choice(file)
    return gltf_animations(path) if path.suffix.lower() in CHOOSING else ()


def _info_json(
    file: str, clip: Clip, conclusions: Conclusions, animations: tuple[str, ...]
) -> dict[str, Any]:
    feet = conclusions.feet.value
    return {
        "file": file,
        "joints": list(clip.skeleton.names),
        "parents": [int(parent) for parent in clip.skeleton.parents],
        "frames": clip.frames,
        "fps": clip.fps,
        "duration": clip.duration,
        "unit": conclusions.unit.value.name,
        "metres_per_unit": conclusions.unit.value.metres,
        "up": conclusions.up.value,
        "root": conclusions.root.value,
        "floor": conclusions.floor.value,
        "cyclic": conclusions.cyclic.value,
        "feet": None
        if feet is None
        else {side: leg._asdict() for side, leg in zip(("left", "right"), feet, strict=True)},
        "hands": _hands(clip),
        "body_map": [list(sentence) for sentence in _body_map(clip)],
        "animations": list(animations),
        "reasons": dict(conclusions.sentences()),
    }


def _hands(clip: Clip) -> tuple[float, float] | None:
    """Return the share of a clip in which each hand carries; None where there are no legs."""
    try:
        anatomy = find_anatomy(clip.skeleton)
    except FootfallError:
        return None
    return hands_on_the_ground(clip, anatomy)


def _hands_sentence(shares: tuple[float, float] | None) -> str:
    if shares is None or max(shares) == 0.0:
        return "never on the ground: the feet alone carry"
    return (
        f"on the ground for {100.0 * shares[0]:.0f} % of the time (left) and "
        f"{100.0 * shares[1]:.0f} % (right): footfall detect --limbs counts them too"
    )


def detect(
    file: str,
    /,
    *,
    output: Annotated[Path | None, Parameter(name=("-o", "--output"))] = None,
    height: float | None = None,
    speed: float | None = None,
    limbs: bool = False,
    json: bool = False,
    known: Known | None = None,
) -> None:
    """Find the support phases of a motion.

    Parameters
    ----------
    file
        A motion file, such as .bvh, .glb or .npz, or sample:NAME.
    output
        Write them to this .supports file.
    height
        The paper's greatest height of the lowest point of a foot that carries [m].
    speed
        The paper's greatest speed of that point [m/s].
    limbs
        Let hands carry too, and knees, elbows and the trunk: D+lr is a body on all fours, +ps
        one that lies. info says whether a motion puts its hands down.
    json
        Print JSON.
    """
    clip, _ = read_motion(file, known)
    with about(file):
        supports = _detected(clip, height, speed, limbs)
    if output is not None:
        save_supports(supports, output)
    if json:
        answer = {
            "cyclic": supports.cyclic,
            "start": supports.start,
            "phases": [
                {"support": phase.support.symbol, "seconds": phase.duration}
                for phase in supports.phases
            ],
            "fps": clip.fps,
            "frames": clip.frames,
            "supports": _frame_symbols(supports, clip, " " if limbs else ""),
        }
        print(json_text.dumps(answer, indent=2))
    elif output is None:
        print(supports_text(supports), end="")
    else:
        print(f"{output}: {supports}")


def _detected(
    clip: Clip, height: float | None, speed: float | None, limbs: bool
) -> SupportSequence:
    if not limbs:
        return detect_supports(clip, height=height, speed=speed)
    if height is not None or speed is not None:
        raise ArgumentError(
            "--height and --speed are the limits of a foot; --limbs has limits of its own"
        )
    return detect_limb_supports(clip)


def _frame_symbols(supports: SupportSequence, clip: Clip, between: str) -> str:
    """Return the support at each frame, with something between two of them."""
    times = np.arange(clip.frames) / clip.fps
    return between.join(Support(one).symbol for one in supports.supports_at(times).tolist())
