"""Play a motion on another body: `retarget`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import numpy as np
from cyclopts import Parameter

from footfall.cli.inputs import about, origin_of, read_motion
from footfall.cli.outputs import check_output, save_motion
from footfall.detection import detect_supports
from footfall.io.map_file import load_map
from footfall.motion.retargeting import map_clip, performer_anatomy
from footfall.motion.retargeting import retarget as retarget_clip
from footfall.report import clip_trace
from footfall.report.contract import contract_of, contract_table
from footfall.report.track import carrying

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
        A motion file of the body that is to perform it, or sample:NAME.
    output
        The .bvh, .glb or .npz file to write; its .supports go beside it.
    map_file
        A TOML file that corrects what drives the body's joints.
    """
    check_output(output)
    corrections = None if map_file is None else load_map(map_file)
    clip, known = read_motion(motion)
    other, _ = read_motion(body)
    with about(motion):
        supports = detect_supports(clip) if known is None else known
    with about(body):
        body_map = map_clip(clip, other.skeleton, other, corrections)
        carries = carrying(supports.supports_at(np.arange(clip.frames) / clip.fps))
        result = retarget_clip(clip, other.skeleton, body_map, carries)
    save_motion(result, output, supports)
    print(f"{output}: supports {origin_of(known)}: {supports}")
    print(f"  {result.provenance[-1]}")
    for sentence in body_map.reasons:
        print(f"  map: {sentence}")
    trace = clip_trace(result, performer_anatomy(clip, body_map), supports)
    print(contract_table(contract_of(trace, result.skeleton)))
