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

LEFT = 0
HEIGHT = 0.9


def rig() -> Rig:
    return rig_of(walking_figure.skeleton(), walking_figure.anatomy())


def standing(body: Rig) -> Floats:
    """Return the joints, of which only the hips count, at a height of 0.9 m."""
    positions = np.zeros((len(body.parents), 3))
    positions[body.limbs[:, 0], 1] = HEIGHT
    return positions


def reach_after(ankle: Floats, offset: Floats, drop: float) -> float:
    hip = np.array([0.0, HEIGHT - drop, 0.0])
    return float(np.linalg.norm(hip - ankle - offset))


def test_a_leg_that_reaches_needs_no_drop() -> None:
    body = rig()
    ankle = np.array([0.0, HEIGHT - 0.8 * body.leg_length, 0.0])
    assert needed_drop(body, LEFT, ankle, np.array([0.02, 0.0, 0.05]), standing(body)) == 0.0


def test_a_leg_may_stay_as_straight_as_it_is() -> None:
    body = rig()
    ankle = np.array([0.0, HEIGHT - 0.999 * body.leg_length, 0.0])
    assert needed_drop(body, LEFT, ankle, np.zeros(3), standing(body)) == 0.0


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
    drop = needed_drop(body, LEFT, ankle, offset, standing(body))
    assert drop >= 0.0
    reach = reach_after(ankle, offset, drop)
    if drop > 0.0:
        assert reach == pytest.approx(longest, abs=1e-9)
    else:
        assert reach <= longest + 1e-9 or HEIGHT - ankle[1] - offset[1] < 0.0


def test_a_print_too_far_to_the_side_is_not_reached_by_sinking() -> None:
    body = rig()
    ankle = np.array([0.0, HEIGHT - 0.8 * body.leg_length, 0.0])
    assert needed_drop(body, LEFT, ankle, np.array([2.0, 0.0, 0.0]), standing(body)) == 0.0
