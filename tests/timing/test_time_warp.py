from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from footfall.arrays import Floats
from footfall.errors import ArgumentError
from footfall.timing import TimeWarp, end_slope, end_slope_paper, warp

rates = st.one_of(st.just(0.0), st.floats(1e-3, 100.0))
steps = arrays(np.float64, (6,), elements=st.floats(0.02, 2.0))
rises = arrays(np.float64, (6,), elements=st.one_of(st.just(0.0), st.floats(0.01, 2.0)))


def knots(differences: Floats) -> Floats:
    return np.concatenate([[0.0], np.cumsum(differences)])


@settings(deadline=None)
@given(rates, rates)
def test_the_end_slope_suits_both_slots(mean: float, next_mean: float) -> None:
    slope = end_slope(mean, next_mean)
    assert slope == pytest.approx(end_slope(next_mean, mean), rel=1e-15)
    smaller, greater = sorted((mean, next_mean))
    assert smaller * (1.0 - 1e-12) <= slope <= min(2.0 * smaller, greater) * (1.0 + 1e-12)


@pytest.mark.parametrize(
    ("mean", "next_mean", "slope"),
    [(1.0, 1.0, 1.0), (0.5, 0.5, 0.5), (1.0, 3.0, 1.5), (0.0, 2.0, 0.0), (2.0, 0.0, 0.0)],
)
def test_end_slopes_by_hand(mean: float, next_mean: float, slope: float) -> None:
    assert end_slope(mean, next_mean) == slope


@settings(deadline=None)
@given(rates, rates)
def test_the_printed_end_slope_stays_within_its_bounds(mean: float, rate: float) -> None:
    assert 0.0 <= end_slope_paper(mean, rate) <= 3.0 * mean


@settings(deadline=None)
@given(steps, rises, st.booleans())
def test_a_warp_never_goes_back_and_meets_its_knots(
    clock: Floats, clip: Floats, paper: bool
) -> None:
    curve = TimeWarp.through(knots(clock), knots(clip), paper=paper)
    times = np.linspace(0.0, float(curve.clock_times[-1]), 400)
    clip_times, slopes = curve.at(times)
    assert np.diff(clip_times).min() >= -1e-14
    assert slopes.min() >= -1e-9
    np.testing.assert_array_equal(curve.at(curve.clock_times)[0], curve.clip_times)


def test_an_action_that_ends_comes_to_rest() -> None:
    clock, clip = np.array([0.0, 1.0, 2.0]), np.array([0.0, 1.0, 2.0])
    ending = TimeWarp.through(clock, clip, next_mean=0.0)
    assert ending.rates.tolist() == [1.0, 1.0, 0.0]
    assert TimeWarp.through(clock, clip).rates.tolist() == [1.0, 1.0, 1.0]
    assert [array.tolist() for array in ending.at(np.array([2.0, 3.0]))] == [[2.0, 2.0], [0.0, 0.0]]


def test_a_slot_of_no_length_is_left_at_once() -> None:
    assert warp(1.0, 1.0, 0.5, 1.0, 1.0, 0.75, 2.0, True) == (0.75, 2.0)
    assert warp(1.0, 1.0, 0.5, 1.0, 1.0, 0.75, 2.0, False) == (0.75, 2.0)


@pytest.mark.parametrize("use_paper_cubic", [True, False])
def test_a_clip_that_is_held_where_it_is_stands_still(use_paper_cubic: bool) -> None:
    assert warp(0.5, 0.0, 2.0, 1.0, 1.0, 2.0, 0.0, use_paper_cubic) == (2.0, 0.0)


def test_what_a_warp_holds_cannot_be_written() -> None:
    clock = np.array([0.0, 1.0])
    curve = TimeWarp(clock, clock, clock)
    clock[1] = 9.0
    assert curve.clock_times[1] == 1.0
    with pytest.raises(ValueError, match="read-only"):
        curve.rates[0] = 1.0


@pytest.mark.parametrize(
    ("clock", "clip", "slopes", "message"),
    [
        (
            [0.0],
            [0.0],
            [1.0],
            "knots of shapes (1,), (1,) and (1,); a time warp needs three equal ones of at "
            "least (2,)",
        ),
        (
            [0.0, 1.0],
            [0.0, 1.0, 2.0],
            [1.0, 1.0],
            "knots of shapes (2,), (3,) and (2,); a time warp needs three equal ones of at "
            "least (2,)",
        ),
        (
            [0.0, 1.0, 1.0],
            [0.0, 1.0, 2.0],
            [1.0, 1.0, 1.0],
            "clock times must increase, but knot 2 is at 1.0 after 1.0",
        ),
        (
            [0.0, 1.0, 2.0],
            [0.0, 1.0, 0.5],
            [1.0, 1.0, 1.0],
            "clip times must never decrease, but knot 2 is at 0.5 after 1.0",
        ),
        (
            [0.0, 1.0],
            [0.0, 1.0],
            [1.0, -0.5],
            "rates must be finite and >= 0, but the one at knot 1 is -0.5",
        ),
        (
            [0.0, 1.0],
            [0.0, 1.0],
            [float("nan"), 1.0],
            "rates must be finite and >= 0, but the one at knot 0 is nan",
        ),
    ],
)
def test_impossible_warps_are_refused(
    clock: list[float], clip: list[float], slopes: list[float], message: str
) -> None:
    with pytest.raises(ArgumentError) as caught:
        TimeWarp(np.array(clock), np.array(clip), np.array(slopes))
    assert str(caught.value) == message
