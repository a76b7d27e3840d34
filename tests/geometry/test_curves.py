from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicHermiteSpline  # pyright: ignore[reportMissingTypeStubs]

from footfall.arrays import Floats
from footfall.geometry import cubic_hermite, rational_hermite

Curve = Callable[[float, float, float, float, float, float, float], tuple[float, float]]
CURVES = pytest.mark.parametrize("curve", [cubic_hermite, rational_hermite])

positions = st.floats(-100.0, 100.0)
lengths = st.floats(1e-3, 10.0)
ratios = st.one_of(st.just(0.0), st.floats(0.0, 3.0), st.floats(3.0, 1e4))
"""End slope over mean slope."""


def sampled(curve: Curve, times: Floats, *knots: float) -> tuple[Floats, Floats]:
    values = np.array([curve(float(t), *knots) for t in times])  # type: ignore[call-arg]
    return values[:, 0], values[:, 1]


@CURVES
@settings(deadline=None)
@given(positions, lengths, positions, lengths, ratios, ratios)
def test_values_and_slopes_at_both_knots_are_those_given(
    curve: Curve, t0: float, length: float, h0: float, rise: float, before: float, after: float
) -> None:
    t1, h1 = t0 + length, h0 + rise
    v0, v1 = before * rise / length, after * rise / length
    assert curve(t0, t0, h0, v0, t1, h1, v1) == (h0, v0)
    assert curve(t1, t0, h0, v0, t1, h1, v1) == (h1, v1)


@CURVES
@settings(deadline=None)
@given(ratios, ratios)
def test_nothing_jumps_at_the_knots(curve: Curve, v0: float, v1: float) -> None:
    tiny = 1e-13
    steep = 1.0 + (v0 + v1) ** 2
    for knot, value, slope in ((0.0, 0.0, v0), (1.0, 1.0, v1)):
        for t in (knot - tiny, knot + tiny):
            near, near_slope = curve(t, 0.0, 0.0, v0, 1.0, 1.0, v1)
            assert near == pytest.approx(value, abs=100.0 * tiny * steep)
            assert near_slope == pytest.approx(slope, abs=100.0 * tiny * steep)


@CURVES
@settings(deadline=None)
@given(st.floats(0.01, 0.99), ratios, ratios)
def test_the_slope_is_the_derivative_of_the_value(
    curve: Curve, t: float, v0: float, v1: float
) -> None:
    step = 1e-6
    after, _ = curve(t + step, 0.0, 0.0, v0, 1.0, 1.0, v1)
    before, _ = curve(t - step, 0.0, 0.0, v0, 1.0, 1.0, v1)
    _, slope = curve(t, 0.0, 0.0, v0, 1.0, 1.0, v1)
    assert slope == pytest.approx((after - before) / (2.0 * step), rel=1e-4, abs=1e-3)


@settings(deadline=None)
@given(positions, lengths, positions, lengths, ratios, ratios)
def test_the_cubic_is_the_textbook_one(
    t0: float, length: float, h0: float, rise: float, before: float, after: float
) -> None:
    t1, h1 = t0 + length, h0 + rise
    v0, v1 = before * rise / length, after * rise / length
    times = np.linspace(t0, t1, 20)[1:-1]
    oracle = CubicHermiteSpline([t0, t1], [h0, h1], [v0, v1])
    values, slopes = sampled(cubic_hermite, times, t0, h0, v0, t1, h1, v1)
    scale = rise * (1.0 + before + after)
    np.testing.assert_allclose(values, oracle(times), rtol=0, atol=1e-9 * scale + 1e-9)
    np.testing.assert_allclose(slopes, oracle(times, 1), rtol=1e-8, atol=1e-8 * scale / length)


@settings(deadline=None, max_examples=300)
@given(positions, lengths, positions, lengths, ratios, ratios)
@example(0.0, 1.0, 0.0, 1e-300, 1e4, 1e4)
def test_the_rational_quadratic_never_decreases(
    t0: float, length: float, h0: float, rise: float, before: float, after: float
) -> None:
    t1, h1 = t0 + length, h0 + rise
    v0, v1 = before * rise / length, after * rise / length
    values, slopes = sampled(rational_hermite, np.linspace(t0, t1, 101), t0, h0, v0, t1, h1, v1)
    rounding = 1e-15 * max(abs(h0), abs(h1))
    assert slopes.min() >= 0.0
    assert np.diff(values).min() >= -rounding
    assert values.min() >= h0 - rounding
    assert values.max() <= h1 + rounding


@settings(deadline=None)
@given(lengths, lengths, st.floats(0.0, 2.0))
def test_between_mirrored_slopes_both_are_the_same_parabola(
    length: float, rise: float, ratio: float
) -> None:
    mean = rise / length
    v0, v1 = ratio * mean, (2.0 - ratio) * mean
    times = np.linspace(0.0, length, 33)
    cubic = sampled(cubic_hermite, times, 0.0, 0.0, v0, length, rise, v1)
    rational = sampled(rational_hermite, times, 0.0, 0.0, v0, length, rise, v1)
    parabola = v0 * times + (mean - v0) / length * times**2
    np.testing.assert_allclose(cubic[0], parabola, rtol=0, atol=1e-13 * rise)
    np.testing.assert_allclose(rational[0], parabola, rtol=0, atol=1e-13 * rise)
    np.testing.assert_allclose(rational[1], cubic[1], rtol=0, atol=1e-12 * mean)


@pytest.mark.parametrize("t", [0.25, 0.5, 0.75])
@pytest.mark.parametrize(("v0", "v1"), [(0.0, 0.0), (1.0, 0.0), (0.0, 5.0), (2.0, 3.0)])
def test_a_flat_rational_segment_stands_still(t: float, v0: float, v1: float) -> None:
    assert rational_hermite(t, 0.0, 7.0, v0, 1.0, 7.0, v1) == (7.0, 0.0)


@CURVES
def test_a_segment_of_no_length_is_a_step(curve: Curve) -> None:
    assert curve(1.5, 2.0, 3.0, 1.0, 2.0, 4.0, 2.0) == (2.5, 1.0)
    assert curve(2.0, 2.0, 3.0, 1.0, 2.0, 4.0, 2.0) == (4.0, 2.0)
    assert curve(2.5, 2.0, 3.0, 1.0, 2.0, 4.0, 2.0) == (5.0, 2.0)


@CURVES
def test_outside_its_knots_a_segment_goes_on_straight(curve: Curve) -> None:
    assert curve(-2.0, 0.0, 1.0, 0.5, 1.0, 2.0, 3.0) == (0.0, 0.5)
    assert curve(3.0, 0.0, 1.0, 0.5, 1.0, 2.0, 3.0) == (8.0, 3.0)


def test_a_hardly_rising_segment_stays_finite_however_steep_its_ends() -> None:
    values, slopes = sampled(
        rational_hermite, np.linspace(0.0, 1.0, 11), 0.0, 0.0, 1e6, 1.0, 5e-324, 1e6
    )
    assert np.isfinite(values).all()
    assert np.isfinite(slopes).all()
