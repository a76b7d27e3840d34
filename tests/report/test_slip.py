from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.report.bodies import HEEL, LEFT, TOE, resting_feet, slide, trace_of

from footfall.arrays import Floats, Positions
from footfall.geometry import from_yaw, multiply, rotate
from footfall.report import SpanMeasure, Trace, Track, carried_steps, measure_spans

FRAMES = 41


def only(trace: Trace) -> SpanMeasure:
    (measure,) = measure_spans(Track.from_trace(trace))
    return measure


def left_alone(points: Positions, **more: Any) -> SpanMeasure:
    return only(trace_of(points, "L" * len(points), **more))


def test_a_foot_that_stands_still_scores_zero() -> None:
    measure = left_alone(resting_feet(FRAMES))
    assert (measure.slip, measure.inner_slip, measure.drift, measure.inner_drift) == (0, 0, 0, 0)


def test_a_foot_that_slides_10_mm_scores_10_mm() -> None:
    points = resting_feet(FRAMES)
    points[:, LEFT, :, 2] += slide(FRAMES, 0.010)[:, np.newaxis]
    measure = left_alone(points)
    assert measure.slip == pytest.approx(0.010)
    assert measure.drift == pytest.approx(0.010)


def test_the_inner_slip_leaves_out_67_ms_at_each_end() -> None:
    points = resting_feet(FRAMES)
    points[:5, LEFT, :, 0] += np.linspace(0.030, 0.0, 5)[:, np.newaxis]
    points[-5:, LEFT, :, 0] += np.linspace(0.0, 0.050, 5)[:, np.newaxis]
    measure = left_alone(points)
    assert measure.slip == pytest.approx(0.080)
    assert measure.inner_slip == pytest.approx(0.0, abs=1e-12)
    assert measure.inner_drift == pytest.approx(0.0, abs=1e-12)


def test_a_span_too_short_for_an_inner_part_has_no_inner_slip() -> None:
    short, long = left_alone(resting_feet(9)), left_alone(resting_feet(10))
    assert (short.inner_slip, short.inner_drift) == (None, None)
    assert (long.inner_slip, long.inner_drift) == (0.0, 0.0)


