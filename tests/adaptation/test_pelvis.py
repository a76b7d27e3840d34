from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from tests import walking_figure

from footfall.adaptation.pelvis import needed_drop
from footfall.arrays import Floats
from footfall.skeleton.rig import Rig, rig_of
from footfall.skeleton.two_bone_ik import SOFT_REACH

HEIGHT = 0.9


def rig() -> Rig:
    return rig_of(walking_figure.skeleton(), walking_figure.anatomy())


def drop_for(body: Rig, ankle: Floats, offset: Floats) -> float:
    """Return how far a hip 0.9 m up has to sink."""
    hip = (0.0, HEIGHT, 0.0)
    return needed_drop(body.leg_length, hip, vector(ankle), vector(offset))


def vector(array: Floats) -> tuple[float, float, float]:
    x, y, z = (float(number) for number in array)
    return x, y, z


def reach_after(ankle: Floats, offset: Floats, drop: float) -> float:
    hip = np.array([0.0, HEIGHT - drop, 0.0])
    return float(np.linalg.norm(hip - ankle - offset))


def test_a_leg_that_reaches_needs_no_drop() -> None:
    body = rig()
    ankle = np.array([0.0, HEIGHT - 0.8 * body.leg_length, 0.0])
    assert drop_for(body, ankle, np.array([0.02, 0.0, 0.05])) == 0.0


def test_a_leg_may_stay_as_straight_as_it_is() -> None:
    body = rig()
    ankle = np.array([0.0, HEIGHT - 0.999 * body.leg_length, 0.0])
    assert drop_for(body, ankle, np.zeros(3)) == 0.0


offsets: Any = st.tuples(*[st.floats(-0.3, 0.3)] * 3).map(np.array)


@settings(deadline=None)
@given(st.floats(0.3, 0.99), offsets)
def test_after_the_drop_the_leg_reaches_and_not_more_than_that(
    share: float, offset: Floats
) -> None:
    body = rig()
    ankle = np.array([0.0, HEIGHT - share * body.leg_length, 0.0])
    longest = max(SOFT_REACH, share) * body.leg_length
    assume(np.hypot(offset[0], offset[2]) < longest)
    drop = drop_for(body, ankle, offset)
    assert drop >= 0.0
    reach = reach_after(ankle, offset, drop)
    if drop > 0.0:
        assert reach == pytest.approx(longest, abs=1e-9)
    else:
        assert reach <= longest + 1e-9 or HEIGHT - ankle[1] - offset[1] < 0.0


def test_a_print_too_far_to_the_side_is_not_reached_by_sinking() -> None:
    body = rig()
    ankle = np.array([0.0, HEIGHT - 0.8 * body.leg_length, 0.0])
    assert drop_for(body, ankle, np.array([2.0, 0.0, 0.0])) == 0.0
