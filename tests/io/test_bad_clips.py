"""A bad clip is refused at load with a message, whatever it comes from; never played, never NaN."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import footfall as ff
from footfall.errors import ClipError, FileFormatError, SkeletonError
from footfall.skeleton import Skeleton

Arrays = dict[str, Any]


def pelvis(number: float) -> Callable[[Arrays], None]:
    def change(arrays: Arrays) -> None:
        arrays["pelvis_positions"][3, 1] = number

    return change


def rotation(number: float) -> Callable[[Arrays], None]:
    def change(arrays: Arrays) -> None:
        arrays["local_rotations"][3, 2, 1] = number

    return change


def bone(number: float) -> Callable[[Arrays], None]:
    def change(arrays: Arrays) -> None:
        arrays["rest_offsets"][2, 1] = number

    return change


FAULTS: dict[str, tuple[Callable[[Arrays], None], str]] = {
    "NaN position": (pelvis(math.nan), "a pelvis position in frame 3 is not finite"),
    "infinite position": (pelvis(math.inf), "a pelvis position in frame 3 is not finite"),
    "exploded position": (pelvis(1e30), "the pelvis in frame 3 is 1e+30 m away"),
    "NaN rotation": (rotation(math.nan), "a rotation in frame 3 is not finite"),
    "infinite rotation": (rotation(math.inf), "a rotation in frame 3 is not finite"),
    "long quaternion": (rotation(5.0), "unit quaternions are needed"),
    "NaN bone": (bone(math.nan), "is not finite"),
    "endless bone": (bone(1e12), "is 1e+12 m long"),
}


def arrays_of(clip: ff.Clip) -> Arrays:
    return {
        "pelvis_positions": np.array(clip.pelvis_positions),
        "local_rotations": np.array(clip.local_rotations),
        "rest_offsets": np.array(clip.skeleton.rest_offsets),
    }


@pytest.mark.parametrize("fault", FAULTS)
def test_arrays_make_no_bad_clip(fault: str) -> None:
    walk, _ = ff.sample("walk")
    change, told = FAULTS[fault]
    arrays = arrays_of(walk)
    change(arrays)
    with pytest.raises((ClipError, SkeletonError)) as caught:
        walk.evolve(
            skeleton=Skeleton(walk.skeleton.names, walk.skeleton.parents, arrays["rest_offsets"]),
            pelvis_positions=arrays["pelvis_positions"],
            local_rotations=arrays["local_rotations"],
        )
    assert told in str(caught.value)


@pytest.mark.parametrize("fault", FAULTS)
def test_a_file_of_ours_holds_no_bad_clip(fault: str, tmp_path: Path) -> None:
    path = tmp_path / "walk.npz"
    ff.save(ff.sample("walk")[0], path)
    with np.load(path) as stored:
        arrays = dict(stored)
    change, told = FAULTS[fault]
    change(arrays)
    np.savez(path, **arrays)
    with pytest.raises(FileFormatError) as caught:
        ff.load(path)
    assert str(caught.value).startswith(f"{path}: ")
    assert told in str(caught.value)


@pytest.mark.parametrize("number", ["nan", "inf", "-inf", "1e30", "1e300", "x"])
@pytest.mark.parametrize("place", ["root", "rotation", "bone"])
def test_a_bvh_holds_no_bad_clip(number: str, place: str, tmp_path: Path) -> None:
    path = tmp_path / "walk.bvh"
    ff.save(ff.sample("walk")[0], path)
    lines = path.read_text().splitlines()
    if place == "bone":
        row = [i for i, line in enumerate(lines) if "OFFSET" in line][2]
        words = lines[row].split()
        words[2] = number
    else:
        row = next(i for i, line in enumerate(lines) if line.startswith("Frame Time")) + 4
        words = lines[row].split()
        words[1 if place == "root" else 7] = number
    lines[row] = " ".join(words)
    path.write_text("\n".join(lines) + "\n")
    with pytest.raises(FileFormatError) as caught:
        ff.load(path)
    assert str(caught.value).startswith(f"{path}")


@pytest.mark.parametrize(
    "names", [("LeftLeg",), ("RightFoot",), ("LeftLeg", "LeftFoot", "RightLeg", "RightFoot")]
)
def test_legs_of_no_length_are_refused(names: tuple[str, ...]) -> None:
    walk, supports = ff.sample("walk")
    offsets = np.array(walk.skeleton.rest_offsets)
    for name in names:
        offsets[walk.skeleton.index(name)] = 0.0
    body = Skeleton(walk.skeleton.names, walk.skeleton.parents, offsets)
    with pytest.raises(SkeletonError) as caught:
        ff.Character(body).add("walk", walk.evolve(skeleton=body), supports)
    assert str(caught.value).startswith("no legs found")
    with pytest.raises(SkeletonError):
        ff.MotionLibrary().add("walk", walk.evolve(skeleton=body), supports)
