from __future__ import annotations

import numpy as np
import pytest
from tests import walking_figure

from footfall.arrays import Floats
from footfall.geometry import conjugate, from_axis_angle, multiply, rotate
from footfall.motion import Clip, mirror
from footfall.motion.mirror_frames import frame_reflections, mirrored_joints
from footfall.skeleton import Anatomy, Skeleton, find_anatomy

MIRROR = np.array([-1.0, 1.0, 1.0])


def lively() -> Clip:
    """Return a walk that turns and leans, so that nothing is symmetric by chance."""
    walk = walking_figure.walk(frames=34, fps=30.0)
    random = np.random.default_rng(7)
    rotations = walk.local_rotations.copy()
    for joint in range(walk.skeleton.count):
        axis = random.normal(size=3)
        angles: Floats = 0.2 * np.sin(np.arange(34) / 5.0 + random.uniform(0.0, 6.0))
        turn = from_axis_angle(axis / np.linalg.norm(axis), angles)
        rotations[:, joint] = multiply(rotations[:, joint], turn)
    pelvis = walk.pelvis_positions + np.array([0.4, 0.0, 0.0])
    return walk.evolve(pelvis_positions=pelvis, local_rotations=rotations)


WALK = lively()
ANATOMY = find_anatomy(WALK.skeleton)


def reframed(clip: Clip, frames: Floats) -> Clip:
    """Return the same motion on a skeleton whose joints' frames are turned by `frames`."""
    world, _ = clip.world_poses()
    parents = clip.skeleton.parents
    turned = multiply(world, frames)
    local = turned.copy()
    local[:, 1:] = multiply(conjugate(turned[:, parents[1:]]), turned[:, 1:])
    offsets = clip.skeleton.rest_offsets.copy()
    offsets[1:] = rotate(conjugate(frames[parents[1:]]), offsets[1:])
    tips = rotate(conjugate(frames), clip.skeleton.tip_offsets)
    body = Skeleton(clip.skeleton.names, parents, offsets, tips)
    return clip.evolve(skeleton=body, local_rotations=local)


def error(clip: Clip, anatomy: Anatomy) -> float:
    partners = mirrored_joints(clip.skeleton, anatomy)
    _, positions = clip.world_poses()
    _, mirrored = mirror(clip, anatomy).world_poses()
    return float(np.linalg.norm(mirrored - positions[:, partners] * MIRROR, axis=-1).max())


def test_joints_are_paired_by_side() -> None:
    names = WALK.skeleton.names
    partners = mirrored_joints(WALK.skeleton, ANATOMY)
    for joint, name in enumerate(names):
        swapped = name.replace("Left", "*").replace("Right", "Left").replace("*", "Right")
        assert names[partners[joint]] == swapped


def test_joints_that_names_leave_over_are_paired_by_their_place() -> None:
    names = list(WALK.skeleton.names)
    names[names.index("LeftShoulder")] = "LeftShoulder1"
    names[names.index("LeftHand")] = "LeftPalm"
    body = Skeleton(tuple(names), WALK.skeleton.parents, WALK.skeleton.rest_offsets)
    partners = mirrored_joints(body, find_anatomy(body))
    assert partners.tolist() == mirrored_joints(WALK.skeleton, ANATOMY).tolist()


def test_on_a_body_of_equal_sides_it_is_the_mirror_image() -> None:
    assert error(WALK, ANATOMY) < 1e-9


def test_mirroring_twice_gives_the_clip_back() -> None:
    twice = mirror(mirror(WALK, ANATOMY), ANATOMY)
    np.testing.assert_allclose(twice.pelvis_positions, WALK.pelvis_positions, atol=1e-12)
    agreement = np.einsum("fji,fji->fj", twice.local_rotations, WALK.local_rotations)
    np.testing.assert_allclose(np.abs(agreement), 1.0, atol=1e-12)


def test_frames_that_are_equal_on_both_sides_are_understood() -> None:
    """All bones along x on both sides, as in files written by some capture systems."""
    frames = np.tile([1.0, 0.0, 0.0, 0.0], (WALK.skeleton.count, 1))
    down = from_axis_angle(np.array([0.0, 0.0, 1.0]), -np.pi / 2)
    for joint, name in enumerate(WALK.skeleton.names):
        if name.endswith(("Leg", "Foot", "Toe")):
            frames[joint] = down
        elif name.startswith("Right") or name in ("Spine", "Chest", "Neck", "Head"):
            frames[joint] = from_axis_angle(np.array([0.0, 1.0, 0.0]), np.pi)
    clip = reframed(WALK, frames)
    assert error(clip, ANATOMY) < 1e-9


@pytest.mark.parametrize("seed", range(5))
def test_frames_turned_anyhow_are_understood(seed: int) -> None:
    frames = np.random.default_rng(seed).normal(size=(WALK.skeleton.count, 4))
    frames /= np.linalg.norm(frames, axis=-1, keepdims=True)
    clip = reframed(walking_figure.walk(frames=34, fps=30.0), frames)
    assert error(clip, ANATOMY) < 1e-3
    twice = mirror(mirror(clip, ANATOMY), ANATOMY)
    np.testing.assert_allclose(twice.world_poses()[1], clip.world_poses()[1], atol=1e-3)


def test_reflections_are_reflections_and_undo_each_other() -> None:
    partners = mirrored_joints(WALK.skeleton, ANATOMY)
    reflections = frame_reflections(WALK.skeleton, WALK.local_rotations, partners)
    for joint, reflection in enumerate(reflections):
        assert np.linalg.det(reflection) == pytest.approx(-1.0)
        product = reflections[partners[joint]] @ reflection
        np.testing.assert_allclose(product, np.eye(3), atol=1e-12)


def test_a_stray_helper_does_not_turn_the_head() -> None:
    skeleton = WALK.skeleton
    body = Skeleton(
        (*skeleton.names, "Neck_MESH"),
        np.append(skeleton.parents, skeleton.index("Neck")),
        np.vstack([skeleton.rest_offsets, [0.5, 0.3, -0.4]]),
    )
    still = np.tile([1.0, 0.0, 0.0, 0.0], (WALK.frames, 1, 1))
    rotations = np.concatenate([WALK.local_rotations, still], axis=1)
    clip = WALK.evolve(skeleton=body, local_rotations=rotations)
    plain, _ = mirror(WALK, ANATOMY).world_poses()
    helped, _ = mirror(clip, find_anatomy(body)).world_poses()
    head = skeleton.index("Head")
    agreement = np.einsum("fi,fi->f", plain[:, head], helped[:, head])
    np.testing.assert_allclose(np.abs(agreement), 1.0, atol=1e-12)


def test_where_the_legs_differ_the_ankles_are_still_mirrored() -> None:
    offsets = WALK.skeleton.rest_offsets.copy()
    offsets[WALK.skeleton.index("LeftLeg"), 1] -= 0.015
    body = Skeleton(WALK.skeleton.names, WALK.skeleton.parents, offsets)
    clip = WALK.evolve(skeleton=body)
    _, positions = clip.world_poses()
    _, mirrored = mirror(clip, ANATOMY).world_poses()
    left, right = ANATOMY.left.ankle, ANATOMY.right.ankle
    assert np.abs(mirrored[:, right] - positions[:, left] * MIRROR).max() < 1e-3
    assert np.abs(mirrored[:, left] - positions[:, right] * MIRROR).max() < 1e-3


def test_it_says_what_was_done() -> None:
    assert mirror(WALK, ANATOMY).provenance == ("mirrored: 8 pairs of joints were exchanged",)
