from __future__ import annotations

import numpy as np
import pytest

from footfall.detection.pinning import FootSpan, foot_spans, pinned_offsets, resting_levels
from footfall.detection.tracks import PlanarStep
from footfall.support import SupportSequence


def flat(spans: tuple[FootSpan, ...]) -> list[float]:
    return [time for span in spans for time in (span.start, span.end)]


def test_spans_join_the_phases_in_which_a_foot_carries() -> None:
    supports = SupportSequence.parse("D.1 L.3 -.1 R.2 D.3")
    assert flat(foot_spans(supports, 0)) == pytest.approx([0.0, 0.4, 0.7, 1.0])
    assert flat(foot_spans(supports, 1)) == pytest.approx([0.0, 0.1, 0.5, 1.0])


def test_a_span_over_the_end_of_a_cycle_is_one() -> None:
    supports = SupportSequence.parse("D.1 L.4 D.1 R.4*")
    assert flat(foot_spans(supports, 0)) == pytest.approx([1.0, 1.6])
    assert flat(foot_spans(supports, 1)) == pytest.approx([0.5, 1.1])
    assert flat(foot_spans(SupportSequence.parse("D.7 L.3*"), 0)) == pytest.approx([0.0, 1.0])


def sliding(slide: float) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Return heel and toe that stand on 0.2 s to 0.8 s of a second, sliding that fast [m/s]."""
    times = np.arange(121) / 120.0
    points = np.zeros((121, 2, 3))
    points[:, 1, 2] = 0.15
    points[:, :, 2] += slide * (times[:, np.newaxis] - 0.5)
    lift = np.maximum(np.abs(times - 0.5) - 0.3, 0.0)
    points[:, :, 1] = 0.05 + lift[:, np.newaxis]
    return points


def test_a_slide_is_taken_out_and_shared_to_both_sides() -> None:
    spans = (FootSpan(0.2, 0.8),)
    points = sliding(0.1)
    offsets = pinned_offsets(points, spans, 120.0, PlanarStep(), cyclic=False)
    held = slice(32, 89)
    np.testing.assert_allclose(np.diff((points[:, 0] + offsets)[held, 2]), 0.0, atol=2e-5)
    assert offsets[24:97].mean(axis=0) == pytest.approx([0.0, 0.0, 0.0], abs=1e-9)
    # Before the first and after the last span the foot keeps the offset of the span's end.
    np.testing.assert_array_equal(offsets[:24], np.broadcast_to(offsets[24], (24, 3)))
    np.testing.assert_array_equal(offsets[97:], np.broadcast_to(offsets[96], (24, 3)))


def test_the_level_is_where_a_point_rests_in_its_spans() -> None:
    levels = resting_levels(sliding(0.0), (FootSpan(0.2, 0.8),), 120.0)
    np.testing.assert_allclose(levels, 0.05, atol=1e-9)


def test_a_foot_that_never_carries_is_not_moved() -> None:
    assert not pinned_offsets(sliding(0.1), (), 120.0, PlanarStep(), cyclic=False).any()


def test_offsets_of_a_cycle_turn_with_it() -> None:
    step = PlanarStep(np.pi / 2, 0.3, 0.0)
    points = sliding(0.1)
    # Both ends of the way are off the ground; make the last frame the first, one cycle on.
    ramp = np.clip((np.arange(121) - 100.0) / 20.0, 0.0, 1.0)[:, np.newaxis, np.newaxis]
    points = (1.0 - ramp) * points + ramp * step.apply(points[0])
    offsets = pinned_offsets(points, (FootSpan(0.2, 0.8),), 120.0, step, cyclic=True)
    turned = PlanarStep(np.pi / 2).apply(offsets[0])
    np.testing.assert_allclose(offsets[-1], turned, atol=1e-9)
    assert np.abs(np.diff(offsets, axis=0)).max() < 0.003
