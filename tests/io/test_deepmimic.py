# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false
# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false
# pyright: reportUnknownParameterType=false, reportMissingTypeStubs=false
from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.io.small_files import CHARACTER, humanoid_clip

from footfall.errors import FileFormatError
from footfall.geometry import from_euler
from footfall.io import load, load_deepmimic, load_with_conclusions, save_deepmimic


@pytest.mark.parametrize("name", ["a.txt", "a.txt.gz"])
def test_what_is_written_comes_back(tmp_path: Path, name: str) -> None:
    clip = humanoid_clip(9)
    save_deepmimic(clip, tmp_path / name)
    read = load(tmp_path / name)
    # Skeletons stand depth-first, the humanoid's file does not.
    assert read.skeleton.names[:5] == ("root", "chest", "neck", "right_shoulder", "right_elbow")
    assert (read.fps, read.frames, read.cyclic) == (30.0, 9, False)
    for one in clip.skeleton.names:
        places = read.world_poses()[1][:, read.skeleton.index(one)]
        wanted = clip.world_poses()[1][:, clip.skeleton.index(one)]
        np.testing.assert_allclose(places, wanted, atol=1e-8)
    save_deepmimic(read, tmp_path / "again.txt")
    again = load(tmp_path / "again.txt")
    np.testing.assert_allclose(again.world_poses()[1], read.world_poses()[1], atol=1e-8)


def frames(durations: list[float]) -> dict[str, Any]:
    """Return a motion that moves forward by a metre a second, a knee bending by a radian."""
    starts = np.concatenate([[0.0], np.cumsum(durations[:-1])])
    rows = []
    for duration, start in zip(durations, starts, strict=True):
        row = [duration, start, 0.85, 0.0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]
        row += [1, 0, 0, 0, start, 1, 0, 0, 0, 1, 0, 0, 0, 0]
        row += [1, 0, 0, 0, start, 1, 0, 0, 0, 1, 0, 0, 0, 0]
        rows.append(row)
    return {"Loop": "none", "Frames": rows}


def write(path: Path, content: Any) -> Path:
    path.write_text(json.dumps(content))
    return path


@pytest.mark.parametrize(
    ("seconds", "rate"),
    [(0.033332, 30.0), (0.0166660007, 60.0), (0.0625, 16.0), (0.037, 1 / 0.037)],
)
def test_durations_cut_short_mean_a_usual_rate(tmp_path: Path, seconds: float, rate: float) -> None:
    path = write(tmp_path / "a.txt", frames([seconds] * 5))
    assert load(path).fps == pytest.approx(rate, rel=1e-12)
    assert load(path, fps=25.0).fps == 25.0


def test_frames_of_unequal_length_are_made_equal(tmp_path: Path) -> None:
    path = write(tmp_path / "a.txt", frames([0.02, 0.04, 0.02, 0.06, 0.0]))
    clip, conclusions = load_with_conclusions(path)
    assert (clip.fps, clip.frames) == (50.0, 8)
    np.testing.assert_allclose(clip.pelvis_positions[:, 0], np.arange(8) / 50.0, atol=1e-9)
    knee = clip.skeleton.index("left_knee")
    wanted = from_euler("Z", (np.arange(8) / 50.0)[:, np.newaxis])
    np.testing.assert_allclose(clip.local_rotations[:, knee], wanted, atol=1e-6)
    assert conclusions.frames.reason == (
        "8, in steps of one length: the 5 of the file last unequally long"
    )


def test_another_character_performs(tmp_path: Path) -> None:
    body = write(tmp_path / "c.txt", CHARACTER)
    rows = [[0.1, 0, 1, 0, 1, 0, 0, 0, 0.5], [0.0, 0, 1, 0, 1, 0, 0, 0, 0.5]]
    path = write(tmp_path / "a.txt", {"Frames": rows})
    clip = load(path, body=body, unit="m", up="y")
    assert clip.skeleton.names == ("root", "knee", "foot")
    np.testing.assert_allclose(clip.skeleton.tip_offsets[2], [0.14, -0.03, 0.0])
    np.testing.assert_allclose(
        clip.world_poses()[1][0, 2], [0.4 * np.sin(0.5), 0.6 - 0.4 * np.cos(0.5), 0.0]
    )


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ({}, "Frames is missing; a motion needs at least one frame"),
        ({"Frames": [[1, 2]]}, "Frames[0] has 2 numbers; the body needs 44"),
        ({"Frames": [[True] * 44]}, "Frames[0] holds what is no finite number below 1e12"),
        (frames([0.0, 0.1]), "Frames[0] lasts 0 s; it must last longer than zero"),
        (
            {"Frames": [[0.1, 0, 0, 0] + [0] * 40]},
            "Frames (joint 0) holds a quaternion of length 0; rotations have length 1",
        ),
        (
            frames([1e-6, 1e6, 0.0]),
            "Frames last between one moment and many times as long; pass fps=",
        ),
    ],
)
def test_a_fault_is_named(tmp_path: Path, content: Any, message: str) -> None:
    path = write(tmp_path / "a.txt", content)
    with pytest.raises(FileFormatError) as caught:
        load_deepmimic(path)
    assert str(caught.value) == f"{path}: {message}"


def test_a_knee_that_turns_sideways_is_not_written(tmp_path: Path) -> None:
    clip = humanoid_clip()
    rotations = clip.local_rotations.copy()
    rotations[:, 4] = from_euler("X", np.full((3, 1), 0.1))
    with pytest.raises(
        FileFormatError, match=r"'right_knee' is a hinge, and is turned by 5\.7 deg"
    ):
        save_deepmimic(clip.evolve(local_rotations=rotations), tmp_path / "a.txt")


def test_another_body_is_not_written(tmp_path: Path) -> None:
    clip = humanoid_clip()
    body = type(clip.skeleton)
    other = body(clip.skeleton.names, clip.skeleton.parents, 1.1 * clip.skeleton.rest_offsets)
    with pytest.raises(
        FileFormatError, match=r"'right_knee' is 42\.2 mm from where DeepMimic's body"
    ):
        save_deepmimic(clip.evolve(skeleton=other), tmp_path / "a.txt")
    names = ("hips", *clip.skeleton.names[1:])
    other = body(names, clip.skeleton.parents, clip.skeleton.rest_offsets)
    with pytest.raises(FileFormatError, match="retarget the motion onto it first"):
        save_deepmimic(clip.evolve(skeleton=other), tmp_path / "a.txt")
    assert list(tmp_path.iterdir()) == []
