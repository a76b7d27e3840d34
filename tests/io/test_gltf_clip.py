# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false
# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false
# pyright: reportUnknownParameterType=false, reportMissingTypeStubs=false
from __future__ import annotations

import base64
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests import walking_figure
from tests.io.small_gltf import SmallGltf
from tests.oracles.slow_gltf import SlowGltf

from footfall.errors import ArgumentError, FileFormatError, UnknownNameError
from footfall.geometry import from_axis_angle
from footfall.io import gltf_animations, load, load_with_conclusions, save_gltf
from footfall.motion import Clip

X = np.array([1.0, 0.0, 0.0])


def turns(angles: Any, axis: Any = X) -> Any:
    """Return quaternions xyzw."""
    return np.roll(from_axis_angle(axis, np.array(angles, dtype=np.float64)), -1, axis=-1)


def refusal(path: Path, **known: Any) -> str:
    with pytest.raises(FileFormatError) as caught:
        load(path, **known)
    return str(caught.value).removeprefix(f"{path}: ")


def strays(path: Path, clip: Clip, animation: int | None = 0, start: float = 0.0) -> float:
    """Return how far a joint is at most from where the oracle has it [m]."""
    slow = SlowGltf(path)
    names = [node.get("name") for node in slow.nodes]
    positions = clip.world_poses()[1]
    worst = 0.0
    for frame in range(clip.frames):
        # A step counts as done at its key, whose time is rounded to single precision.
        moved = slow.properties(animation, start + frame / clip.fps + 1e-7)
        for joint, name in enumerate(clip.skeleton.names):
            there = slow.world(names.index(name), moved)[:3, 3]
            worst = max(worst, float(np.linalg.norm(positions[frame, joint] - there)))
    return worst


def moving() -> SmallGltf:
    """Return a rig of which every kind of keys moves something."""
    small = SmallGltf()
    small.animate(1, "translation", [0, 0.5, 1], [[0, 0, 95], [5, 30, 92], [0, 60, 95]])
    small.animate(2, "rotation", [0, 0.5, 1], turns([0.0, 0.7, -0.4]))
    small.animate(3, "rotation", [0.2, 0.6], turns([0.3, 0.9]), "STEP")
    spline = np.zeros((3, 3, 4))
    spline[:, 1] = turns([0.1, -0.6, 0.2])
    spline[:, 0] = spline[:, 2] = [0.5, 0.1, 0.0, 0.2]
    small.animate(5, "rotation", [0, 0.4, 1], spline.reshape(9, 4), "CUBICSPLINE")
    return small


def test_linear_stepped_and_cubic_keys_under_a_turned_and_scaled_root(tmp_path: Path) -> None:
    path = moving().write(tmp_path / "a.glb")
    clip, conclusions = load_with_conclusions(path)
    assert (clip.fps, clip.frames, clip.name) == (30.0, 31, "move")
    assert clip.skeleton.names[0] == "Hips"
    assert strays(path, clip) < 1e-6
    assert conclusions.unit.reason.startswith("m, as always in glTF; the legs are then 0.840 m")
    assert conclusions.up.value == "y"
    assert "'Armature' above it carries nothing else" in conclusions.root.reason


def test_a_rate_that_is_asked_for_samples_the_same_motion(tmp_path: Path) -> None:
    path = moving().write(tmp_path / "a.glb")
    clip = load(path, fps=75.0)
    assert (clip.fps, clip.frames) == (75.0, 76)
    assert strays(path, clip) < 1e-6


def test_keys_that_begin_late_begin_the_clip(tmp_path: Path) -> None:
    small = SmallGltf()
    times = 1.0 / 24.0 + np.arange(5) / 24.0
    small.animate(2, "rotation", times, turns([0.0, 0.1, 0.2, 0.3, 0.4]))
    path = small.write(tmp_path / "a.glb")
    clip = load(path)
    assert (clip.fps, clip.frames) == (24.0, 5)
    assert strays(path, clip, start=1.0 / 24.0) < 1e-6


