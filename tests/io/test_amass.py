from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.io.small_files import model_bytes, smpl_clip

from footfall.errors import ArgumentError, FileFormatError
from footfall.geometry import from_euler, from_rotation_vector, to_rotation_vector
from footfall.io import load, load_amass, load_with_conclusions, save, save_amass, save_native
from footfall.io.smpl_bodies import SMPL_TREES, approximate_joints
from footfall.skeleton import find_anatomy


@pytest.mark.parametrize("model", sorted(SMPL_TREES))
def test_what_is_written_comes_back(tmp_path: Path, model: str) -> None:
    clip = smpl_clip(model)
    save(clip, tmp_path / "a.amass.npz")
    read = load(tmp_path / "a.amass.npz")
    assert read.fps == 60.0
    order = [read.skeleton.index(name) for name in clip.skeleton.names]
    np.testing.assert_allclose(read.world_poses()[1][:, order], clip.world_poses()[1], atol=1e-9)
    save(read, tmp_path / "b.amass.npz")
    again = load(tmp_path / "b.amass.npz")
    np.testing.assert_allclose(again.world_poses()[1], read.world_poses()[1], atol=1e-9)


def stored(path: Path, **changes: Any) -> Path:
    """Write a motion as AMASS does, z up, walking along x; return its path."""
    poses = np.zeros((4, 156))
    # Upright in a world whose z points up: the pelvis' own y turned to z.
    poses[:, 0] = np.pi / 2.0
    places = np.array([[0.1 * frame, 0.0, 0.9] for frame in range(4)])
    arrays: dict[str, Any] = {
        "poses": poses,
        "trans": places,
        "betas": np.array([0.0, 2.0]),
        "mocap_framerate": np.array(120.0),
        "gender": np.array("neutral"),
    } | changes
    np.savez(path, **{name: array for name, array in arrays.items() if array is not None})
    return path


def test_without_a_model_a_labelled_approximate_body_stands_on_the_floor(tmp_path: Path) -> None:
    clip, conclusions = load_with_conclusions(stored(tmp_path / "a.npz"))
    assert (clip.fps, conclusions.up.value) == (120.0, "z")
    assert any("AN APPROXIMATE BODY of 1.7 m" in sentence for sentence in clip.provenance)
    positions = clip.world_poses()[1]
    assert positions[..., 1].min() == pytest.approx(0.012 * 1.7)
    assert positions[..., 1].max() == pytest.approx(0.936 * 1.7, abs=0.1)
    np.testing.assert_allclose(np.diff(clip.pelvis_positions[:, 0]), 0.1)
    find_anatomy(clip.skeleton)


def test_with_the_users_model_the_joints_are_that_persons(tmp_path: Path) -> None:
    (tmp_path / "model.npz").write_bytes(model_bytes("SMPL-H"))
    clip = load(stored(tmp_path / "a.npz"), body=tmp_path / "model.npz")
    joints = approximate_joints("SMPL-H") * (1.1 + 2.0 * 0.1 * 1.1)
    wanted = joints - joints[0] + [0.0, 0.9, 0.0]
    order = [clip.skeleton.index(name) for name in SMPL_TREES["SMPL-H"]]
    np.testing.assert_allclose(clip.world_poses()[1][0, order], wanted, atol=1e-9)
    assert "from model.npz" in clip.provenance[-1]


def test_a_world_whose_y_points_up_is_seen(tmp_path: Path) -> None:
    path = stored(tmp_path / "a.npz", poses=np.zeros((4, 66)))
    clip, conclusions = load_with_conclusions(path)
    assert conclusions.up.reason == "y: the pelvis stands along it"
    assert np.ptp(clip.world_poses()[1][0, :, 1]) > 1.4


def test_all_arrays_may_be_in_single_precision(tmp_path: Path) -> None:
    poses = np.zeros((4, 72), dtype=np.float32)
    assert load(stored(tmp_path / "a.npz", poses=poses)).skeleton.count == 24


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"poses": np.zeros((4, 155))}, "its poses have shape (4, 155); (frames, 66 (SMPL body), "),
        ({"trans": np.zeros((3, 3))}, "its trans has shape (3, 3); 4 poses need (4, 3)"),
        ({"trans": np.full((4, 3), np.nan)}, "trans of frame 0 holds what is no finite number"),
        ({"mocap_framerate": None}, "says no frame rate (mocap_framerate or mocap_frame_rate)"),
        ({"mocap_framerate": np.array(0.0)}, "mocap_framerate is 0; it must be > 0"),
        (
            {"poses": np.zeros((4, 72), dtype=int)},
            "is no motion of AMASS: it has no numbers 'poses'",
        ),
        ({"footfall_joints": np.zeros((2, 3))}, "its footfall_joints are no places of its joints"),
    ],
)
def test_a_fault_is_named(tmp_path: Path, changes: dict[str, Any], message: str) -> None:
    path = stored(tmp_path / "a.npz", **changes)
    with pytest.raises(FileFormatError) as caught:
        load_amass(path)
    assert str(caught.value).startswith(f"{path}: {message}")


def test_the_rate_can_be_said_where_the_file_does_not(tmp_path: Path) -> None:
    assert load(stored(tmp_path / "a.npz", mocap_framerate=None), fps=50.0).fps == 50.0


def test_a_model_of_other_joints_is_refused(tmp_path: Path) -> None:
    path, model = stored(tmp_path / "a.npz"), tmp_path / "model.npz"
    model.write_bytes(model_bytes("SMPL"))
    with pytest.raises(FileFormatError, match="is no model of the SMPL-H joints that the motion"):
        load(path, body=model)
    with pytest.raises(FileFormatError, match="is a pickle, which could run any program"):
        load(path, body=tmp_path / "model.pkl")
    save_native(smpl_clip(), tmp_path / "b.npz")
    with pytest.raises(FileFormatError, match="is no body model: it has no numbers 'J_regressor'"):
        load(path, body=tmp_path / "b.npz")
    with pytest.raises(ArgumentError, match="knows its body"):
        load(tmp_path / "b.npz", body=model)


def test_another_body_is_not_written(tmp_path: Path) -> None:
    clip = smpl_clip()
    names = ("hips", *clip.skeleton.names[1:])
    body = type(clip.skeleton)(names, clip.skeleton.parents, clip.skeleton.rest_offsets)
    with pytest.raises(FileFormatError, match="retarget the motion onto it first"):
        save_amass(clip.evolve(skeleton=body), tmp_path / "a.npz")


def test_python_objects_are_never_unpacked(tmp_path: Path) -> None:
    packed = io.BytesIO()
    np.savez(packed, poses=np.array([print], dtype=object), trans=np.zeros((1, 3)))
    (tmp_path / "a.npz").write_bytes(packed.getvalue())
    with pytest.raises(FileFormatError, match="it has no numbers 'poses'"):
        load(tmp_path / "a.npz")


@pytest.mark.parametrize("angle", [0.0, 1e-9, 0.5, 3.0, np.pi - 1e-9, np.pi])
def test_rotation_vectors_are_axes_times_angles(angle: float) -> None:
    turned = from_rotation_vector(np.array([0.0, angle, 0.0]))
    np.testing.assert_allclose(turned, from_euler("Y", np.array([angle])), atol=1e-15)
    np.testing.assert_allclose(to_rotation_vector(-turned), [0.0, angle, 0.0], atol=1e-15)
