"""Every conclusion about every real clip, against what people found out about it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from footfall.errors import FileFormatError
from footfall.io import load, load_with_conclusions, save_bvh
from footfall.io.bvh_rig import parse_bvh
from footfall.io.raw_file import read_bytes

FOLDER = Path(__file__).parents[3] / "shared" / "motions"
MANIFEST = FOLDER / "manifest.json"

needs_clips = pytest.mark.skipif(not MANIFEST.exists(), reason=f"no {MANIFEST.name} in ../shared")


def described() -> list[Any]:
    """Return the records of the BVH clips of which the manifest knows the meaning."""
    if not MANIFEST.exists():
        return []
    records: list[Any] = json.loads(MANIFEST.read_text(encoding="utf-8"))["clips"]
    return [record for record in records if record["format"] == "bvh.gz" and "unit" in record]


CLIPS = pytest.mark.parametrize("record", described(), ids=lambda record: record["file"])


@needs_clips
@CLIPS
def test_what_is_concluded_is_what_is_known(record: Any) -> None:
    clip, conclusions = load_with_conclusions(FOLDER / record["file"])
    assert conclusions.unit.value.metres == pytest.approx(record["scale_to_m"], rel=1e-5)
    assert conclusions.up.value.upper() == record["up"]
    assert clip.fps == pytest.approx(record["fps"], rel=1e-4)
    assert clip.frames == conclusions.frames.value == record["frames"]
    assert clip.skeleton.names[0] == record["hips"]
    assert conclusions.feet.value is not None
    for side, leg in zip("LR", conclusions.feet.value, strict=True):
        assert leg._asdict() == record["feet"][side]
    assert conclusions.floor.value == pytest.approx(
        min(record["ground_ankle_m"], record["ground_toe_m"]), abs=0.05
    )
    # A clip that closes exactly is one that loops.
    closes = record["loop"]["first_last_rms_m"] == 0.0
    assert clip.cyclic == conclusions.cyclic.value == closes
    # Of the three files with a leap after their first frame, each begins with a T-pose.
    leaps = record["loop"]["first_last_rms_vel"] > 9.0
    assert conclusions.first_frame.value == leaps


@needs_clips
def test_position_channels_stand_in_place_of_an_arbitrary_offset() -> None:
    """The root's OFFSET in these files is somewhere in the laboratory, the same in all of them."""
    for path in sorted(FOLDER.glob("snu_cmu69/cmu69_*.bvh.gz")):
        rig = parse_bvh(read_bytes(path), path)
        assert rig.offsets[0].tolist() == [-69.4423, 88.0299, 51.6846]
        clip = load(path)
        np.testing.assert_allclose(clip.pelvis_positions * 100.0, rig.translations[0])
        # Added to the channels, it would lift the pelvis to 1.7 m.
        assert 0.8 < np.median(clip.pelvis_positions[:, 1]) < 1.0


PROBLEMS = {
    "frame_time_23_976": (
        "no two legs are found, from which unit and upward axis are concluded; pass unit= (m, "
        "foot, dm, cmu, inch, cm, mm, or a number of metres) and up= ('y' or 'z')"
    ),
    "mixamo_lying_zup": (
        "stands along y at rest but along z in its frames; pass up='y' if it lies there, or "
        "up='z' if it stands"
    ),
    "no_toes_30fps_lowres": None,
    "not_a_biped": None,
    "one_frame_only": None,
    "rotation_channels_before_position": (
        "no two legs are found, from which unit and upward axis are concluded; pass unit= (m, "
        "foot, dm, cmu, inch, cm, mm, or a number of metres) and up= ('y' or 'z')"
    ),
    "simulation_bone_root": None,
    "traj_frame_time_1s": None,
    "truncated_last_frames": (
        "frame 30 has 92 values, but the hierarchy declares 132 channels; the file was cut short"
    ),
}
"""What is said about each problem; None where it is read."""


@needs_clips
def test_every_problem_is_spoken_of() -> None:
    assert sorted(PROBLEMS) == sorted(
        path.name.removesuffix(".bvh.gz") for path in FOLDER.glob("problems/*.bvh.gz")
    )


@needs_clips
@pytest.mark.parametrize("name", [name for name in PROBLEMS if PROBLEMS[name] is not None])
def test_a_problem_that_cannot_be_read_is_refused_in_one_line(name: str) -> None:
    path = FOLDER / "problems" / f"{name}.bvh.gz"
    with pytest.raises(FileFormatError) as caught:
        load(path)
    line = ":165" if name == "truncated_last_frames" else ""
    assert str(caught.value) == f"{path}{line}: {PROBLEMS[name]}"


def problem(name: str, **known: str | float) -> tuple[Any, Any]:
    return load_with_conclusions(FOLDER / "problems" / f"{name}.bvh.gz", **known)  # type: ignore[arg-type]


@needs_clips
def test_a_frame_time_of_one_second_is_taken_and_doubted() -> None:
    clip, conclusions = problem("traj_frame_time_1s")
    assert (clip.fps, clip.frames, conclusions.unit.value.name) == (1.0, 600, "m")
    assert "THIS IS IMPLAUSIBLE" in conclusions.fps.reason
    assert conclusions.fps.reason in clip.provenance
    assert problem("traj_frame_time_1s", fps=30.0)[0].fps == 30.0


