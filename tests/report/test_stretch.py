from __future__ import annotations

import json
import math

import numpy as np
import pytest

from footfall.errors import ArgumentError
from footfall.report import Delay, PlayedPhase, Stretch, measure_schedule
from footfall.support import Support

L, R, FLIGHT = Support.LEFT, Support.RIGHT, Support.FLIGHT
NAN = math.nan


@pytest.mark.parametrize(("clock", "octaves"), [(0.4, 0.0), (0.8, 1.0), (0.2, 1.0), (1.6, 2.0)])
def test_stretch_is_counted_in_octaves_either_way(clock: float, octaves: float) -> None:
    assert PlayedPhase(clock, 0.4, L).octaves == pytest.approx(octaves)


@pytest.mark.parametrize(
    ("clock", "clip", "message"),
    [
        (0.0, 1.0, "a played phase lasts 0.0 s on the clock; it must be > 0"),
        (1.0, -1.0, "a played phase lasts -1.0 s in its clip; it must be > 0"),
        (1.0, NAN, "a played phase lasts nan s in its clip; it must be > 0"),
    ],
)
def test_a_phase_that_cannot_have_been_played_says_why(
    clock: float, clip: float, message: str
) -> None:
    with pytest.raises(ArgumentError) as caught:
        PlayedPhase(clock, clip, L)
    assert str(caught.value) == message


def test_a_schedule_in_figures() -> None:
    walk = [PlayedPhase(0.4, 0.4, L), PlayedPhase(0.8, 0.4, R)]
    run = [PlayedPhase(0.2, 0.2, R), PlayedPhase(0.1, 0.4, FLIGHT)]
    delays = [Delay(1.0, 1.0), Delay(2.0, 2.5, "the left foot has to land"), Delay(3.0, None, "no")]
    rates = np.array([[1.0, NAN], [1.5, NAN], [1.25, 0.5], [NAN, 1.0]])
    report = measure_schedule([walk, run], [0.4, 0.05, 0.0999, 0.1], delays, rates)
    assert json.loads(json.dumps(report.to_json(), allow_nan=False)) == {
        "stretch": {"mean": 0.75, "p95": 1.85, "max": 2.0, "count": 4},
        "flight_stretch": {"mean": 2.0, "p95": 2.0, "max": 2.0, "count": 1},
        "delay_s": {"median": 0.25, "p95": 0.475, "max": 0.5, "count": 2, "never": 1},
        "delay_reasons": ["the left foot has to land", "no"],
        "short_phases": 2,
        "short_phase_share": 0.5,
        "rate_min": 0.5,
        "rate_max": 1.5,
        "rate_jump": 0.5,
    }


def test_a_schedule_of_nothing_has_no_figures() -> None:
    report = measure_schedule([], [], [], np.zeros((3, 0)))
    assert report.stretch == Stretch(0, None, None, None)
    assert (report.short_phases, report.short_share) == (0, None)
    assert (report.slowest_rate, report.fastest_rate, report.greatest_jump) == (None, None, None)
