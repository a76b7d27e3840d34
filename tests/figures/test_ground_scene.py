from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from footfall.figures.ground_scene import with_ground
from footfall.io import load_gltf, save_gltf
from footfall.io.gltf_document import read_document
from footfall.samples import sample


@pytest.fixture(scope="module")
def scene(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("scene") / "walk.glb"
    save_gltf(sample("walk")[0], path)
    random = np.random.default_rng(3)
    weights = random.uniform(size=(5, 2))
    scene = with_ground(
        path.read_bytes(),
        random.uniform(size=(2, 4, 3)),
        weights,
        np.arange(5) / 2.0,
        (-1.0, -2.0, 0.5),
    )
    path.write_bytes(scene)
    return path


def test_the_character_is_as_it_was(scene: Path) -> None:
    clip, _ = sample("walk")
    back = load_gltf(scene)
    assert back.skeleton.names == clip.skeleton.names
    np.testing.assert_allclose(back.pelvis_positions, clip.pelvis_positions, rtol=0, atol=1e-5)


def test_the_ground_is_a_mesh_whose_heights_move(scene: Path) -> None:
    root = read_document(scene).root.content
    node = next(node for node in root["nodes"] if node["name"] == "ground")
    (primitive,) = root["meshes"][node["mesh"]]["primitives"]
    accessors = root["accessors"]
    assert accessors[primitive["attributes"]["POSITION"]]["count"] == 4 * 3
    assert accessors[primitive["indices"]]["count"] == 3 * 2 * 3 * 2
    assert len(primitive["targets"]) == len(root["meshes"][node["mesh"]]["weights"]) == 2
    animation = root["animations"][0]
    (channel,) = [c for c in animation["channels"] if c["target"]["path"] == "weights"]
    assert root["nodes"][channel["target"]["node"]] == node
    sampler = animation["samplers"][channel["sampler"]]
    assert accessors[sampler["input"]]["count"] == 5
    assert accessors[sampler["output"]]["count"] == 5 * 2
    assert root["nodes"].index(node) in root["scenes"][0]["nodes"]


def test_its_triangles_look_up(scene: Path) -> None:
    document = read_document(scene)
    root = document.root.content
    primitive = root["meshes"][-1]["primitives"][0]

    def numbers(index: int, kind: str) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
        data = document.view_bytes(root["accessors"][index]["bufferView"])
        return np.frombuffer(data, kind).astype(np.float64)

    places = numbers(primitive["attributes"]["POSITION"], "<f4").reshape(-1, 3)
    corners = numbers(primitive["indices"], "<u4").astype(np.int64).reshape(-1, 3)
    assert places.min(axis=0).tolist() == [-1.0, 0.0, -2.0]
    one, two, three = (places[corners[:, corner]] for corner in range(3))
    assert (np.cross(two - one, three - one)[:, 1] > 0.0).all()
