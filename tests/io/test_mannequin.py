"""The mannequin: closed, of the body's own size, and smooth where the spine bends."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests import walking_figure

from footfall.arrays import Floats, Indices, Rotations
from footfall.geometry import from_axis_angle
from footfall.io import load_skinned, save_gltf
from footfall.io.clip_mannequin import clip_mannequin
from footfall.io.mannequin import Mannequin, Tone, mannequin
from footfall.skeleton import Skeleton, find_anatomy, world_poses

NAMES = walking_figure.skeleton().names
SPINE = [NAMES.index(name) for name in ("Spine", "Chest", "Neck", "Head")]
SEGMENTS = 24


def body_of(skeleton: Skeleton) -> Mannequin:
    return mannequin(skeleton, find_anatomy(skeleton))


def torso(body: Mannequin) -> Indices:
    """Return the vertices of the torso's rings, shape (rings, segments)."""
    triangles = body.triangles[body.limbs == body.limbs[0]]
    # The last two are the points that close it.
    used = np.unique(triangles)[:-2]
    return used.reshape(-1, SEGMENTS)


def bent(angle: float, joints: list[int]) -> tuple[Rotations, Floats]:
    """Return the joints of a figure that bows forward, evenly at some joints of its spine."""
    local = np.tile([1.0, 0.0, 0.0, 0.0], (1, len(NAMES), 1))
    local[0, joints] = from_axis_angle(np.array([1.0, 0.0, 0.0]), angle / len(joints))
    rotations, positions = world_poses(walking_figure.skeleton(), np.zeros((1, 3)), local)
    return rotations[0], positions[0]


def test_a_vertex_is_moved_by_two_joints_of_its_own_side_at_most() -> None:
    body = body_of(walking_figure.skeleton())
    parents = walking_figure.skeleton().parents
    assert (body.shares >= 0.0).all()
    assert (body.shares <= 0.5).all()
    shared = body.shares > 0.0
    assert shared.sum() > 8 * SEGMENTS
    pairs = set(zip(body.joints[shared].tolist(), body.others[shared].tolist(), strict=True))
    for joint, other in pairs:
        assert parents[joint] == other or parents[other] == joint
        assert {joint, other} <= {0, *SPINE}
    assert (body.joints == body.others)[~shared].all()


def test_at_rest_nothing_bends() -> None:
    skeleton = walking_figure.skeleton()
    body = body_of(skeleton)
    still = np.tile([1.0, 0.0, 0.0, 0.0], (skeleton.count, 1))
    np.testing.assert_allclose(
        body.placed(still, body.rest), body.positions + body.rest[body.joints], atol=1e-12
    )


@pytest.mark.parametrize("degrees", [0.0, 30.0, 60.0, 90.0])
def test_a_bowed_torso_is_smooth_and_keeps_its_girth(degrees: float) -> None:
    body = body_of(walking_figure.skeleton())
    rings = body.placed(*bent(np.radians(degrees), SPINE[:2]))[torso(body)]
    straight = body.placed(*bent(0.0, SPINE[:2]))[torso(body)]
    centers = rings.mean(axis=1)
    steps = np.diff(centers, axis=0)
    directions = steps / np.linalg.norm(steps, axis=-1, keepdims=True)
    turns = np.arccos(np.clip(np.einsum("ri,ri->r", directions[1:], directions[:-1]), -1.0, 1.0))
    # Evenly: bones that each moved their own piece would turn by half of it from ring to ring.
    assert np.degrees(turns).max() < 7.0 + 0.14 * degrees
    girth, straight_girth = (
        np.linalg.norm(np.roll(each, 1, axis=1) - each, axis=-1).sum(axis=1)
        for each in (rings, straight)
    )
    assert (girth / straight_girth).min() > 0.93


def test_joints_at_the_same_place_count_as_one() -> None:
    plain = walking_figure.skeleton()
    offsets = plain.rest_offsets.copy()
    chest, neck = SPINE[1:3]
    offsets[neck] += offsets[chest]
    offsets[chest] = 0.0
    body = body_of(Skeleton(plain.names, plain.parents, offsets, plain.tip_offsets))
    assert SPINE[0] not in body.joints[torso(body)]
    assert chest in body.joints[torso(body)]


def test_without_a_spine_there_is_a_pelvis() -> None:
    legs = [index for index, name in enumerate(NAMES) if name.endswith(("Leg", "Foot", "Toe"))]
    plain = walking_figure.skeleton()
    kept = [0, *legs]
    places = {joint: index for index, joint in enumerate(kept)}
    parents = np.array([places.get(int(plain.parents[joint]), -1) for joint in kept])
    names = tuple(NAMES[joint] for joint in kept)
    body = body_of(Skeleton(names, parents, plain.rest_offsets[kept]))
    trunk = np.unique(body.triangles[body.tones == Tone.BODY])
    assert 0.08 < np.ptp(body.positions[trunk, 1]) < 0.25
    assert not (body.tones == Tone.FACE).any()


def test_a_neck_that_ends_there_carries_the_head() -> None:
    plain = walking_figure.skeleton()
    head = SPINE[3]
    kept = [joint for joint in range(plain.count) if joint != head]
    places = {joint: index for index, joint in enumerate(kept)}
    parents = np.array([places.get(int(plain.parents[joint]), -1) for joint in kept])
    names = tuple(NAMES[joint] for joint in kept)
    skeleton = Skeleton(names, parents, plain.rest_offsets[kept])
    anatomy = find_anatomy(skeleton)
    body = mannequin(skeleton, anatomy)
    face = np.unique(body.triangles[body.tones == Tone.FACE])
    assert set(body.joints[face].tolist()) == {places[SPINE[2]]}


def test_written_and_read_it_moves_as_it_does_here(tmp_path: Path) -> None:
    clip = walking_figure.walk()
    save_gltf(clip, tmp_path / "walk.glb")
    skin = load_skinned(tmp_path / "walk.glb")
    rotations, positions = bent(np.radians(70.0), SPINE)
    read = skin.vertices(rotations[np.newaxis], positions[np.newaxis])[0]
    ours = clip_mannequin(clip).placed(rotations, positions)
    away = np.linalg.norm(read[:, np.newaxis] - ours, axis=-1)
    # Shares are written in steps of 1/255.
    assert away.min(axis=1).max() < 1e-3
    assert away.min(axis=0).max() < 1e-3