def test_a_scale_that_changes_moves_the_joints_below_it(tmp_path: Path) -> None:
    small = SmallGltf()
    small.animate(8, "scale", [0, 1], [[1, 1, 1], [1.5, 1.5, 1.5]])
    path = small.write(tmp_path / "a.glb")
    _, conclusions = load_with_conclusions(path)
    assert "'Head' strays most, by 100.0 mm" in conclusions.bones.reason


def test_a_matrix_stands_for_its_translation_rotation_and_scale(tmp_path: Path) -> None:
    small = moving()
    record = small.document["nodes"][0]
    del record["rotation"], record["scale"]
    small.document["nodes"][0]["matrix"] = [
        0.01, 0, 0, 0, 0, 0, -0.01, 0, 0, 0.01, 0, 0, 0.5, 0, 0, 1,
    ]  # fmt: skip
    path = small.write(tmp_path / "a.glb")
    assert strays(path, load(path)) < 1e-6


def test_buffers_may_be_data_or_files_beside(tmp_path: Path) -> None:
    small = moving()
    wanted = load(small.write(tmp_path / "a.glb")).world_poses()[1]
    data = base64.b64encode(small.buffers.data).decode()
    (tmp_path / "a b.bin").write_bytes(small.buffers.data)
    for uri in (f"data:application/octet-stream;base64,{data}", "a%20b.bin"):
        read = load(small.write_apart(tmp_path / "a.gltf", uri))
        np.testing.assert_array_equal(read.world_poses()[1], wanted)


@pytest.mark.parametrize("uri", ["../a.bin", "/etc/hostname", "http://a/b.bin", "..%2Fa.bin"])
def test_no_file_outside_its_folder_is_read(tmp_path: Path, uri: str) -> None:
    (tmp_path / "a.bin").write_bytes(moving().buffers.data)
    (tmp_path / "in").mkdir()
    path = moving().write_apart(tmp_path / "in" / "a.gltf", uri)
    shown = uri.replace("%2F", "/")
    assert refusal(path) == (
        f"buffers[0].uri is {shown!r}; only files in or below its own folder are read"
    )


def test_a_clip_is_chosen_by_name_or_number(tmp_path: Path) -> None:
    small = moving()
    small.start("Walk/Loop")
    small.animate(2, "rotation", [0, 1.5], turns([0.0, 0.2]))
    path = small.write(tmp_path / "a.glb")
    assert gltf_animations(path) == ("move", "Walk/Loop")
    for clip in (
        load(f"{path}#Walk/Loop"),
        load(f"{path}#1"),
        load(path, animation="Walk/Loop"),
        load(path, animation=1),
    ):
        assert (clip.name, clip.duration) == ("Walk/Loop", 1.5)
    assert refusal(path) == (
        "holds 2 animations; choose one by its name, such as a.glb#move, or its number: move, "
        "Walk/Loop"
    )
    with pytest.raises(UnknownNameError) as caught:
        load(f"{path}#Run")
    assert str(caught.value) == (f"no animation in {path} named 'Run'; there are: move, Walk/Loop")
    with pytest.raises(
        ArgumentError, match=re.escape("animation= is for .fbx, .fbx.gz, .glb, .gltf")
    ):
        load(tmp_path / "a.bvh", animation=1)


def test_a_file_without_animation_is_a_pose(tmp_path: Path) -> None:
    small = SmallGltf()
    joints = small.buffers.add(np.tile(np.eye(4), (9, 1, 1)), "f4")
    small.document["skins"] = [{"joints": list(range(1, 10)), "inverseBindMatrices": joints}]
    clip, conclusions = load_with_conclusions(small.write(tmp_path / "a.glb"))
    assert clip.frames == 1
    assert conclusions.frames.reason == "1, the pose of the file: it holds no animation"


