"""Play a motion on another body: `retarget`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from footfall.cli.inputs import about, origin_of, read_motion
from footfall.cli.outputs import check_output
from footfall.cli.performers import performed, read_performer, save_performance
from footfall.detection import detect_supports
from footfall.io.map_file import load_map
from footfall.report import clip_trace
from footfall.report.contract import contract_of, contract_table

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
        A motion file of the body that is to perform it, a .glb or .gltf file of a character
        without motions, or sample:NAME. A character keeps its skin in a .glb file.
    output
        The .bvh, .glb or .npz file to write; its .supports go beside it.
    map_file
        A TOML file that corrects what drives the body's joints.
    """
    check_output(output)
    corrections = None if map_file is None else load_map(map_file)
    clip, known = read_motion(motion)
    performer = read_performer(body)
    with about(motion):
        supports = detect_supports(clip) if known is None else known
    performance = performed(clip, supports, performer, corrections)
    save_performance(performance, output, supports)
    print(f"{output}: supports {origin_of(known)}: {supports}")
    print(f"  {performance.clip.provenance[-1]}")
    for sentence in performance.reasons:
        print(f"  map: {sentence}")
    result = performance.clip
    trace = clip_trace(result, performance.anatomy, supports)
    print(contract_table(contract_of(trace, result.skeleton)))
