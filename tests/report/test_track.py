from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.report.bodies import ANATOMY, HEEL, LEFT, resting_feet, trace_of

from footfall.arrays import Floats
from footfall.geometry import from_axis_angle
from footfall.report import Trace, Track
from footfall.report.track import frame_times, resampled, resampled_labels
from footfall.skeleton import FootPoint


@settings(deadline=None)
@given(st.integers(1, 500), st.floats(5.0, 500.0))
def test_the_frames_at_60_hz_span_the_motion(frames: int, fps: float) -> None:
    times = frame_times(frames, fps)
    end = (frames - 1) / fps
    assert times[0] == 0.0
    assert end - 1.0 / 60.0 < times[-1] <= end + 1e-6


@settings(deadline=None)
@given(st.integers(2, 200), st.floats(5.0, 500.0), st.floats(-5.0, 5.0))
def test_an_even_motion_is_the_same_at_any_rate(frames: int, fps: float, speed: float) -> None:
    values: Floats = np.arange(frames, dtype=np.float64) * (speed / fps)
    assert resampled(values, fps) == pytest.approx(speed * frame_times(frames, fps), abs=1e-5)


def test_between_two_frames_positions_are_linear() -> None:
    assert resampled(np.array([[0.0, 1.0], [2.0, 5.0]]), 30.0).tolist() == [[0, 1], [1, 3], [2, 5]]


def test_labels_are_those_of_the_nearest_frame_the_later_of_two() -> None:
    assert resampled_labels(np.array([1, 2, 3]), 30.0).tolist() == [1, 2, 2, 3, 3]
    assert resampled_labels(np.array([1, 2, 3, 4, 5]), 120.0).tolist() == [1, 3, 5]


@pytest.mark.parametrize("frames", [1, 2, 7])
def test_at_60_hz_nothing_is_changed(frames: int) -> None:
    values = np.random.default_rng(1).normal(size=(frames, 3))
    assert (resampled(values, 60.0) == values).all()
    assert (resampled_labels(values, 60.0) == values).all()


def test_a_foot_point_turns_with_its_joint() -> None:
    trace = trace_of(resting_feet(1), "L")
    left = replace(ANATOMY.left, heel=FootPoint(3, (0.0, -0.08, -0.05)))
    rotations = trace.rotations.copy()
    rotations[0, 3] = from_axis_angle(np.array([1.0, 0.0, 0.0]), math.pi / 2)
    turned = Trace(
        positions=trace.positions,
        rotations=rotations,
        anatomy=replace(ANATOMY, left=left),
        fps=60.0,
        supports=trace.supports,
    )
    heel = Track.from_trace(turned).points[0, LEFT, HEEL]
    assert heel == pytest.approx(np.array([0.1, 0.05, -0.08]))


def test_rates_default_to_one() -> None:
    assert Track.from_trace(trace_of(resting_feet(3), "LLL")).rates.tolist() == [1.0, 1.0, 1.0]


def test_weights_move_in_the_frames_around_a_change_of_shares() -> None:
    shares = np.array([[1.0, 0.0], [1.0, 0.0], [0.4, 0.6], [0.4, 0.6], [0.4, 0.6]])
    track = Track.from_trace(trace_of(resting_feet(5), "LLLLL", shares=shares))
    assert track.moving.tolist() == [False, True, True, False, False]
