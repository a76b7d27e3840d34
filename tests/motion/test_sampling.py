from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests import walking_figure

from footfall.errors import ArgumentError
from footfall.geometry import from_yaw, multiply, rotate
from footfall.motion import Clip, cycle_displacement, sample

WALK = walking_figure.walk(frames=34, fps=30.0)


def turning_cycle() -> Clip:
    """Return a cycle that ends 0.5 rad further and 1 m ahead."""
    share = np.arange(34) / 33
    turn = from_yaw(0.5 * share)
    rotations = WALK.local_rotations.copy()
    rotations[:] = rotations[0]
    rotations[:, 0] = multiply(turn, rotations[:, 0])
    pelvis = np.stack([0.3 + 0.2 * share, np.full(34, 0.9), 1.0 * share], axis=-1)
    return WALK.evolve(pelvis_positions=pelvis, local_rotations=rotations, cyclic=True)


CYCLE = turning_cycle()


def test_at_the_time_of_a_frame_it_is_that_frame() -> None:
    positions, rotations = sample(WALK, np.arange(34) / 30.0)
    np.testing.assert_allclose(positions, WALK.pelvis_positions, atol=1e-12)
    np.testing.assert_allclose(rotations, WALK.local_rotations, atol=1e-12)


@given(st.floats(0.0, 1.1))
@settings(deadline=None)
def test_between_two_frames_it_is_between_them(time: float) -> None:
    positions, rotations = sample(WALK, np.array([time]))
    frame = min(int(time * 30.0), 32)
    ends = WALK.pelvis_positions[frame : frame + 2]
    assert (positions[0] >= ends.min(axis=0) - 1e-12).all()
    assert (positions[0] <= ends.max(axis=0) + 1e-12).all()
    np.testing.assert_allclose(np.linalg.norm(rotations, axis=-1), 1.0, atol=1e-12)


def test_past_its_ends_a_clip_stays_on_its_last_pose() -> None:
    positions, rotations = sample(WALK, np.array([-5.0, 0.0, 1.1, 99.0]))
    for early, late in ((0, 1), (2, 3)):
        np.testing.assert_allclose(positions[early], positions[late], atol=1e-12)
        np.testing.assert_allclose(rotations[early], rotations[late], atol=1e-12)


def test_the_displacement_of_a_cycle_takes_its_first_pose_onto_its_last() -> None:
    shift, yaw = cycle_displacement(CYCLE)
    assert yaw == pytest.approx(0.5)
    assert shift[1] == 0.0
    moved = rotate(from_yaw(yaw), CYCLE.pelvis_positions[0]) + shift
    np.testing.assert_allclose(moved, CYCLE.pelvis_positions[-1], atol=1e-12)


@given(st.integers(-12, 12), st.floats(0.0, 1.099))
@settings(deadline=None)
def test_each_cycle_is_displaced_from_the_one_before(cycle: int, time: float) -> None:
    period = CYCLE.duration
    shift, yaw = cycle_displacement(CYCLE)
    times = np.array([time + cycle * period, time + (cycle + 1) * period])
    positions, rotations = sample(CYCLE, times)
    np.testing.assert_allclose(rotate(from_yaw(yaw), positions[0]) + shift, positions[1], atol=1e-9)
    turned = multiply(from_yaw(yaw), rotations[0, 0])
    assert abs(float(turned @ rotations[1, 0])) == pytest.approx(1.0, abs=1e-9)
    np.testing.assert_allclose(rotations[0, 1:], rotations[1, 1:], atol=1e-9)


def test_over_the_seam_a_cycle_moves_on_evenly() -> None:
    times = CYCLE.duration + np.arange(-3, 4) / 30.0
    positions, _ = sample(CYCLE, times)
    steps = np.linalg.norm(np.diff(positions, axis=0), axis=-1)
    np.testing.assert_allclose(steps, steps[0], rtol=1e-3)


def test_a_time_that_is_no_number_is_refused() -> None:
    with pytest.raises(ArgumentError, match=r"^time 1 is not finite$"):
        sample(WALK, np.array([0.0, np.nan]))
