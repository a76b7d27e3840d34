from __future__ import annotations

import gzip
import sys
from pathlib import Path

import numpy as np
import pytest
from tests.io.small_biped import biped_clip
from tests.io.small_fbx import fbx_text
from tests.oracles.slow_fbx import Scene

from footfall.errors import ArgumentError, FileFormatError, MissingExtraError
from footfall.io import load, load_with_conclusions
from footfall.io.fbx import read_fbx, read_fbx_nodes
from footfall.io.scene_nodes import world_matrices

pytest.importorskip("ufbx")

CLIP = biped_clip()
REAL = Path(__file__).parents[3] / "shared" / "motions" / "fbx"
TAKES = {
    "pab_locomotions": ("jog", "run", "walk"),
    "pab_walk": ("walk",),
    "pab_skeleton": ("Take 001",),
}
needs_clips = pytest.mark.skipif(not REAL.is_dir(), reason="no motions in ../shared")


def written(tmp_path: Path, name: str = "walk.fbx", **options: object) -> Path:
    path = tmp_path / name
    path.write_bytes(fbx_text(CLIP, **options))  # type: ignore[arg-type]
    return path


@pytest.mark.parametrize(
    "options", [{}, {"armature_scale": 100.0}, {"bones": False}, {"timed": False}]
)
def test_every_joint_is_where_the_file_has_it(tmp_path: Path, options: dict[str, object]) -> None:
    clip = load(written(tmp_path, **options))  # type: ignore[arg-type]
    assert clip.skeleton.names == CLIP.skeleton.names
    assert (clip.fps, clip.frames, clip.name) == (30.0, CLIP.frames, "walk")
    np.testing.assert_allclose(clip.world_poses()[1], CLIP.world_poses()[1], atol=1e-9)


def test_a_file_with_z_up_is_turned(tmp_path: Path) -> None:
    clip, conclusions = load_with_conclusions(written(tmp_path, up="z"))
    x, y, z = np.moveaxis(CLIP.world_poses()[1], -1, 0)
    np.testing.assert_allclose(clip.world_poses()[1], np.stack([x, z, -y], -1), atol=1e-9)
    assert conclusions.up.reason == "z, as the file says"


def test_the_unit_is_the_file_s_own_unless_it_is_wrong(tmp_path: Path) -> None:
    path = written(tmp_path, centimetres=2.54)
    clip, conclusions = load_with_conclusions(path)
    np.testing.assert_allclose(clip.world_poses()[1], 2.54 * CLIP.world_poses()[1], atol=1e-9)
    assert conclusions.unit.reason == "inch (0.0254 m), as the file says"
    clip, conclusions = load_with_conclusions(path, unit="cm")
    np.testing.assert_allclose(clip.world_poses()[1], CLIP.world_poses()[1], atol=1e-9)
    assert conclusions.unit.reason == "cm, as asked for; the file says inch"


def test_a_take_is_found_by_its_name(tmp_path: Path) -> None:
    path = written(tmp_path, take="walk")
    assert read_fbx(path, take="walk")[0].frames == CLIP.frames
    with pytest.raises(FileFormatError) as caught:
        read_fbx(path, take="run")
    assert str(caught.value) == f"{path}: holds no take named 'run'; there are: 'walk'"


def test_what_the_file_knows_cannot_be_told(tmp_path: Path) -> None:
    path = written(tmp_path)
    with pytest.raises(ArgumentError) as caught:
        load(path, fps=30.0)
    assert str(caught.value) == (
        f"{path} knows its upward axis and rate; up= and fps= are for other files"
    )


@pytest.mark.parametrize(
    ("data", "told"),
    [
        (b"", "is damaged or no FBX file: Empty file"),
        (b"no such thing", "is damaged or no FBX file: "),
        (
            fbx_text(CLIP).replace(b'TimeMode", "enum", "", "",6', b'TimeMode", "enum", "", "",14'),
            "",
        ),
    ],
)
def test_a_damaged_file_is_refused_in_one_line(tmp_path: Path, data: bytes, told: str) -> None:
    path = tmp_path / "walk.fbx"
    path.write_bytes(data)
    if not told:
        assert load(path).fps != 30.0
        return
    with pytest.raises(FileFormatError) as caught:
        load(path)
    assert str(caught.value).startswith(f"{path}: {told}")
    assert "\n" not in str(caught.value)