@needs_clips
def test_a_simulation_bone_is_folded_into_the_pelvis() -> None:
    clip, conclusions = problem("simulation_bone_root")
    assert clip.skeleton.names[0] == "Hips"
    assert "SimulationBone" not in clip.skeleton.names
    assert "'SimulationBone' above it carries nothing else" in conclusions.root.reason
    # The bone runs along on the ground; the pelvis is at its own height above it.
    assert 0.7 < np.median(clip.pelvis_positions[:, 1]) < 1.0
    assert np.ptp(clip.pelvis_positions[:, 0]) > 2.0


@needs_clips
def test_a_single_frame_is_a_clip() -> None:
    clip, conclusions = problem("one_frame_only")
    assert (clip.frames, clip.duration, clip.cyclic) == (1, 0.0, False)
    assert (conclusions.unit.value.name, conclusions.up.value) == ("inch", "z")


@needs_clips
def test_a_foot_without_toes_has_the_end_of_its_bone() -> None:
    clip, conclusions = problem("no_toes_30fps_lowres")
    assert conclusions.feet.value[0].toe == "LeftAnkle"
    assert conclusions.floor.value == pytest.approx(0.014, abs=0.001)
    assert conclusions.first_frame.value
    assert clip.fps == 120.0


@needs_clips
def test_a_body_called_an_arm_has_legs_after_all() -> None:
    _, conclusions = problem("not_a_biped")
    assert conclusions.feet.value[0].ankle == "lfoot"
    assert conclusions.unit.value.name == "cm"


@needs_clips
def test_a_body_without_legs_is_read_where_unit_and_axis_are_said() -> None:
    clip, conclusions = problem("frame_time_23_976", unit="cm", up="y")
    assert clip.fps == 23.976
    np.testing.assert_allclose(clip.pelvis_positions[2], [0.02, 0.92, 0.02])
    assert conclusions.feet.value is None
    turned, _ = problem("rotation_channels_before_position", unit="cm", up="y")
    np.testing.assert_allclose(turned.pelvis_positions[0], [0.1, 0.5, -0.2])


@needs_clips
@pytest.mark.parametrize(("up", "height"), [("y", 0.496), ("z", 0.033)])
def test_a_lying_body_is_read_where_the_axis_is_said(up: str, height: float) -> None:
    clip, conclusions = problem("mixamo_lying_zup", up=up)
    assert conclusions.unit.value.name == "cm"
    assert clip.pelvis_positions[0, 1] == pytest.approx(height, abs=0.001)


@needs_clips
def test_a_frame_too_many_is_read_and_told() -> None:
    clip, conclusions = load_with_conclusions(FOLDER / "assimp" / "boxing_toes.bvh.gz")
    assert conclusions.frames.reason == (
        "3070, though the file declares 3069: one whole frame more follows, and is read"
    )
    assert f"frames: {conclusions.frames.reason}" in clip.provenance


@needs_clips
@pytest.mark.parametrize("name", ["pab_walk", "pab_jog", "pab_run", "pab_crossarms"])
def test_hips_that_move_in_the_pelvis_do_not_move_the_feet(name: str) -> None:
    path = FOLDER / "ozz" / f"{name}.bvh.gz"
    clip, conclusions = load_with_conclusions(path)
    assert "both hips stay where the file has them" in conclusions.bones.reason
    assert conclusions.bones.value < 0.04
    rig = parse_bvh(read_bytes(path), path)
    wanted = free_positions(rig)
    _, positions = clip.world_poses()
    for joint in ("LeftFoot", "RightFoot", "LeftFootThumb1", "RightFootThumb1"):
        there = wanted[:, rig.names.index(joint)] * 0.01
        strays = np.linalg.norm(positions[:, clip.skeleton.index(joint)] - there, axis=-1)
        assert strays.max() < 0.004


def free_positions(rig: Any) -> Any:
    """Return where the joints are if each may move in its parent, in the file's unit."""
    from footfall.geometry import multiply, rotate

    rotations = np.array(rig.rotations)
    positions = np.empty((*rotations.shape[:2], 3))
    for joint, parent in enumerate(rig.parents):
        place = rig.translations.get(joint, np.tile(rig.offsets[joint], (rig.frames, 1)))
        if parent < 0:
            positions[:, joint] = place
            continue
        positions[:, joint] = positions[:, parent] + rotate(rotations[:, parent], place)
        rotations[:, joint] = multiply(rotations[:, parent], rotations[:, joint])
    return positions


@needs_clips
@pytest.mark.parametrize("name", ["mass/mass_kick", "ozz/pab_walk", "pybvh/rig_mixed_orders_zup"])
def test_a_real_clip_survives_writing(tmp_path: Path, name: str) -> None:
    clip = load(FOLDER / f"{name}.bvh.gz")
    save_bvh(clip, tmp_path / "copy.bvh", unit="cm")
    read = load(tmp_path / "copy.bvh")
    assert (read.fps, read.cyclic) == (clip.fps, clip.cyclic)
    np.testing.assert_allclose(read.world_poses()[1], clip.world_poses()[1], atol=1e-6)
