"""Every boundary of every sample is found: the samples know their supports exactly."""

from __future__ import annotations

import pytest
from tests.detection.foot_events import foot_events, noisy, worst_error

from footfall.detection import detect_supports
from footfall.samples import sample, sample_names
from footfall.support import SupportSequence

NAMES = pytest.mark.parametrize("name", sample_names())
RATES = pytest.mark.parametrize("fps", [30, 60, 120])


def allowed(fps: float) -> float:
    return max(1.5 / fps, 0.025)


@NAMES
@RATES
def test_every_boundary_of_a_clean_sample(name: str, fps: int) -> None:
    clip, supports = sample(name, fps=fps)
    assert worst_error(supports, detect_supports(clip)) <= allowed(fps)


@NAMES
@RATES
def test_every_boundary_under_two_millimeters_of_noise(name: str, fps: int) -> None:
    clip, supports = sample(name, fps=fps)
    assert worst_error(supports, detect_supports(noisy(clip, 0.002, seed=1))) <= allowed(fps)


@NAMES
@pytest.mark.parametrize("fps", [30, 60])
def test_phases_last_as_long_as_the_clip(name: str, fps: int) -> None:
    clip, _ = sample(name, fps=fps)
    found = detect_supports(clip)
    assert found.duration == pytest.approx(clip.duration, abs=1e-9)
    assert found.cyclic == clip.cyclic
    assert min(phase.duration for phase in found.phases) >= 0.06 - 1e-9


def test_a_missing_strike_is_an_infinite_error() -> None:
    one = SupportSequence.parse("R.4 D.1 L.4 D.1*")
    assert worst_error(one, one) == 0.0
    assert worst_error(one, SupportSequence.parse("D1*")) == float("inf")
    assert foot_events(one, 0) == [("release", 0.0), ("strike", 0.4)]
