from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.io.small_biped import biped_clip

from footfall.arrays import Floats
from footfall.errors import FileFormatError
from footfall.io.rigid_frames import matrices_of
from footfall.io.scene_nodes import SceneNodes, rig_of_scene, world_matrices

CLIP = biped_clip()
PATH = Path("scene.fbx")


def body(scales: Floats | None = None) -> SceneNodes:
    """Return the biped as a scene, each joint scaled, the places such that nothing moves."""
    count = CLIP.skeleton.count
    scales = np.ones(count) if scales is None else scales
    places = np.broadcast_to(CLIP.skeleton.rest_offsets, (CLIP.frames, count, 3)).copy()
    places[:, 0] = CLIP.pelvis_positions
    above = np.ones(count)
    for joint in range(1, count):
        parent = int(CLIP.skeleton.parents[joint])
        above[joint] = above[parent] * scales[parent]
    matrices = matrices_of(
        CLIP.local_rotations,
        places / above[:, np.newaxis],
        np.broadcast_to(scales[:, np.newaxis], places.shape),
    )
    return SceneNodes(
        CLIP.skeleton.names, CLIP.skeleton.parents, np.ones(count, np.bool_), matrices, 30.0
    )


def beside(nodes: SceneNodes, extra: int) -> SceneNodes:
    """Return a scene with so many more bones, in a chain of their own, before the others."""
    count = len(nodes.names)
    identity = np.broadcast_to(np.eye(4), (CLIP.frames, extra, 4, 4))
    parents = np.concatenate(
        [np.arange(extra) - 1, np.where(nodes.parents < 0, -1, nodes.parents + extra)]
    )
    return SceneNodes(
        (*(f"tail{index}" for index in range(extra)), *nodes.names),
        parents,
        np.ones(count + extra, np.bool_),
        np.concatenate([identity, nodes.matrices], axis=1),
        30.0,
    )


def test_scales_are_multiplied_out() -> None:
    scales = np.linspace(0.5, 2.0, CLIP.skeleton.count)
    rig, told = rig_of_scene(body(scales), PATH)
    assert told == ""
    assert list(rig.translations) == [0]
    np.testing.assert_allclose(rig.translations[0], CLIP.pelvis_positions, atol=1e-12)
    np.testing.assert_allclose(rig.offsets[1:], CLIP.skeleton.rest_offsets[1:], atol=1e-12)
    same = np.abs(np.einsum("tji,tji->tj", rig.rotations, CLIP.local_rotations))
    assert same.min() > 1.0 - 1e-12


def test_of_two_skeletons_the_larger_is_read_and_the_other_told() -> None:
    rig, told = rig_of_scene(beside(body(), 3), PATH)
    assert rig.names == CLIP.skeleton.names
    assert told == ("of 2 skeletons that of 'Hips' is read, which has the most joints, 10")


def test_what_lies_between_two_bones_is_a_joint_too() -> None:
    nodes = body()
    flags = nodes.joints.copy()
    flags[[2, 3]] = False
    rig, _ = rig_of_scene(SceneNodes(nodes.names, nodes.parents, flags, nodes.matrices, 30.0), PATH)
    assert rig.names == CLIP.skeleton.names


def test_a_leaf_that_is_no_bone_is_none() -> None:
    nodes = body()
    flags = nodes.joints.copy()
    flags[1] = False
    rig, _ = rig_of_scene(SceneNodes(nodes.names, nodes.parents, flags, nodes.matrices, 30.0), PATH)
    assert "Head" not in rig.names


def test_a_circle_is_refused() -> None:
    nodes = body()
    parents = nodes.parents.copy()
    parents[0] = 4
    with pytest.raises(FileFormatError) as caught:
        world_matrices(SceneNodes(nodes.names, parents, nodes.joints, nodes.matrices, 30.0), PATH)
    assert str(caught.value) == (
        "scene.fbx: 10 of its 10 nodes hang on each other in a circle; each needs a way up to the "
        "root"
    )


@pytest.mark.parametrize("value", [0.0, np.nan, np.inf])
def test_a_joint_without_size_or_place_is_named(value: float) -> None:
    nodes = body()
    matrices = nodes.matrices.copy()
    matrices[3, 2, :3, 0] = value
    scene = SceneNodes(nodes.names, nodes.parents, nodes.joints, matrices, 30.0)
    with pytest.raises(FileFormatError) as caught, np.errstate(invalid="ignore"):
        rig_of_scene(scene, PATH)
    assert str(caught.value) == (
        "scene.fbx: joint 'LeftUpLeg' has no size or no place in frame 3; its scale must stay "
        "above zero, and its numbers below 1e12"
    )
