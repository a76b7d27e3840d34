from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest
from tests.oracles.slow_kinematics import joint_frames

from footfall.arrays import Positions, Rotations
from footfall.errors import ClipError
from footfall.geometry import from_yaw
from footfall.motion import Clip
from footfall.skeleton import Skeleton

BODY = Skeleton(
    ("Hips", "Thigh", "Shank"),
    np.array([-1, 0, 1]),
    np.array([[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, -0.4, 0.0]]),
)
POSITIONS = np.linspace([0.0, 0.9, 0.0], [0.0, 0.9, 1.0], 5)
ROTATIONS = np.stack([from_yaw(np.linspace(0.0, 0.1 * joint, 5)) for joint in range(3)], axis=1)


def clip(
    positions: Positions = POSITIONS,
    rotations: Rotations = ROTATIONS,
    fps: float = 30.0,
    cyclic: bool = False,
) -> Clip:
    return Clip(BODY, positions, rotations, fps, cyclic, "walk")


def test_a_clip_lasts_from_its_first_to_its_last_frame() -> None:
    assert clip().frames == 5
    assert clip(fps=120.0).duration == 4 / 120
    assert clip(POSITIONS[:1], ROTATIONS[:1]).duration == 0.0


def test_world_poses_are_those_of_forward_kinematics() -> None:
    _, positions = clip().world_poses()
    for frame in range(5):
        _, expected = joint_frames(BODY, POSITIONS[frame], ROTATIONS[frame])
        np.testing.assert_allclose(positions[frame], expected, rtol=0, atol=1e-14)


def test_what_a_clip_holds_cannot_be_changed() -> None:
    positions = POSITIONS.copy()
    kept = clip(positions)
    positions[0] = 9.0
    np.testing.assert_array_equal(kept.pelvis_positions, POSITIONS)
    for array in (kept.pelvis_positions, kept.local_rotations):
        assert not array.flags.writeable
    with pytest.raises(dataclasses.FrozenInstanceError):
        kept.fps = 1.0  # pyright: ignore[reportAttributeAccessIssue]


def test_a_clip_evolves_into_another_and_says_why() -> None:
    first = clip()
    second = first.evolve(because="played at 60 frames per second", fps=60.0)
    third = second.evolve(because="renamed", name="stroll")
    assert (second.fps, second.name) == (60.0, "walk")
    assert third.provenance == ("played at 60 frames per second", "renamed")
    assert third.evolve(cyclic=True).provenance == third.provenance
    assert (first.fps, first.provenance) == (30.0, ())


def test_what_a_clip_evolves_into_is_checked_too() -> None:
    with pytest.raises(ClipError) as caught:
        clip().evolve(fps=-1.0)
    assert str(caught.value) == "clip 'walk' has -1.0 frames per second; it must be > 0"


def changed(array: Positions, index: tuple[int, ...], number: float) -> Positions:
    result = array.copy()
    result[index] = number
    return result


@pytest.mark.parametrize(
    ("positions", "rotations", "message"),
    [
        (np.zeros((0, 3)), np.zeros((0, 3, 4)), "clip 'walk' has no frames"),
        (
            POSITIONS[:, :2],
            ROTATIONS,
            "clip 'walk': pelvis positions of shape (5, 2); (frames, 3) is needed",
        ),
        (
            POSITIONS,
            ROTATIONS[:4],
            "clip 'walk': rotations of shape (4, 3, 4); 5 frames of 3 joints need (5, 3, 4)",
        ),
        (
            POSITIONS,
            ROTATIONS[:, :2],
            "clip 'walk': rotations of shape (5, 2, 4); 5 frames of 3 joints need (5, 3, 4)",
        ),
        (
            changed(POSITIONS, (2, 1), math.nan),
            ROTATIONS,
            "clip 'walk': a pelvis position in frame 2 is not finite",
        ),
        (
            changed(POSITIONS, (1, 2), -4e7),
            ROTATIONS,
            "clip 'walk': the pelvis in frame 1 is 4e+07 m away; it must be within 1e+06 m, in "
            "meters",
        ),
        (
            POSITIONS,
            changed(ROTATIONS, (3, 1, 0), math.inf),
            "clip 'walk': a rotation in frame 3 is not finite",
        ),
        (
            POSITIONS,
            changed(ROTATIONS, (4, 2, 1), 0.5),
            "clip 'walk': the rotation of 'Shank' in frame 4 has length 1.118034; "
            "unit quaternions are needed",
        ),
    ],
)
def test_impossible_clips_are_refused(
    positions: Positions, rotations: Rotations, message: str
) -> None:
    with pytest.raises(ClipError) as caught:
        clip(positions, rotations)
    assert str(caught.value) == message


@pytest.mark.parametrize("fps", [0.0, -30.0, math.nan, math.inf])
def test_a_clip_needs_a_frame_rate(fps: float) -> None:
    with pytest.raises(ClipError) as caught:
        clip(fps=fps)
    assert str(caught.value) == f"clip 'walk' has {fps} frames per second; it must be > 0"


def test_a_cycle_needs_two_frames() -> None:
    with pytest.raises(ClipError) as caught:
        clip(POSITIONS[:1], ROTATIONS[:1], cyclic=True)
    assert str(caught.value) == "clip 'walk' is cyclic with a single frame; it needs two"
