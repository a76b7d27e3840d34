"""Motions for robots: `robot` and `robot-model`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from footfall.cli.inputs import about, origin_of, read_motion
from footfall.cli.outputs import check_folder, check_output, save_motion
from footfall.detection import detect_supports
from footfall.errors import FileFormatError
from footfall.io import write_atomically
from footfall.robots import (
    Robot,
    clip_of_robot,
    humanoid_mjcf,
    load_robot,
    load_robot_motion,
    our_robot,
    perform_on_robot,
    save_robot_motion,
)

__all__ = ["robot", "robot_model"]


def robot(
    motion: str,
    /,
    *,
    output: Annotated[Path, Parameter(name=("-o", "--output"))],
    model: Path | None = None,
    back: bool = False,
) -> None:
    """Let a humanoid robot perform a motion: qpos, joint targets and support labels, for MuJoCo.

    Parameters
    ----------
    motion
        Any motion file, or sample:NAME. With --back, a .npz that this command wrote.
    output
        The .npz file to write. With --back, any motion file.
    model
        The robot, an MJCF file: a free root, hinges, bodies named as limbs are; by default the
        project's own humanoid (see robot-model).
    back
        Turn a robot's motion into a motion of its bodies instead.
    """
    if back:
        check_output(output)
        moves = load_robot_motion(motion)
        clip = clip_of_robot(moves, _robot(model), Path(motion))
        save_motion(clip, output)
        print(
            f"{output}: {clip.frames} frames, {clip.duration:.3f} s, {clip.skeleton.count} joints"
        )
        return
    if output.suffix.lower() != ".npz":
        raise FileFormatError("cannot be written: a robot's motion is a .npz file", path=output)
    check_folder(output)
    clip, known = read_motion(motion)
    with about(motion):
        supports = detect_supports(clip) if known is None else known
        performer = _robot(model)
        moves = perform_on_robot(performer, clip, supports)
    save_robot_motion(moves, performer, output)
    print(
        f"{output}: {clip.frames} frames of {performer.name!r}, {len(performer.hinges)} hinges, "
        f"supports {origin_of(known)}"
    )


def _robot(model: Path | None) -> Robot:
    return our_robot() if model is None else load_robot(model)


def robot_model(
    *, output: Annotated[Path, Parameter(name=("-o", "--output"))], stature: float = 1.75
) -> None:
    """Write the project's own humanoid robot as MJCF.

    Parameters
    ----------
    output
        The .xml file to write.
    stature
        How tall it is [m].
    """
    write_atomically(output, humanoid_mjcf(stature).encode())
    print(output)
