from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from footfall.arrays import Floats, Positions
from footfall.blending.root import correct_displacement, mix_point
from footfall.geometry import transforms

some_points: Any = arrays(np.float64, (2, 2, 3), elements=st.floats(-1.0, 1.0))
some_steps: Any = st.tuples(st.floats(-0.1, 0.1), st.floats(-0.1, 0.1), st.floats(-0.2, 0.2))
sides = st.integers(0, 1)
shares = st.floats(0.0, 1.0)

Step = tuple[float, float, float]


def seen_from(step: Step, points: Positions) -> Positions:
    """Return where points that do not move are seen from a root that has made a step."""
    seen = np.array(points)
    for side in range(2):
        for point in range(2):
            x, z = points[side, point, 0] - step[0], points[side, point, 2] - step[1]
            seen[side, point, 0], seen[side, point, 2] = transforms.apply(0.0, 0.0, -step[2], x, z)
    return seen


def foot_slide(
    step: Step, before: Positions, after: Positions, side: int, point: int
) -> tuple[float, float]:
    """Return how far a foot point goes over the ground, seen from its root before the step."""
    x, z = transforms.apply(*step, after[side, point, 0], after[side, point, 2])
    return x - before[side, point, 0], z - before[side, point, 2]


def test_the_carrying_point_goes_from_heel_to_toe() -> None:
    points = np.zeros((2, 2, 3))
    points[1, 1] = [0.1, 0.2, 0.3]
    assert mix_point(points, 1, 0.0, 2) == 0.0
    assert mix_point(points, 1, 1.0, 2) == 0.3
    assert mix_point(points, 1, 0.25, 0) == pytest.approx(0.025)


@settings(deadline=None)
@given(some_steps, some_points, sides, shares)
def test_one_motion_alone_is_not_corrected(
    step: Step, points: Positions, side: int, share: float
) -> None:
    after = seen_from(step, points + np.array([0.01, 0.0, -0.02]))
    slides = [foot_slide(step, points, after, side, point) for point in range(2)]
    mixed = tuple((1.0 - share) * a + share * b for a, b in zip(*slides, strict=True))
    corrected = correct_displacement(
        step[2], (mixed[0], mixed[1]), points[:, :, ::2], after, side, share
    )
    assert corrected == pytest.approx(step[:2], abs=1e-12)


@settings(deadline=None)
@given(st.lists(some_points, min_size=2, max_size=2), shares, shares, sides)
def test_weights_that_move_do_not_slide_a_standing_foot(
    clips: list[Positions], weight: float, later: float, side: int
) -> None:
    before = weight * clips[0] + (1.0 - weight) * clips[1]
    after = later * clips[0] + (1.0 - later) * clips[1]
    x, z = correct_displacement(0.0, (0.0, 0.0), before[:, :, ::2], after, side, 0.0)
    stands = after[side, 0, [0, 2]] + [x, z]
    assert stands == pytest.approx(before[side, 0, [0, 2]], abs=1e-12)


def test_a_turning_root_keeps_the_foot() -> None:
    points: Floats = np.zeros((2, 2, 3))
    points[0, 0] = [0.1, 0.0, 0.2]
    x, z = correct_displacement(0.5 * math.pi, (0.0, 0.0), points[:, :, ::2], points, 0, 0.0)
    stands = transforms.apply(x, z, 0.5 * math.pi, 0.1, 0.2)
    assert stands == pytest.approx((0.1, 0.2))