def test_what_this_project_writes_comes_back(tmp_path: Path) -> None:
    clip = walking_figure.walk()
    save_gltf(clip, tmp_path / "walk.glb")
    read = load(tmp_path / "walk.glb")
    assert read.skeleton.same_family(clip.skeleton)
    assert (read.fps, read.frames, read.cyclic) == (clip.fps, clip.frames, clip.cyclic)
    np.testing.assert_allclose(read.skeleton.rest_offsets, clip.skeleton.rest_offsets, atol=1e-6)
    np.testing.assert_allclose(read.world_poses()[1], clip.world_poses()[1], atol=2e-6)


FAULTS: dict[str, Any] = {
    "a circle": (
        lambda d: d["nodes"][9].update(children=[1]) or d["nodes"][0].pop("children"),
        "nodes[1].children lead back to the node itself",
    ),
    "two parents": (
        lambda d: d["nodes"][9].update(children=[3]),
        "nodes[3] is a child of node 2 and again of node 9",
    ),
    "a mirror": (
        lambda d: d["nodes"][8].update(scale=[-1, 1, 1]),
        "node 'Spine' has a scale of -1, which mirrors the joints below it; apply the scale "
        "before the export",
    ),
    "a shear": (
        lambda d: d["nodes"][1].update(scale=[1, 2, 1]),
        "node 'Hips' is stretched unevenly, by 1, 2 and 1, which shears the joints below it; "
        "apply the scale before the export",
    ),
    "no turn": (
        lambda d: d["nodes"][2].update(rotation=[0, 0, 0, 0]),
        "nodes[2].rotation holds a quaternion of length 0; rotations have length 1",
    ),
    "an extension": (
        lambda d: d.update(extensionsRequired=["KHR_draco_mesh_compression"]),
        "requires the extension 'KHR_draco_mesh_compression', which is not read; export it "
        "without it",
    ),
    "an old version": (
        lambda d: d["asset"].update(version="1.0"),
        "asset.version is 1.0; this program reads glTF 2",
    ),
    "a far accessor": (
        lambda d: d["animations"][0]["samplers"][0].update(output=99),
        "accessors[99] is referred to, but there are 8",
    ),
    "a short output": (
        lambda d: d["animations"][0]["samplers"][1].update(output=5),
        "animations[0].samplers[1].output holds 2 values for 3 keys",
    ),
    "two channels": (
        lambda d: d["animations"][0]["channels"][1]["target"].update(node=1, path="translation"),
        "animations[0].channels[1].target.path is translation of node 1, which another channel "
        "moves already",
    ),
}


@pytest.mark.parametrize("fault", sorted(FAULTS))
def test_a_fault_is_named(tmp_path: Path, fault: str) -> None:
    small = moving()
    change, message = FAULTS[fault]
    change(small.document)
    assert refusal(small.write(tmp_path / "a.glb")) == message


def test_keys_a_million_years_apart_are_refused(tmp_path: Path) -> None:
    small = SmallGltf()
    small.animate(2, "rotation", [0, 1e9], turns([0.0, 0.2]))
    assert "more than so small a file is believed to mean; pass a smaller fps=" in refusal(
        small.write(tmp_path / "a.glb")
    )


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"glTF\x02\0\0\0", "has 8 bytes; a GLB file begins with 20, so it was cut short"),
        (b"glTF\x01\0\0\0" + bytes(20), "is GLB version 1; this program reads 2"),
        (
            b"glTF\x02\0\0\0\x99\0\0\0" + bytes(20),
            "says that it has 153 bytes, but has 32; fetch it again",
        ),
        (b"[1]", "is JSON, but no object; one is expected, {...}"),
        (b'{"asset": {"version": "2.0"}}', "holds no skin and no animated nodes; there is no body"),
    ],
)
def test_what_is_no_glb_is_refused(tmp_path: Path, data: bytes, message: str) -> None:
    (tmp_path / "a.glb").write_bytes(data)
    assert refusal(tmp_path / "a.glb") == message
