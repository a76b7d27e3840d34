from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from tests import walking_figure

from footfall.errors import FileFormatError
from footfall.io.gltf import save_gltf
from footfall.motion import Clip
from footfall.skeleton import Skeleton, world_poses

DTYPES = {5126: "<f4", 5121: "<u1", 5123: "<u2", 5125: "<u4"}
WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class Decoded:
    """A GLB file taken apart by the letter of the specification."""

    def __init__(self, path: Path) -> None:
        data = path.read_bytes()
        magic, version, length = struct.unpack_from("<4sII", data)
        assert (magic, version, length) == (b"glTF", 2, len(data))
        size, kind = struct.unpack_from("<I4s", data, 12)
        assert kind == b"JSON"
        assert size % 4 == 0
        self.document: dict[str, Any] = json.loads(data[20 : 20 + size])
        rest, kind = struct.unpack_from("<I4s", data, 20 + size)
        assert kind == b"BIN\0"
        self.buffer = data[28 + size :]
        assert rest == len(self.buffer) == self.document["buffers"][0]["byteLength"]

    def array(self, accessor: int) -> npt.NDArray[Any]:
        record = self.document["accessors"][accessor]
        view = self.document["bufferViews"][record["bufferView"]]
        width = WIDTHS[record["type"]]
        flat = np.frombuffer(
            self.buffer,
            DTYPES[record["componentType"]],
            record["count"] * width,
            view["byteOffset"],
        )
        return flat.reshape(record["count"], width)

    @property
    def animation(self) -> dict[str, Any]:
        return self.document["animations"][0]

    def channel(self, node: int, path: str) -> npt.NDArray[Any]:
        for channel in self.animation["channels"]:
            if channel["target"] == {"node": node, "path": path}:
                return self.array(self.animation["samplers"][channel["sampler"]]["output"])
        raise AssertionError(f"node {node} has no {path}")


@pytest.fixture(scope="module")
def decoded(tmp_path_factory: pytest.TempPathFactory) -> Decoded:
    path = tmp_path_factory.mktemp("gltf") / "walk.glb"
    save_gltf(walking_figure.walk(), path, supports=walking_figure.supports())
    return Decoded(path)


def test_played_back_every_joint_is_where_the_clip_has_it(decoded: Decoded) -> None:
    clip = walking_figure.walk()
    nodes = decoded.document["nodes"]
    rotations = np.stack(
        [np.roll(decoded.channel(j, "rotation"), 1, axis=-1) for j in range(clip.skeleton.count)],
        axis=1,
    )
    parents = np.full(clip.skeleton.count, -1)
    for index, node in enumerate(nodes):
        parents[node.get("children", [])] = index
    read = Skeleton(
        tuple(node["name"] for node in nodes[: clip.skeleton.count]),
        parents,
        np.array([[0.0, 0.0, 0.0], *(n["translation"] for n in nodes[1 : clip.skeleton.count])]),
    )
    places = decoded.channel(0, "translation").astype(np.float64)
    _, positions = world_poses(read, places, rotations.astype(np.float64))
    assert read.names == clip.skeleton.names
    np.testing.assert_allclose(positions, clip.world_poses()[1], atol=1e-5)


def test_the_keys_are_one_a_frame_and_linear(decoded: Decoded) -> None:
    assert {s["interpolation"] for s in decoded.animation["samplers"]} == {"LINEAR"}
    times = decoded.array(decoded.animation["samplers"][0]["input"])[:, 0]
    np.testing.assert_allclose(times, np.arange(67) / 60.0, rtol=1e-6)


def test_quaternions_never_change_sign_between_frames(tmp_path: Path) -> None:
    clip = walking_figure.walk()
    signs = np.where(np.arange(clip.frames) % 2, -1.0, 1.0)[:, np.newaxis, np.newaxis]
    save_gltf(clip.evolve(local_rotations=clip.local_rotations * signs), tmp_path / "walk.glb")
    read = Decoded(tmp_path / "walk.glb")
    for joint in range(clip.skeleton.count):
        keys = read.channel(joint, "rotation")
        assert np.einsum("ti,ti->t", keys[1:], keys[:-1]).min() > 0.9


def test_the_skin_lies_around_the_skeleton(decoded: Decoded) -> None:
    skin = decoded.document["skins"][0]
    inverse = decoded.array(skin["inverseBindMatrices"]).reshape(-1, 4, 4)
    for primitive in decoded.document["meshes"][0]["primitives"]:
        attributes = primitive["attributes"]
        places = decoded.array(attributes["POSITION"])
        joints = decoded.array(attributes["JOINTS_0"])
        weights = decoded.array(attributes["WEIGHTS_0"])
        np.testing.assert_array_equal(weights.sum(axis=1, dtype=np.int64), 255)
        assert (weights[:, 0] >= weights[:, 1]).all()
        assert not weights[:, 2:].any()
        assert not joints[weights == 0].any()
        local = places + inverse[joints[:, 0], 3, :3]
        assert np.linalg.norm(local, axis=-1).max() < 0.55
        assert decoded.array(primitive["indices"]).max() == len(places) - 1


def test_the_two_feet_are_painted_differently(decoded: Decoded) -> None:
    names = [material["name"] for material in decoded.document["materials"]]
    assert names == ["body", "face", "left", "right", "left_foot", "right_foot"]
    colors = {
        tuple(m["pbrMetallicRoughness"]["baseColorFactor"]) for m in decoded.document["materials"]
    }
    assert len(colors) == 6


def test_the_supports_travel_with_the_animation(decoded: Decoded) -> None:
    facts = {"fps": 60.0, "cyclic": False, "supports": walking_figure.supports()}
    assert decoded.animation["extras"] == {"footfall": facts}


def test_a_body_without_legs_is_written_all_the_same(tmp_path: Path) -> None:
    arm = Skeleton(("base", "mid", "end"), np.array([-1, 0, 1]), np.eye(3) * 0.2 * (0, 1, 1))
    turned = np.tile([1.0, 0.0, 0.0, 0.0], (2, 3, 1))
    save_gltf(Clip(arm, np.zeros((2, 3)), turned, 30.0), tmp_path / "arm.glb")
    names = [m["name"] for m in Decoded(tmp_path / "arm.glb").document["materials"]]
    assert names == ["body"]


def test_a_joint_named_like_the_mesh_keeps_its_name(tmp_path: Path) -> None:
    body = Skeleton(("mannequin",), np.array([-1]), np.zeros((1, 3)))
    clip = Clip(body, np.zeros((2, 3)), np.tile([1.0, 0.0, 0.0, 0.0], (2, 1, 1)), 30.0)
    save_gltf(clip, tmp_path / "one.glb")
    names = [node["name"] for node in Decoded(tmp_path / "one.glb").document["nodes"]]
    assert names == ["mannequin", "mannequin_"]


def test_the_same_clip_gives_the_same_bytes(tmp_path: Path) -> None:
    save_gltf(walking_figure.walk(), tmp_path / "one.glb")
    save_gltf(walking_figure.walk(), tmp_path / "other.glb")
    assert (tmp_path / "one.glb").read_bytes() == (tmp_path / "other.glb").read_bytes()


def test_nothing_is_written_into_a_missing_folder(tmp_path: Path) -> None:
    with pytest.raises(FileFormatError, match="there is no folder"):
        save_gltf(walking_figure.walk(), tmp_path / "missing" / "walk.glb")
    assert list(tmp_path.iterdir()) == []
