from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests import walking_figure

from footfall.arrays import Floats
from footfall.errors import ClipError
from footfall.geometry import from_axis_angle, from_yaw, multiply, rotate
from footfall.io import load
from footfall.motion import Clip, close_cycle, cut_cycle, cycle_displacement, find_cycle, sample
from footfall.motion.gait import foot_point_paths, foot_speeds, swinging
from footfall.motion.ground_alignment import align_on_ground
from footfall.skeleton import find_anatomy, world_poses

MOTIONS = Path(__file__).parents[2].parent / "shared" / "motions"
WALK = walking_figure.walk(frames=200, fps=60.0)
ANATOMY = find_anatomy(WALK.skeleton)
PERIOD = round(walking_figure.PERIOD * 60)


def open_cycle() -> Clip:
    """Return a cycle whose end misses its beginning by some centimeters and degrees."""
    frames = PERIOD + 1
    walk = walking_figure.walk(frames=frames, fps=60.0)
    drift = np.arange(frames) / (frames - 1)
    pelvis = walk.pelvis_positions + drift[:, np.newaxis] * np.array([0.02, -0.015, 0.01])
    rotations = walk.local_rotations.copy()
    for joint in (0, 9, 14, 3):
        tilt = from_axis_angle(np.array([0.6, 0.0, 0.8]), 0.06 * drift)
        rotations[:, joint] = multiply(rotations[:, joint], tilt)
    return walk.evolve(pelvis_positions=pelvis, local_rotations=rotations)


@given(st.floats(-4.0, 4.0), st.integers(0, 2**32 - 1))
@settings(deadline=None)
def test_points_moved_over_the_ground_are_found_again(yaw: float, seed: int) -> None:
    random = np.random.default_rng(seed)
    points = random.normal(size=(6, 3))
    shift = random.normal(size=3) * np.array([1.0, 0.0, 1.0])
    found, moved, left = align_on_ground(points, rotate(from_yaw(yaw), points) + shift)
    assert float(np.cos(found - yaw)) == pytest.approx(1.0)
    np.testing.assert_allclose(moved, shift, atol=1e-9)
    np.testing.assert_allclose(left, 0.0, atol=1e-9)


def test_no_other_motion_over_the_ground_is_nearer() -> None:
    random = np.random.default_rng(5)
    points, targets = random.normal(size=(2, 6, 3))
    yaw, shift, left = align_on_ground(points, targets)
    for turn, step in zip(random.normal(size=50), random.normal(size=(50, 3)), strict=True):
        other = from_yaw(float(yaw) + 0.1 * turn)
        moved = rotate(other, points) + shift + 0.1 * step * np.array([1.0, 0.0, 1.0])
        assert ((targets - moved) ** 2).sum() >= (left**2).sum()


def test_a_cycle_lasts_one_period() -> None:
    cycle = find_cycle(WALK, ANATOMY)
    assert cycle.end - cycle.start == PERIOD
    assert cycle.mismatch < 1e-6


def test_standing_before_and_after_is_passed_over() -> None:
    frames = np.concatenate([np.zeros(120, int), np.arange(150), np.full(120, 149)])
    clip = WALK.evolve(
        pelvis_positions=WALK.pelvis_positions[frames],
        local_rotations=WALK.local_rotations[frames],
    )
    start, end, _ = find_cycle(clip, ANATOMY)
    assert end - start == PERIOD
    assert start >= 119
    assert end <= 270


def test_at_a_high_rate_it_is_found_to_the_frame() -> None:
    walk = walking_figure.walk(frames=600, fps=240.0)
    start, end, _ = find_cycle(walk, ANATOMY)
    assert end - start == 4 * PERIOD


def test_of_a_cycle_it_is_all() -> None:
    assert find_cycle(WALK.evolve(cyclic=True), ANATOMY)[:2] == (0, WALK.frames - 1)


def test_half_a_cycle_is_none() -> None:
    half = walking_figure.walk(frames=30, fps=60.0)
    with pytest.raises(ClipError) as refusal:
        find_cycle(half, ANATOMY)
    assert str(refusal.value) == (
        "clip 'walk' has no cycle: no stretch of 0.35 to 3 s holds exactly one swing of each foot; "
        "in its 0.48 s the left foot begins 0 swings, the right one 1"
    )


def test_ends_too_far_apart_are_refused() -> None:
    clip = open_cycle()
    rotations = clip.local_rotations.copy()
    bow = from_axis_angle(np.array([1.0, 0.0, 0.0]), np.linspace(0.0, 1.2, clip.frames))
    rotations[:, 9] = multiply(rotations[:, 9], bow)
    with pytest.raises(ClipError, match=r"^clip 'walk' has no cycle: its best stretch, frames "):
        find_cycle(clip.evolve(local_rotations=rotations), ANATOMY)


