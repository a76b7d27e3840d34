"""Play a motion on another body: `retarget`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import numpy as np
from cyclopts import Parameter

from footfall.cli.inputs import about, origin_of, read_motion
from footfall.cli.outputs import check_output, save_motion
from footfall.detection import detect_supports, frame_symbols
from footfall.errors import FileFormatError
from footfall.io import gltf_animations, load_skinned, save_skinned, save_supports, split_choice
from footfall.io.map_file import load_map
from footfall.io.skinned_body import SkinnedBody
from footfall.motion import Clip
from footfall.motion.retargeting import map_clip, performer_anatomy
from footfall.motion.retargeting import retarget as retarget_clip
from footfall.report import clip_trace
from footfall.report.contract import contract_of, contract_table
from footfall.report.track import carrying
from footfall.scenario.motions import supports_path
from footfall.skeleton import Skeleton

__all__ = ["retarget"]


def retarget(
    motion: str,
    /,
    *,
    body: str,
    output: Annotated[Path, Parameter(name=("-o", "--output"))],
    map_file: Annotated[Path | None, Parameter(name="--map")] = None,
) -> None:
    """Play a motion on another body, and tell how every support was kept.

    Parameters
    ----------
    motion
        A motion file, or sample:NAME. Its .supports beside it are used; else supports are
        detected.
    body
        A motion file of the body that is to perform it, or sample:NAME; or a .glb with a skinned
        character, whose skin a .glb that is written moves.
    output
        The .bvh, .glb or .npz file to write; its .supports go beside it.
    map_file
        A TOML file that corrects what drives the body's joints.
    """
    check_output(output)
    corrections = None if map_file is None else load_map(map_file)
    clip, known = read_motion(motion)
    skinned = _skinned(body)
    skeleton, shown = _performer(body, skinned)
    with about(motion):
        supports = detect_supports(clip) if known is None else known
    with about(body):
        body_map = map_clip(clip, skeleton, shown, corrections)
        carries = carrying(supports.supports_at(np.arange(clip.frames) / clip.fps))
        result = retarget_clip(clip, skeleton, body_map, carries)
    if skinned is not None and output.suffix.lower() == ".glb":
        symbols = frame_symbols(supports, result.fps, result.frames)
        save_skinned(skinned, [result], output, supports=[symbols])
        save_supports(supports, supports_path(output))
    else:
        save_motion(result, output, supports)
    print(f"{output}: supports {origin_of(known)}: {supports}")
    print(f"  {result.provenance[-1]}")
    for sentence in body_map.reasons:
        print(f"  map: {sentence}")
    trace = clip_trace(result, performer_anatomy(clip, body_map), supports)
    print(contract_table(contract_of(trace, result.skeleton)))


def _skinned(body: str) -> SkinnedBody | None:
    """Return the character in a glTF file; None where there is no skin in it."""
    path, _ = split_choice(body)
    if path.suffix.lower() not in (".glb", ".gltf"):
        return None
    try:
        return load_skinned(path)
    except FileFormatError:
        # Why the file is none will be told by the reader of motions, or it has joints alone.
        return None


def _performer(body: str, skinned: SkinnedBody | None) -> tuple[Skeleton, Clip | None]:
    """Return the body that is to perform, and a motion that shows its hinges and soles."""
    if skinned is None:
        clip, _ = read_motion(body)
        return clip.skeleton, clip
    path, choice = split_choice(body)
    animations = gltf_animations(path)
    if not animations:
        return skinned.skeleton, None
    shown, _ = read_motion(body if choice is not None or len(animations) == 1 else f"{body}#0")
    alike = skinned.skeleton.same_family(shown.skeleton)
    return skinned.skeleton, shown.ordered_like(skinned.skeleton) if alike else None
