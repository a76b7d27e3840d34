from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests import walking_figure

from footfall.arrays import Floats
from footfall.geometry import from_yaw, multiply, transforms
from footfall.motion import Clip, extract_root_path
from footfall.motion.root_motion import smooth_headings
from footfall.skeleton import find_anatomy

WALK = walking_figure.walk(frames=67, fps=60.0)
ANATOMY = find_anatomy(WALK.skeleton)


def headed(headings: Floats, cyclic: bool = False) -> Clip:
    rotations = WALK.local_rotations[np.zeros(len(headings), dtype=int)].copy()
    rotations[:, 0] = multiply(from_yaw(headings), rotations[:, 0])
    pelvis = np.zeros((len(headings), 3))
    pelvis[:, 0] = np.arange(len(headings)) * 0.01
    return WALK.evolve(pelvis_positions=pelvis, local_rotations=rotations, cyclic=cyclic)


def test_the_root_is_under_the_pelvis() -> None:
    path = extract_root_path(WALK, ANATOMY)
    np.testing.assert_array_equal(path.positions, WALK.pelvis_positions[:, [0, 2]])
    assert not path.headings.flags.writeable


def test_over_a_cycle_the_heading_is_linear_and_amid_the_swing() -> None:
    share = np.arange(67) / 66
    swing = 0.2 * np.sin(2.0 * np.pi * share + 1.0)
    path = extract_root_path(headed(0.3 + 0.8 * share + swing, cyclic=True), ANATOMY)
    np.testing.assert_allclose(path.headings, 0.3 + 0.8 * share, atol=1e-9)


@given(st.floats(-3.0, 3.0), st.floats(-2.0, 2.0))
@settings(deadline=None, max_examples=20)
def test_the_displacement_leads_from_the_first_root_to_the_last(start: float, turn: float) -> None:
    path = extract_root_path(headed(start + turn * np.arange(67) / 66, cyclic=True), ANATOMY)
    x, z = (float(number) for number in path.positions[0])
    last = transforms.compose(x, z, float(path.headings[0]), *path.displacement)
    assert last == pytest.approx((*path.positions[-1].tolist(), path.headings[-1]), abs=1e-9)


@pytest.mark.parametrize("fps", [30.0, 60.0, 120.0])
def test_a_steady_turn_is_kept_and_little_of_it_lost_at_the_ends(fps: float) -> None:
    turn: Floats = 0.3 + np.arange(int(6 * fps), dtype=np.float64) * (0.7 / fps)
    lost = np.abs(smooth_headings(turn, fps) - turn)
    assert lost[int(2 * fps) : -int(2 * fps)].max() < 1e-3
    assert lost.max() < 0.12


@pytest.mark.parametrize("phase", np.linspace(0.0, 2.0 * np.pi, 7))
def test_the_swing_of_the_steps_is_taken_out(phase: float) -> None:
    time = np.arange(181) / 60.0
    swing: Floats = 0.15 * np.sin(2.0 * np.pi * time + phase)
    smooth = smooth_headings(0.4 + swing, 60.0)
    assert np.abs(smooth - 0.4).max() < 0.75 * 0.15
    assert np.abs(smooth - 0.4)[60:-60].max() < 0.25 * 0.15


def test_a_turn_of_two_seconds_is_kept() -> None:
    time = np.arange(361) / 60.0
    share = np.clip((time - 2.0) / 2.0, 0.0, 1.0)
    turn: Floats = np.pi * (share - np.sin(2.0 * np.pi * share) / (2.0 * np.pi))
    assert np.abs(smooth_headings(turn, 60.0) - turn).max() < 0.1


def test_smoothing_has_no_delay() -> None:
    headings: Floats = np.random.default_rng(3).normal(size=90).cumsum() * 0.05
    forward = smooth_headings(headings, 30.0)
    np.testing.assert_allclose(smooth_headings(headings[::-1], 30.0)[::-1], forward, atol=1e-9)


def test_a_clip_of_few_frames_has_a_path() -> None:
    for count in (1, 2, 3):
        path = extract_root_path(headed(np.linspace(0.0, 0.1, count)), ANATOMY)
        assert np.isfinite(path.headings).all()
