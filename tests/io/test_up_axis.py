from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.io.small_biped import biped_clip

from footfall.arrays import Rotations
from footfall.errors import FileFormatError
from footfall.geometry import from_axis_angle, multiply, rotate
from footfall.io.up_axis import conclude_up, turned_up
from footfall.motion import Clip
from footfall.skeleton import Skeleton, find_anatomy

FILE = Path("walk.bvh")
Y_TO_Z = from_axis_angle(np.array([1.0, 0.0, 0.0]), np.pi / 2)
Y_TO_X = from_axis_angle(np.array([0.0, 0.0, 1.0]), -np.pi / 2)


def in_other_axes(clip: Clip, turn: Rotations) -> Clip:
    """Return the same motion as a file in other axes has it, at rest too."""
    skeleton = Skeleton(
        clip.skeleton.names, clip.skeleton.parents, rotate(turn, clip.skeleton.rest_offsets)
    )
    back = turn * np.array([1.0, -1.0, -1.0, -1.0])
    rotations = multiply(multiply(turn, clip.local_rotations), back)
    return Clip(skeleton, rotate(turn, clip.pelvis_positions), rotations, clip.fps)


def turned_in_frames(clip: Clip, turn: Rotations) -> Clip:
    """Return the motion turned, and the rest pose left alone."""
    rotations = clip.local_rotations.copy()
    rotations[:, 0] = multiply(turn, rotations[:, 0])
    return clip.evolve(local_rotations=rotations)


def up_of(clip: Clip) -> tuple[str, str]:
    skeleton = clip.skeleton
    found = conclude_up(
        skeleton, find_anatomy(skeleton), clip.pelvis_positions, clip.local_rotations, FILE
    )
    return found.value, found.reason


def test_a_body_that_stands_along_y_is_y_up() -> None:
    assert up_of(biped_clip()) == (
        "y",
        "y: from ankles to head the body stands along it in its frames and at rest",
    )


def test_a_body_that_stands_along_z_is_z_up() -> None:
    assert up_of(in_other_axes(biped_clip(), Y_TO_Z)) == (
        "z",
        "z: from ankles to head the body stands along it in its frames and at rest",
    )


def test_a_rest_pose_along_x_says_nothing() -> None:
    clip = biped_clip()
    lying = Skeleton(
        clip.skeleton.names, clip.skeleton.parents, rotate(Y_TO_X, clip.skeleton.rest_offsets)
    )
    back = Y_TO_X * np.array([1.0, -1.0, -1.0, -1.0])
    rotations = multiply(multiply(Y_TO_X, clip.local_rotations), back)
    rotations[:, 0] = multiply(back, rotations[:, 0])
    moved = Clip(lying, clip.pelvis_positions, rotations, clip.fps)
    assert up_of(moved) == ("y", "y: from ankles to head the body stands along it in its frames")


def test_a_body_that_lies_across_takes_the_axis_of_its_rest() -> None:
    assert up_of(turned_in_frames(biped_clip(), Y_TO_X)) == (
        "y",
        "y: the rest pose stands along it, the frames along no axis",
    )


def test_a_contradiction_is_asked_about() -> None:
    with pytest.raises(FileFormatError) as caught:
        up_of(turned_in_frames(biped_clip(), Y_TO_Z))
    assert str(caught.value) == (
        "walk.bvh: stands along y at rest but along z in its frames; pass up='y' if it lies "
        "there, or up='z' if it stands"
    )


def test_a_body_that_stands_along_no_axis_is_asked_about() -> None:
    with pytest.raises(FileFormatError) as caught:
        up_of(in_other_axes(biped_clip(), Y_TO_X))
    assert str(caught.value) == (
        "walk.bvh: stands along neither y nor z, in its frames or at rest; pass up='y' or up='z'"
    )


def test_turning_up_undoes_the_other_axes() -> None:
    clip = biped_clip()
    other = in_other_axes(clip, Y_TO_Z)
    skeleton, places, rotations = turned_up(
        other.skeleton, other.pelvis_positions, other.local_rotations, "z"
    )
    np.testing.assert_allclose(skeleton.rest_offsets, clip.skeleton.rest_offsets, atol=1e-12)
    np.testing.assert_allclose(places, clip.pelvis_positions, atol=1e-12)
    np.testing.assert_allclose(rotations, clip.local_rotations, atol=1e-12)


def test_y_up_is_left_as_it_is() -> None:
    clip = biped_clip()
    skeleton, places, rotations = turned_up(
        clip.skeleton, clip.pelvis_positions, clip.local_rotations, "y"
    )
    assert skeleton is clip.skeleton
    assert places is clip.pelvis_positions
    assert rotations is clip.local_rotations
