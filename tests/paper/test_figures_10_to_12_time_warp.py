"""Figures 10 to 12 and section 5.3: the temporal deformation, as printed and as mended (S-25)."""

from __future__ import annotations

import numpy as np
import pytest
from tests.paper.requirements import requirement

from footfall.arrays import Floats
from footfall.geometry import cubic_hermite, rational_hermite
from footfall.timing import TimeWarp, end_slope, end_slope_paper, warp

CLOCK = np.array([0.0, 0.5, 1.2, 1.5, 2.3])
CLIP = np.array([0.0, 0.4, 1.1, 1.6, 2.2])
MODES = pytest.mark.parametrize("paper", [True, False])
PHASE = np.linspace(0.0, 1.0, 201)


def printed(ratio: float) -> tuple[Floats, Floats]:
    """Return the printed curve over a slot of unit mean rate that begins at this rate."""
    end = end_slope_paper(1.0, ratio)
    points = [cubic_hermite(float(s), 0.0, 0.0, ratio, 1.0, 1.0, end) for s in PHASE]
    return np.array([h for h, _ in points]), np.array([v for _, v in points])


def random_segments(count: int) -> tuple[Floats, Floats, Floats]:
    """Return lengths, rises and rates over mean rates, up to 30, log-uniform."""
    random = np.random.default_rng(1)
    ratios = np.exp(random.uniform(np.log(0.01), np.log(30.0), count))
    return random.uniform(0.03, 1.0, count), random.uniform(0.03, 1.0, count), ratios


@requirement(
    80, "This function is not derivable and engenders discontinuities in speed and acceleration."
)
def test_figure_10_the_plain_warp_jumps_in_speed_at_each_knot() -> None:
    means = np.diff(CLIP) / np.diff(CLOCK)
    assert np.abs(np.diff(means)).min() > 0.1


@requirement(78, "This duration is then used in the time warping process to adapt the motion.")
@MODES
def test_figure_12_the_warp_passes_all_knots_and_never_goes_back(paper: bool) -> None:
    curve = TimeWarp.through(CLOCK, CLIP, paper=paper)
    clip_times, rates = curve.at(np.linspace(0.0, 2.3, 5001))
    assert np.diff(clip_times).min() >= 0.0
    assert rates.min() >= 0.0
    np.testing.assert_allclose(curve.at(CLOCK)[0], CLIP, rtol=0, atol=1e-15)


@requirement(
    4,
    "The resulting time warping function can be non-derivable so it is corrected by using a "
    "cardinal spline interpolation.",
)
@requirement(
    81,
    "a function that allows to slow down or accelerate the motion in order to avoid these "
    "discontinuities during animation",
)
@requirement(
    87,
    "the temporal deformation resulting from the time warping function does not engender speed "
    "discontinuities in the animation",
)
@MODES
def test_figure_12_neither_place_nor_speed_jumps_at_the_knots(paper: bool) -> None:
    curve = TimeWarp.through(CLOCK, CLIP, paper=paper)
    for knot in CLOCK[1:-1]:
        before, after = curve.at(np.array([knot - 1e-12])), curve.at(np.array([knot + 1e-12]))
        assert abs(after[0] - before[0]).max() < 1e-9
        assert abs(after[1] - before[1]).max() < 1e-9


@requirement(82, "has changed since the last simulation step")
@requirement(86, "is performed each time elements' durations vary")
@pytest.mark.parametrize("use_paper_cubic", [True, False])
def test_figure_11_a_slot_whose_end_moves_is_followed_without_a_jump(use_paper_cubic: bool) -> None:
    h, v, t, t1 = 0.0, 1.0, 0.0, 1.0
    for end in (1.4, 0.9, 1.1, 1.0):
        v1 = end_slope_paper((1.0 - h) / (t1 - t), v)
        now = t + 0.2
        h_now, v_now = warp(now, t, h, v, t1, 1.0, v1, use_paper_cubic)
        again = end_slope_paper((1.0 - h_now) / (end - now), v_now)
        rebuilt = warp(now, now, h_now, v_now, end, 1.0, again, use_paper_cubic)
        assert rebuilt == (h_now, v_now)
        soon = warp(now + 1e-12, now, h_now, v_now, end, 1.0, again, use_paper_cubic)
        assert soon == pytest.approx((h_now, v_now), abs=1e-9)
        h, v, t, t1 = h_now, v_now, now, end


