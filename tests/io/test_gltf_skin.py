# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false
# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false
# pyright: reportUnknownParameterType=false, reportMissingTypeStubs=false
from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.io.small_biped import biped_clip
from tests.io.small_gltf import SmallGltf
from tests.io.test_gltf_clip import moving
from tests.oracles.slow_gltf import SlowGltf

from footfall.errors import ArgumentError, ClipError, FileFormatError
from footfall.io import load, load_skinned, save_gltf, save_skinned
from footfall.io.gltf_buffers import glb_bytes

PLACES = np.array([[0.1, 0, 0.9], [0.12, 0.02, 0.5], [-0.1, 0, 0.1], [0, 0, 1.2]]) * 100.0
JOINTS = np.array([[0, 1, 0, 0], [1, 2, 3, 0], [4, 5, 6, 0], [7, 8, 0, 0]])
WEIGHTS = np.array(
    [[0.5, 0.5, 0, 0], [0.3, 0.3, 0.3, 0.1], [2, 1, 1, 0], [0, 0, 0, 0]], dtype=np.float64
)


def skinned(folder: Path) -> Path:
    """Write a character that moves, its skin bound in its own centimetres; return its path."""
    small = moving()
    slow_path = small.write(folder / "plain.glb")
    slow = SlowGltf(slow_path)
    inverse = [np.linalg.inv(slow.world(node, {})) @ slow.world(0, {}) for node in range(1, 10)]
    document = small.document
    document["nodes"].append({"name": "Skin", "mesh": 0, "skin": 0, "translation": [9, 9, 9]})
    document["nodes"][0]["children"].append(10)
    document["nodes"].append(
        {"name": "Hat", "mesh": 1, "translation": [0, 0, 20], "scale": [2, 2, 2]}
    )
    document["nodes"][9]["children"] = [11]
    stored = np.array(inverse).transpose(0, 2, 1)
    document["skins"] = [
        {
            "joints": list(range(1, 10)),
            "inverseBindMatrices": small.buffers.add(stored.reshape(-1, 4, 4), "f4"),
        }
    ]
    attributes = {
        "POSITION": small.buffers.add(PLACES, "f4", bounds=True, target=34962),
        "JOINTS_0": small.buffers.add(JOINTS, "u1", target=34962),
        "WEIGHTS_0": small.buffers.add(WEIGHTS, "f4", target=34962),
    }
    corners = small.buffers.add(np.array([0, 1, 2, 1, 2, 3]), "u2", target=34963)
    hat = {"POSITION": small.buffers.add(PLACES[:3] * 0.1, "f4", bounds=True, target=34962)}
    document["materials"] = [
        {"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1.0, 0.2, 0.1, 1.0]}}
    ]
    document["meshes"] = [
        {"primitives": [{"attributes": attributes, "indices": corners, "material": 0}]},
        {"primitives": [{"attributes": hat}]},
    ]
    return small.write(folder / "character.glb")


def by_the_letter(path: Path, animation: int | None, time: float) -> Any:
    """Return the vertices in the world, matrix by matrix, shape (7, 3)."""
    slow = SlowGltf(path)
    moved = slow.properties(animation, time)
    skin = slow.document["skins"][0]
    binds = slow.array(skin["inverseBindMatrices"]).reshape(-1, 4, 4).transpose(0, 2, 1)
    shares = np.where(WEIGHTS.sum(axis=1, keepdims=True) > 0, WEIGHTS, [1, 0, 0, 0])
    shares = shares / shares.sum(axis=1, keepdims=True)
    places = []
    for place, joints, weights in zip(PLACES, JOINTS, shares, strict=True):
        matrix = sum(
            weight * slow.world(skin["joints"][joint], moved) @ binds[joint]
            for joint, weight in zip(joints, weights, strict=True)
        )
        places.append((matrix @ np.append(place, 1.0))[:3])
    places += [(slow.world(11, moved) @ np.append(0.1 * one, 1.0))[:3] for one in PLACES[:3]]
    return np.array(places)


def test_the_skin_follows_the_joints(tmp_path: Path) -> None:
    path = skinned(tmp_path)
    body = load_skinned(path)
    clip = load(path)
    vertices = body.vertices(*clip.world_poses())
    for frame in (0, 7, 15, 30):
        np.testing.assert_allclose(vertices[frame], by_the_letter(path, 0, frame / 30.0), atol=2e-6)
    assert body.weights.sum(axis=1) == pytest.approx(1.0)
    assert body.triangles.tolist() == [[0, 1, 2], [1, 2, 3], [4, 5, 6]]
    np.testing.assert_allclose(body.colors[[0, 6]], [[1.0, 0.2, 0.1], [1.0, 1.0, 1.0]])


def test_a_character_is_written_with_other_animations(tmp_path: Path) -> None:
    path = skinned(tmp_path)
    body = load_skinned(path)
    clip = load(path)
    there = clip.pelvis_positions + np.linspace(0, 1, clip.frames)[:, np.newaxis] * [0.5, 0, 2.0]
    along = clip.evolve(pelvis_positions=there, name="along")
    save_skinned(body, [along, clip], tmp_path / "out.glb", supports=["D" * clip.frames, None])
    written = SlowGltf(tmp_path / "out.glb").document
    assert [one["name"] for one in written["animations"]] == ["along", "move"]
    assert written["animations"][0]["extras"]["footfall"]["supports"] == "D" * clip.frames
    assert written["materials"] == body.document.root.content["materials"]
    for number, one in enumerate((along, clip)):
        read = load(tmp_path / "out.glb", animation=number)
        np.testing.assert_allclose(read.world_poses()[1], one.world_poses()[1], atol=5e-6)
        again = load_skinned(tmp_path / "out.glb")
        np.testing.assert_allclose(
            again.vertices(*read.world_poses()), body.vertices(*one.world_poses()), atol=5e-6
        )


def test_its_own_animations_stay_where_that_is_wanted(tmp_path: Path) -> None:
    path = skinned(tmp_path)
    clip = load(path)
    save_skinned(load_skinned(path), [clip.evolve(name="new")], tmp_path / "out.glb", keep=True)
    np.testing.assert_allclose(
        load(f"{tmp_path / 'out.glb'}#move").world_poses()[1], clip.world_poses()[1], atol=5e-6
    )


def test_the_mannequin_of_our_own_files_is_a_skin(tmp_path: Path) -> None:
    clip = biped_clip()
    save_gltf(clip, tmp_path / "a.glb")
    body = load_skinned(tmp_path / "a.glb")
    vertices = body.vertices(*load(tmp_path / "a.glb").world_poses())
    assert vertices.shape[0] == clip.frames
    assert np.ptp(vertices[0, :, 1]) > 1.2
    body.check(clip)


def test_a_clip_of_another_body_is_refused(tmp_path: Path) -> None:
    path = skinned(tmp_path)
    body, clip = load_skinned(path), load(path)
    with pytest.raises(ClipError) as caught:
        save_skinned(body, [biped_clip()], tmp_path / "out.glb")
    assert str(caught.value) == (
        f"clip {biped_clip().name!r} moves Hips, Head, LeftUpLeg, LeftLeg, LeftFoot, ..., but "
        "character.glb has Hips, LeftUpLeg, LeftLeg, LeftFoot, RightUpLeg, ...; retarget the clip "
        "onto it first"
    )
    longer = clip.skeleton.rest_offsets * np.array([1.0, 1.2, 1.0])
    other = clip.evolve(
        skeleton=type(clip.skeleton)(clip.skeleton.names, clip.skeleton.parents, longer)
    )
    with pytest.raises(ClipError, match=r"has 'LeftLeg' 84\.0 mm from where character\.glb has it"):
        body.check(other)
    with pytest.raises(ArgumentError, match="there are no clips to write"):
        save_skinned(body, [], tmp_path / "out.glb")
    with pytest.raises(ArgumentError, match="2 texts of supports for 1 clips"):
        save_skinned(body, [clip], tmp_path / "out.glb", supports=["D", "D"])
    assert not (tmp_path / "out.glb").exists()


def test_a_joint_moved_a_little_in_its_parent_is_written_there(tmp_path: Path) -> None:
    path = skinned(tmp_path)
    body, clip = load_skinned(path), load(path)
    offsets = clip.skeleton.rest_offsets + np.array([0.0, 0.004, 0.003])
    offsets[0] = 0.0
    moved = clip.evolve(
        skeleton=type(clip.skeleton)(clip.skeleton.names, clip.skeleton.parents, offsets)
    )
    save_skinned(body, [moved], tmp_path / "out.glb")
    read = load(tmp_path / "out.glb")
    np.testing.assert_allclose(read.world_poses()[1], moved.world_poses()[1], atol=5e-6)


def test_a_file_without_a_skin_is_refused(tmp_path: Path) -> None:
    path = moving().write(tmp_path / "a.glb")
    with pytest.raises(FileFormatError) as caught:
        load_skinned(path)
    assert str(caught.value) == f"{path}: has no mesh on its joints; there is no skin"


def test_images_beside_a_character_are_taken_in(tmp_path: Path) -> None:
    path = skinned(tmp_path)
    slow = SlowGltf(path)
    (tmp_path / "skin.png").write_bytes(b"\x89PNG\r\n\x1a\n123")
    slow.document["images"] = [{"uri": "skin.png"}]
    path.write_bytes(glb_bytes(slow.document, slow.buffer))
    save_skinned(load_skinned(path), [load(path)], tmp_path / "out.glb")
    written = SlowGltf(tmp_path / "out.glb")
    image = written.document["images"][0]
    view = written.document["bufferViews"][image["bufferView"]]
    assert image["mimeType"] == "image/png"
    assert written.buffer[view["byteOffset"] :][:11] == b"\x89PNG\r\n\x1a\n123"


def test_a_rig_without_inverse_matrices_is_bound_as_it_stands(tmp_path: Path) -> None:
    small = SmallGltf()
    place = small.buffers.add(np.eye(3), "f4", bounds=True)
    joints = small.buffers.add(np.zeros((3, 4)), "u1")
    weights = small.buffers.add(np.tile([1.0, 0, 0, 0], (3, 1)), "f4")
    attributes = {"POSITION": place, "JOINTS_0": joints, "WEIGHTS_0": weights}
    small.document["meshes"] = [{"primitives": [{"attributes": attributes}]}]
    small.document["nodes"].append({"mesh": 0, "skin": 0})
    small.document["skins"] = [{"joints": list(range(1, 10))}]
    body = load_skinned(small.write(tmp_path / "a.glb"))
    clip = load(tmp_path / "a.glb")
    vertices = body.vertices(*clip.world_poses())[0]
    np.testing.assert_allclose(
        vertices, [[0.01, 0.95, 0], [0, 0.95, -0.01], [0, 0.96, 0]], atol=1e-9
    )