def test_a_closed_cycle_ends_on_its_first_pose_moved_over_the_ground() -> None:
    closed = close_cycle(open_cycle(), ANATOMY)
    assert closed.cyclic
    _, positions = closed.world_poses()
    shift, yaw = cycle_displacement(closed)
    moved = rotate(from_yaw(yaw), positions[0]) + shift
    np.testing.assert_allclose(moved, positions[-1], atol=1e-12)


def test_planted_toes_do_not_move_for_it() -> None:
    clip = open_cycle()
    rotations, positions = clip.world_poses()
    before = foot_point_paths(ANATOMY, rotations, positions)
    after = foot_point_paths(ANATOMY, *close_cycle(clip, ANATOMY).world_poses())
    speeds = foot_speeds(before, positions[:, 0], clip.fps)
    for foot in range(2):
        still = ~swinging(speeds[:, foot])
        steps = np.linalg.norm(np.diff((after - before)[:, foot, 1], axis=0), axis=-1)
        assert steps[still[1:] & still[:-1]].sum() < 2e-3
        assert steps.sum() > 5e-3


def test_it_repeats_without_a_jump() -> None:
    closed = close_cycle(open_cycle(), ANATOMY)
    times = np.arange(2 * PERIOD + 1) / 60.0
    _, positions = world_poses(closed.skeleton, *sample(closed, times))
    jerks = np.linalg.norm(np.diff(positions, n=2, axis=0), axis=-1).max(axis=1)
    assert jerks[PERIOD - 2 : PERIOD + 1].max() < 1.5 * np.percentile(jerks, 95.0)


def test_a_clip_that_closes_already_is_left_as_it_is() -> None:
    walk = walking_figure.walk(frames=PERIOD + 1, fps=60.0)
    closed = close_cycle(walk, ANATOMY)
    np.testing.assert_allclose(closed.pelvis_positions, walk.pelvis_positions, atol=1e-6)
    agreement: Floats = np.einsum("fji,fji->fj", closed.local_rotations, walk.local_rotations)
    np.testing.assert_allclose(np.abs(agreement), 1.0, atol=1e-6)


def test_two_frames_are_no_cycle() -> None:
    with pytest.raises(ClipError) as refusal:
        close_cycle(walking_figure.walk(frames=2), ANATOMY)
    assert str(refusal.value) == "clip 'walk' has 2 frames; a cycle needs at least three"


def test_a_cut_cycle_says_what_was_done() -> None:
    found, cropped, closed = (sentence for sentence in cut_cycle(WALK, ANATOMY).provenance)
    assert found.startswith("cropped to frames ")
    assert cropped.endswith("its ends 0 mm apart (root mean square over the joints)")
    assert closed.startswith("closed to a cycle: its end was moved by 0 mm at the pelvis")


REAL = {
    "snu_vsports/cmu16_15_walk": (1.167, 15.0),
    "snu_cmu69/cmu69_02_walk": (1.2, 20.0),
    "snu_ys2010/woody_walk_normal": (1.43, 30.0),
    "snu_vsports/cmu16_35_run": (0.8, 30.0),
    "snu_cmu69/cmu69_53_backward": (1.13, 30.0),
    "snu_cmu69/cmu69_57_sidestep_right": (1.07, 25.0),
    "ozz/pab_walk": (1.333, 0.1),
}
"""Seconds of one cycle, counted on plots of the feet's speed, and greatest mismatch [mm]."""


@pytest.mark.skipif(not MOTIONS.exists(), reason="the folder ../shared/motions is missing")
@pytest.mark.parametrize("name", REAL)
def test_cycles_of_real_clips(name: str) -> None:
    clip = load(MOTIONS / f"{name}.bvh.gz").evolve(cyclic=False)
    anatomy = find_anatomy(clip.skeleton)
    start, end, mismatch = find_cycle(clip, anatomy)
    seconds, most = REAL[name]
    assert (end - start) / clip.fps == pytest.approx(seconds, abs=0.05)
    assert 1000.0 * mismatch < most
    closed = cut_cycle(clip, anatomy)
    _, positions = closed.world_poses()
    shift, yaw = cycle_displacement(closed)
    moved = rotate(from_yaw(yaw), positions[0]) + shift
    np.testing.assert_allclose(moved, positions[-1], atol=1e-9)