@requirement(83, "taking the symetric of v(t) (Figure 11D) and born it (Figure 11E)")
def test_figures_11d_and_11e_the_symmetric_slope_is_bounded() -> None:
    assert end_slope_paper(1.0, 0.5) == 1.5
    assert end_slope_paper(1.0, 1.0) == 1.0
    assert end_slope_paper(1.0, 2.5) == 0.0
    assert end_slope_paper(0.0, 1.0) == 0.0
    # The upper bound, 3 mean, is never reached: the rate itself is never below zero.
    assert end_slope_paper(1.0, 0.0) == 2.0


@pytest.mark.parametrize(("ratio", "overshoot"), [(4.0, 0.037), (6.0, 0.25), (10.0, 0.79)])
def test_above_three_times_the_mean_rate_the_printed_cubic_runs_backward(
    ratio: float, overshoot: float
) -> None:
    clip_times, rates = printed(ratio)
    assert rates.min() < 0.0
    assert clip_times.max() == pytest.approx(1.0 + overshoot, abs=0.005)


def test_three_times_the_mean_rate_is_exactly_the_limit_of_the_printed_cubic() -> None:
    assert printed(3.0)[1].min() >= 0.0
    assert printed(3.01)[1].min() < 0.0


@requirement(85, "This process gives a monotonic time warping")
@pytest.mark.parametrize("use_paper_cubic", [True, False])
def test_time_never_runs_backward_in_two_hundred_thousand_random_samples(
    use_paper_cubic: bool,
) -> None:
    samples = 0
    for length, rise, ratio in zip(*random_segments(2000), strict=True):
        mean = rise / length
        end = end_slope_paper(mean, ratio * mean)
        before = 0.0
        for s in PHASE[::2]:
            h, v = warp(s * length, 0.0, 0.0, ratio * mean, length, rise, end, use_paper_cubic)
            assert before - 1e-15 <= h <= rise + 1e-15
            # The cubic touches zero at the very limit of its range, with its rounding error.
            assert v >= (-1e-12 * mean if use_paper_cubic else 0.0)
            before = h
            samples += 1
    assert samples >= 200_000


@requirement(84, "the function on element k is recovered by using a cardinal spline")
def test_up_to_twice_the_mean_rate_the_rational_quadratic_is_the_printed_curve() -> None:
    lengths, rises, ratios = random_segments(2000)
    compared = 0
    for length, rise, ratio in zip(lengths, rises, ratios, strict=True):
        if ratio > 2.0:
            continue
        mean = rise / length
        knots = (0.0, 0.0, ratio * mean, length, rise, end_slope_paper(mean, ratio * mean))
        for s in (0.1, 0.37, 0.5, 0.81):
            printed_h, printed_v = cubic_hermite(s * length, *knots)
            h, v = rational_hermite(s * length, *knots)
            assert abs(h - printed_h) < 1e-12
            assert abs(v - printed_v) < 1e-12 * max(1.0, mean)
            compared += 1
    assert compared > 1000


def test_beyond_twice_the_mean_rate_the_two_part() -> None:
    knots = (0.0, 0.0, 2.5, 1.0, 1.0, end_slope_paper(1.0, 2.5))
    assert abs(cubic_hermite(0.5, *knots)[0] - rational_hermite(0.5, *knots)[0]) > 0.01


def test_the_printed_end_slope_rings_and_the_harmonic_one_does_not() -> None:
    ringing, calm = [1.0], [1.0]
    for _ in range(6):
        ringing.append(end_slope_paper(0.5, ringing[-1]))
        calm.append(end_slope(0.5, 0.5))
    assert ringing == [1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0]
    assert calm == [1.0, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5]


def test_the_warp_follows_the_printed_cubic_where_that_is_monotone() -> None:
    for ratio, same in ((2.9, True), (3.1, False)):
        knots = (0.0, 0.0, ratio, 1.0, 1.0, 0.0)
        assert (warp(0.5, *knots, True) == cubic_hermite(0.5, *knots)) is same
        assert warp(0.5, *knots, False) == rational_hermite(0.5, *knots)
