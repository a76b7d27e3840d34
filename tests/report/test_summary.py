from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.report.bodies import LEFT, RIGHT, resting_feet, slide, trace_of

from footfall.report import MethodReport, Pops, Trace, measure

GOLDEN = Path(__file__).parents[1] / "golden" / "report"

FRAMES = 120
COMMANDED = "L" * 40 + "R" * 40 + "L" * 40


def staged() -> Trace:
    """Return a left foot that slides 10 mm alone, and 20 mm in a mix; between, a transition."""
    points = resting_feet(FRAMES)
    points[:40, LEFT, :, 2] += slide(40, 0.010)[:, np.newaxis]
    points[40:, LEFT, :, 2] += 0.010
    points[80:, LEFT, :, 2] += slide(40, 0.020)[:, np.newaxis]
    points[40:80, RIGHT, :, 0] -= 0.005 * np.sin(np.arange(40) / 10.0)[:, np.newaxis]
    points[40:80, RIGHT, :, 1] = -0.003
    points[80:, LEFT, :, 1] = 0.004
    fading = np.interp(np.arange(FRAMES), [45, 75], [0.0, 0.5])
    return trace_of(points, COMMANDED, shares=np.stack([1.0 - fading, fading], axis=-1))


def staged_report() -> MethodReport:
    contacts = np.array([[symbol == "L", symbol == "R"] for symbol in COMMANDED])
    contacts[50:53] = False
    sources = np.full((FRAMES, 2), 0.001)
    clips = Pops(1.0, 1.0, 50.0, 50.0, 10.0)
    return measure(staged(), contacts=contacts, source_slips=sources, source_pops=clips)


def test_the_report_of_a_staged_motion_is_the_one_kept() -> None:
    found = json.loads(json.dumps(staged_report().to_json(), allow_nan=False))
    assert found == json.loads((GOLDEN / "staged.json").read_text())


def test_each_group_has_the_slip_that_was_staged() -> None:
    report = staged_report()
    assert report.whole_slip.alone.maximum == pytest.approx(10.0)
    assert report.whole_slip.mixes.maximum == pytest.approx(20.0)
    assert report.slip.mixes.maximum == pytest.approx(20.0 * 31 / 39)
    assert report.excess.mixes.maximum == pytest.approx(20.0 * 31 / 39 - 1.0)
    assert report.penetration.transitions.median == pytest.approx(3.0)
    assert report.floating.mixes.p95 == pytest.approx(4.0)
    assert report.slip.transitions.count == 1


def numbers(value: Any) -> list[Any]:
    if isinstance(value, dict):
        return [leaf for item in value.values() for leaf in numbers(item)]  # pyright: ignore
    return [value]


def test_a_motion_without_spans_sources_or_detector_has_the_same_keys_and_no_number() -> None:
    bare = measure(trace_of(resting_feet(3), "---")).to_json()
    assert bare.keys() == staged_report().to_json().keys()
    assert bare["slip_mm"] == {
        **(nothing := {"median": None, "p95": None, "max": None, "count": 0}),
        "alone": nothing,
        "transitions": nothing,
        "mixes": nothing,
    }
    assert (bare["mismatch"], bare["pop_ratios"]) == (None, None)


@pytest.mark.parametrize("frames", [1, 2, 3, 9])
def test_every_number_of_a_report_is_finite_or_none(frames: int) -> None:
    report = measure(trace_of(resting_feet(frames), "L" * frames, fps=30.0)).to_json()
    json.dumps(report, allow_nan=False)
    assert all(value is None or np.isfinite(value) for value in numbers(report))


def test_nothing_depends_on_the_frame_rate_of_an_even_motion() -> None:
    frames = 61
    points = resting_feet(frames)
    points[:, LEFT, :, 2] += slide(frames, 0.1)[:, np.newaxis]
    slow = measure(trace_of(points[::2], "L" * 31, fps=30.0)).to_json()
    assert slow == measure(trace_of(points, "L" * frames)).to_json()


def test_the_surface_under_the_heel_is_under_the_ankle() -> None:
    points = resting_feet(20)
    points[:, LEFT, :, 2] += slide(20, 0.1)[:, np.newaxis]
    low = measure(trace_of(points, "L" * 20))
    points[..., 1] += 5.0
    assert low.weighted_skate > 0.0
    assert measure(trace_of(points, "L" * 20, ground=5.0)).weighted_skate == low.weighted_skate
    assert measure(trace_of(points, "L" * 20)).weighted_skate == 0.0


def test_the_floor_of_the_skate_metrics_is_where_the_toes_rest() -> None:
    points = resting_feet(20)
    points[:, LEFT, :, 2] += slide(20, 0.4)[:, np.newaxis]
    on_floor, sunk = trace_of(points, "L" * 20), points.copy()
    sunk[..., 1] -= 0.07
    below = trace_of(sunk, "L" * 20, resting_levels=np.full((2, 2), -0.07))
    one, other = measure(on_floor), measure(below)
    assert one.skating_ratio == other.skating_ratio == 1.0
    assert one.weighted_skate == pytest.approx(other.weighted_skate)


def test_a_foot_on_a_platform_does_not_skate() -> None:
    way = np.stack([slide(20, 1.0), np.zeros(20), slide(20, 2.0)], axis=-1)
    points = resting_feet(20) + way[:, np.newaxis, np.newaxis]
    report = measure(trace_of(points, "L" * 20, surface_displacement=way))
    assert report.weighted_skate == pytest.approx(0.0, abs=1e-9)
    assert report.skating_ratio == 0.0


def test_a_faster_clip_is_not_livelier() -> None:
    points = resting_feet(60)
    points[..., 0] += (0.2 * np.sin(np.arange(60) / 8.0))[:, np.newaxis, np.newaxis]
    own = measure(trace_of(points, "L" * 60)).pops
    doubled = measure(trace_of(points, "L" * 60, rates=np.full(60, 2.0))).pops
    assert own is not None
    assert doubled is not None
    assert doubled.speed_max == pytest.approx(own.speed_max / 2.0)
    assert doubled.acceleration_max == pytest.approx(own.acceleration_max / 4.0)