def rolling_foot(frames: int) -> Positions:
    """Heel strike, flat, heel off: heel still, then both, then toe still."""
    points = resting_feet(frames)
    pitch = np.concatenate(
        [np.linspace(0.5, 0.0, frames // 3), np.zeros(frames - 2 * (frames // 3))]
    )
    for frame, angle in enumerate(pitch):
        points[frame, LEFT, TOE, 1:] = [0.2 * math.sin(angle), 0.2 * math.cos(angle)]
    for frame, angle in enumerate(np.linspace(0.0, 1.0, frames // 3)):
        heel = [0.2 * math.sin(angle), 0.2 - 0.2 * math.cos(angle)]
        points[frames - frames // 3 + frame, LEFT, HEEL, 1:] = heel
    return points


def test_a_foot_that_rolls_from_heel_to_toe_scores_zero() -> None:
    points = rolling_foot(FRAMES)
    measure = left_alone(points)
    assert np.ptp(points[:, LEFT, TOE, 2]) > 0.02
    assert np.ptp(points[:, LEFT, HEEL, 2]) > 0.05
    assert measure.slip == pytest.approx(0.0, abs=1e-12)
    assert measure.drift == pytest.approx(0.0, abs=1e-12)


def test_a_point_carries_a_step_only_if_it_is_in_contact_at_both_ends_of_it() -> None:
    places = np.zeros((3, 2, 2))
    places[:, TOE, 1] = [0.0, 0.01, 0.03]
    contacts = np.array([[True, True], [True, True], [False, True]])
    steps = carried_steps(places, np.zeros((3, 2)), contacts)
    assert steps == pytest.approx(np.array([[0.0, 0.0], [0.0, 0.02]]))


def test_a_foot_that_hovers_does_not_score_zero() -> None:
    points = resting_feet(FRAMES)
    points[:, LEFT, :, 1] = 0.3
    points[:, LEFT, TOE, 1] += 0.01
    points[:, LEFT, HEEL, 0] += slide(FRAMES, 0.5)
    measure = left_alone(points)
    assert measure.slip == pytest.approx(0.5)
    assert measure.drift == pytest.approx(0.5)
    assert measure.clearances == pytest.approx(0.3)


def test_a_foot_that_hovers_on_alternating_points_still_drifts() -> None:
    points = resting_feet(FRAMES)
    points[:, LEFT, :, 1] = 0.1
    points[::2, LEFT, HEEL, 1] = 0.09
    points[:, LEFT, :, 2] += slide(FRAMES, 0.4)[:, np.newaxis]
    measure = left_alone(points)
    assert measure.slip == pytest.approx(0.4)
    assert measure.drift == pytest.approx(0.4)


def test_a_point_may_be_planted_elsewhere_while_the_other_one_carries() -> None:
    points = resting_feet(FRAMES)
    lifted = slice(10, 20)
    points[lifted, LEFT, HEEL, 1] = 0.1
    points[lifted, LEFT, HEEL, 0] += np.linspace(0.0, 0.1, 10)
    points[20:, LEFT, HEEL, 0] += 0.1
    points[30:, LEFT, TOE, 1] = 0.1
    points[30:, LEFT, TOE, 0] += 0.1
    assert left_alone(points).drift == pytest.approx(0.0, abs=1e-12)


def test_a_foot_that_lifts_while_it_should_carry_answers_for_its_way() -> None:
    points = resting_feet(FRAMES)
    lifted = slice(10, 21)
    points[lifted, LEFT, :, 1] = 0.1
    points[lifted, LEFT, :, 0] += np.linspace(0.0, 0.3, 11)[:, np.newaxis]
    points[21:, LEFT, :, 0] += 0.3
    measure = left_alone(points)
    assert measure.slip == pytest.approx(0.3)
    assert measure.drift == pytest.approx(0.3)


def test_slip_adds_up_where_drift_takes_the_greatest_distance() -> None:
    points = resting_feet(FRAMES)
    there_and_back = np.concatenate([slide(21, 0.010), slide(21, 0.010)[-2::-1]])
    points[:, LEFT, :, 2] += there_and_back[:, np.newaxis]
    measure = left_alone(points)
    assert measure.slip == pytest.approx(0.020)
    assert measure.drift == pytest.approx(0.010)


def test_a_foot_carried_by_a_platform_does_not_slip() -> None:
    points = resting_feet(FRAMES)
    way = np.stack([slide(FRAMES, 1.0), np.zeros(FRAMES), slide(FRAMES, -2.0)], axis=-1)
    points += way[:, np.newaxis, np.newaxis]
    assert left_alone(points).slip > 2.0
    measure = left_alone(points, surface_displacement=way)
    assert measure.slip == pytest.approx(0.0, abs=1e-12)


def test_heights_are_over_the_surface_under_each_point() -> None:
    def slope(points: Positions, times: Floats) -> Floats:
        assert times.shape == points.shape[:-1]
        return 0.5 * points[..., 2]

    points = resting_feet(FRAMES)
    points[..., 1] = 0.5 * points[..., 2] + 0.01
    for ground in (slope, 0.5 * points[..., 2]):
        measure = left_alone(points, ground=ground)
        assert measure.clearances == pytest.approx(0.01)


def test_resting_levels_are_estimated_for_each_point_where_they_are_not_given() -> None:
    points = resting_feet(FRAMES)
    points[:, LEFT, HEEL, 1] = 0.09
    points[:, LEFT, TOE, 1] = 0.02
    points[0, LEFT, TOE, 1] = -0.5
    points[5:, LEFT, TOE, 1] = 0.3
    track = Track.from_trace(trace_of(points, "L" * FRAMES, resting_levels=None))
    assert track.resting_levels == pytest.approx(np.array([[0.04, 0.02], [0.0, 0.0]]))


def test_contact_is_below_a_twentieth_of_the_leg_where_no_height_is_given() -> None:
    track = Track.from_trace(trace_of(resting_feet(3), "LLL", contact_height=None))
    assert track.contact_heights == pytest.approx(0.04)


def test_excess_is_slip_over_the_mean_slip_of_the_sources_that_stand_there() -> None:
    points = resting_feet(FRAMES)
    points[:, LEFT, :, 2] += slide(FRAMES, 0.040)[:, np.newaxis]
    sources = np.full((FRAMES, 2), np.nan)
    sources[:4, LEFT] = 0.9
    sources[5:25, LEFT] = 0.002
    sources[-4:, LEFT] = 0.9
    (measure,) = measure_spans(Track.from_trace(trace_of(points, "L" * FRAMES)), sources)
    assert measure.inner_slip == pytest.approx(0.032)
    assert measure.excess == pytest.approx(0.030)


def test_without_any_source_that_stands_there_all_slip_is_excess() -> None:
    sources = np.full((FRAMES, 2), np.nan)
    points = resting_feet(FRAMES)
    points[:, LEFT, :, 2] += slide(FRAMES, 0.040)[:, np.newaxis]
    (measure,) = measure_spans(Track.from_trace(trace_of(points, "L" * FRAMES)), sources)
    assert measure.excess == measure.inner_slip


def test_without_sources_there_is_no_excess() -> None:
    assert left_alone(resting_feet(FRAMES)).excess is None


wave = st.tuples(
    st.floats(0.001, 0.05), st.floats(0.5, 3.0), st.floats(0.0, 6.0), st.floats(0.0, 0.05)
)


def wandering(seconds: float, fps: float, shape: tuple[float, float, float, float]) -> Positions:
    size, pace, phase, lift = shape
    times = np.arange(round(seconds * fps) + 1) / fps
    points = resting_feet(len(times))
    points[:, LEFT, :, 0] += (size * np.sin(pace * times + phase))[:, np.newaxis]
    points[:, LEFT, HEEL, 1] += lift * (1.0 + np.sin(2.0 * pace * times))
    return points


@settings(deadline=None, max_examples=50)
@given(wave, st.sampled_from([120.0, 180.0, 240.0, 480.0]))
def test_nothing_depends_on_the_frame_rate(
    shape: tuple[float, float, float, float], fps: float
) -> None:
    slow = left_alone(wandering(1.0, 60.0, shape))
    fast = left_alone(wandering(1.0, fps, shape), fps=fps)
    for name in ("slip", "inner_slip", "drift", "inner_drift"):
        assert getattr(fast, name) == pytest.approx(getattr(slow, name), abs=1e-9)


@pytest.mark.parametrize("fps", [24.0, 25.0, 29.97, 30.0, 100.0, 144.0])
def test_an_even_slide_has_one_length_at_any_rate(fps: float) -> None:
    frames = round(fps) + 1
    points = resting_feet(frames)
    points[:, LEFT, :, 2] += (0.060 * np.arange(frames) / fps)[:, np.newaxis]
    measure = left_alone(points, fps=fps)
    assert measure.slip == pytest.approx(0.060, abs=0.0011)
    assert measure.inner_slip == pytest.approx(0.052, abs=0.0011)


@settings(deadline=None, max_examples=50)
@given(wave, st.floats(-3.2, 3.2), st.floats(-1e3, 1e3), st.floats(-1e3, 1e3), st.floats(-5.0, 5.0))
def test_nothing_depends_on_place_and_heading_of_the_motion(
    shape: tuple[float, float, float, float], yaw: float, x: float, z: float, y: float
) -> None:
    here = trace_of(wandering(1.0, 60.0, shape), "L" * 61)
    turn = from_yaw(yaw)
    there = Trace(
        positions=rotate(turn, here.positions) + np.array([x, y, z]),
        rotations=multiply(turn, here.rotations),
        anatomy=here.anatomy,
        fps=60.0,
        supports=here.supports,
        ground=y,
        resting_levels=np.zeros((2, 2)),
        contact_height=0.04,
    )
    one, other = only(here), only(there)
    for name in ("slip", "inner_slip", "drift", "inner_drift"):
        assert getattr(other, name) == pytest.approx(getattr(one, name), abs=1e-9)
    assert other.clearances == pytest.approx(one.clearances, abs=1e-9)


@settings(deadline=None, max_examples=50)
@given(wave)
def test_slip_is_never_less_than_drift(shape: tuple[float, float, float, float]) -> None:
    measure = left_alone(wandering(1.0, 60.0, shape))
    assert measure.slip >= measure.drift - 1e-12
    assert measure.inner_slip is not None
    assert measure.inner_slip <= measure.slip + 1e-12
