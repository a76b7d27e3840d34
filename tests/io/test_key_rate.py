from __future__ import annotations

import numpy as np
import pytest

from footfall.errors import ArgumentError
from footfall.io.frame_rate import USUAL_RATES
from footfall.io.key_rate import conclude_key_rate, frame_times


@pytest.mark.parametrize("rate", [rate for rate in USUAL_RATES if rate >= 20])
@pytest.mark.parametrize("frames", [2, 5, 300])
def test_a_key_a_frame_gives_the_rate_of_the_frames(rate: int, frames: int) -> None:
    # Single precision is what files have.
    keys = (np.arange(frames) / rate).astype(np.float32).astype(np.float64)
    assert conclude_key_rate(keys, None).value == rate
    assert conclude_key_rate(keys + 2.0, None).value == pytest.approx(rate, rel=1e-5)


def test_keys_set_by_hand_give_the_least_usual_rate_that_has_them_all() -> None:
    found = conclude_key_rate(np.array([0.0, 0.5, 0.7, 2.0]), None)
    assert found.value == 30.0
    assert found.reason == "30 frames per second: the least usual rate with all keys on it"
    assert conclude_key_rate(np.array([0.0, 7 / 48, 1.0]), None).value == 48.0


def test_keys_on_no_usual_rate_keep_the_first_and_the_last() -> None:
    keys = np.array([0.0, 0.1234567, np.pi])
    rate = conclude_key_rate(keys, None).value
    assert 60.0 <= rate < 61.0
    times = frame_times(keys, rate, 1000)
    assert times is not None
    assert times[[0, -1]] == pytest.approx([0.0, np.pi])


def test_one_key_takes_any_rate() -> None:
    assert conclude_key_rate(np.array([3.0]), None).value == 30.0


def test_the_rate_that_is_asked_for_is_taken() -> None:
    assert conclude_key_rate(np.array([0.0, 0.1]), 7.5).value == 7.5


@pytest.mark.parametrize("fps", [0.0, -1.0, float("nan"), float("inf")])
def test_an_impossible_rate_is_refused(fps: float) -> None:
    with pytest.raises(ArgumentError, match="is impossible; it must be > 0"):
        conclude_key_rate(np.array([0.0, 0.1]), fps)


def test_frames_are_counted_before_they_are_made() -> None:
    assert frame_times(np.array([0.0, 1e9]), 60.0, 1000) is None
    times = frame_times(np.array([1.0, 1.5]), 4.0, 3)
    assert times is not None
    assert times.tolist() == [1.0, 1.25, 1.5]
