from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.detection.filters import gaussian, moving_mean, moving_minimum

SERIES = st.lists(st.floats(-10.0, 10.0), min_size=1, max_size=30).map(np.array)


@settings(deadline=None)
@given(SERIES, st.integers(0, 12), st.booleans())
def test_moving_minimum_and_mean_are_those_of_the_window(
    values: np.ndarray[tuple[int], np.dtype[np.float64]], radius: int, cyclic: bool
) -> None:
    count = len(values)
    for center in range(count):
        rows = np.arange(center - radius, center + radius + 1)
        window = values[rows % count if cyclic else np.clip(rows, 0, count - 1)]
        assert moving_minimum(values, radius, cyclic=cyclic)[center] == window.min()
        assert moving_mean(values, radius, cyclic=cyclic)[center] == pytest.approx(
            window.mean(), abs=1e-12
        )


def test_a_gaussian_keeps_a_constant_and_spreads_a_peak_evenly() -> None:
    np.testing.assert_allclose(gaussian(np.full(20, 3.0), 2.0), 3.0)
    peak = np.zeros(41)
    peak[20] = 1.0
    smooth = gaussian(peak, 2.0)
    np.testing.assert_allclose(smooth, smooth[::-1], atol=1e-15)
    assert smooth.sum() == pytest.approx(1.0)
    assert float((smooth * (np.arange(41) - 20) ** 2).sum()) == pytest.approx(4.0, rel=0.02)
    np.testing.assert_allclose(gaussian(np.roll(peak, 20), 2.0, cyclic=True), np.roll(smooth, 20))


def test_no_deviation_changes_nothing() -> None:
    values = np.arange(5.0)
    assert gaussian(values, 0.0) is values
