"""The live slip meter: what slides is counted, what is carried or swings is not."""

from __future__ import annotations

import numpy as np
import pytest

from footfall.studio.slip_meter import SlipMeter
from footfall.support import Support

POINTS = np.array([[[0.1, 0.0, 0.0], [0.1, 0.0, 0.2]], [[-0.1, 0.0, 0.0], [-0.1, 0.0, 0.2]]])


def measured(
    way: tuple[float, float, float],
    support: Support,
    carried: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> SlipMeter:
    """Move both feet by `way`, and the ground by `carried`, in each of ten frames."""
    meter = SlipMeter(0.04)
    for frame in range(11):
        points = POINTS + frame * np.array(way)
        ground = np.tile(frame * np.array(carried), (2, 1))
        meter.measure(points, points[..., 1] - ground[:, np.newaxis, 1], ground, support)
    return meter


def test_a_foot_that_slides_is_counted() -> None:
    meter = measured((0.003, 0.0, 0.004), Support.LEFT)
    assert meter.slid == pytest.approx([0.05, 0.0])
    assert meter.total == pytest.approx(0.05)


def test_a_foot_that_swings_is_not() -> None:
    assert measured((0.01, 0.0, 0.0), Support.FLIGHT).total == 0.0


def test_a_foot_that_the_ground_carries_is_not() -> None:
    carried = (0.01, 0.02, 0.0)
    assert measured(carried, Support.DOUBLE, carried).total == pytest.approx(0.0, abs=1e-12)


def test_a_new_step_begins_at_zero_and_the_total_goes_on() -> None:
    meter = measured((0.01, 0.0, 0.0), Support.LEFT)
    none = np.zeros((2, 3))
    meter.measure(POINTS, POINTS[..., 1], none, Support.FLIGHT)
    assert meter.slid[0] == pytest.approx(0.1)
    meter.measure(POINTS, POINTS[..., 1], none, Support.LEFT)
    assert meter.slid[0] == 0.0
    assert meter.total == pytest.approx(0.1)