def test_a_take_of_a_thousand_hours_is_refused(tmp_path: Path) -> None:
    stop = f'"LocalStop", "KTime", "Time", "",{round(CLIP.duration * 46186158000)}'
    long = stop.rsplit(",", 1)[0] + ",166270168800000000"
    path = tmp_path / "long.fbx"
    path.write_bytes(fbx_text(CLIP).replace(stop.encode(), long.encode()))
    with pytest.raises(FileFormatError, match="its take is 108000001 frames of 12 nodes, far more"):
        load(path)


def test_a_scene_without_a_skeleton_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "empty.fbx"
    text = fbx_text(CLIP)
    head, tail = text.index(b"Objects: {"), text.index(b"Connections: {")
    path.write_bytes(text[:head] + b"Objects: {\n}\n" + b"Connections: {\n}\n")
    assert tail > head
    with pytest.raises(FileFormatError) as caught:
        load(path)
    assert str(caught.value) == (f"{path}: holds no skeleton: none of its 1 nodes is a bone")


def test_without_the_library_the_way_to_get_it_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "ufbx", None)
    with pytest.raises(MissingExtraError) as caught:
        load(written(tmp_path))
    assert str(caught.value) == "reading walk.fbx needs ufbx; pip install 'footfall[fbx]'"


@needs_clips
@pytest.mark.parametrize(("name", "take"), [(n, t) for n, takes in TAKES.items() for t in takes])
def test_bones_of_real_files_are_where_a_slow_reader_finds_them(name: str, take: str) -> None:
    """Within 0.1 mm; the worst seen is 0.00004 mm."""
    path = REAL / f"{name}.fbx.gz"
    nodes, _ = read_fbx_nodes(path, take)
    world = world_matrices(nodes, path)
    scene = Scene(gzip.decompress(path.read_bytes()), take)
    frames = np.arange(0, len(world), max(len(world) // 6, 1))
    joints = np.flatnonzero(nodes.joints)
    assert len(joints) == 67
    for joint in joints.tolist():
        wanted = scene.positions(nodes.names[joint], frames / nodes.fps)
        strays = np.linalg.norm(world[frames, joint, :3, 3] - wanted, axis=-1)
        assert strays.max() < 1e-4, nodes.names[joint]


@needs_clips
@pytest.mark.parametrize(("name", "take"), [(n, t) for n, takes in TAKES.items() for t in takes])
def test_feet_of_real_files_hardly_move_with_fixed_bones(name: str, take: str) -> None:
    path = REAL / f"{name}.fbx.gz"
    clip, conclusions = read_fbx(path, take=take)
    nodes, _ = read_fbx_nodes(path, take)
    world = world_matrices(nodes, path)
    _, positions = clip.world_poses()
    assert conclusions.unit.value.name == "cm"
    assert conclusions.feet.value is not None
    for leg in conclusions.feet.value:
        for joint in (leg.ankle, leg.toe):
            wanted = world[:, nodes.names.index(joint), :3, 3]
            strays = np.linalg.norm(positions[:, clip.skeleton.index(joint)] - wanted, axis=-1)
            assert strays.max() < 0.004


@needs_clips
def test_the_other_takes_of_a_file_are_told() -> None:
    clip, _ = load_with_conclusions(REAL / "pab_locomotions.fbx.gz")
    assert clip.provenance[1] == "take 'jog' is read; the file also holds 'run', 'walk'"


def test_the_parser_may_not_take_all_memory(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr("footfall.io.guarded_process.LEAST_MEMORY", 100_000)
    monkeypatch.setattr("footfall.io.guarded_process.MEMORY_PER_BYTE", 0)
    with pytest.raises(FileFormatError, match=r"[Mm]emory|far more than such a file holds"):
        load(written(tmp_path))
