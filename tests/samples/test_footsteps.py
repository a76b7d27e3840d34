from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.arrays import Positions
from footfall.geometry import rotate
from footfall.samples.body import BALL_HEIGHT, HEEL_FROM_ANKLE
from footfall.samples.footsteps import FootPath, Stance, Swing, foot_path

STEP = Swing(((0.3, 0.06), (0.7, 0.05)))


def heels(path: FootPath) -> Positions:
    return path.ankles + rotate(path.rotations, np.array(HEEL_FROM_ANKLE))


@settings(deadline=None, max_examples=40)
@given(
    strike=st.floats(0.02, 0.6), leave=st.floats(-1.1, -0.02), heading=st.floats(-math.pi, math.pi)
)
def test_a_foot_rolls_over_its_heel_then_over_its_ball(
    strike: float, leave: float, heading: float
) -> None:
    stance = Stance(0.0, 0.6, (0.2, 0.4), heading, strike, leave, flat=0.1, rise=0.3)
    times = np.linspace(0.0, 0.6, 61)
    path = foot_path(times, [stance], [])
    hind = heels(path)
    rolling, flat, rising = times < 0.0999, (times >= 0.1) & (times <= 0.3), times >= 0.3
    assert np.ptp(hind[rolling | flat], axis=0) == pytest.approx(0.0, abs=1e-9)
    assert hind[rolling, 1] == pytest.approx(0.0, abs=1e-9)
    apart = path.balls[flat | rising] - np.array([0.2, BALL_HEIGHT, 0.4])
    assert np.abs(apart).max() < 1e-9
    assert path.balls[0, 1] > BALL_HEIGHT
    assert hind[-1, 1] > 0.0


def test_toes_stay_flat_while_the_heel_rises() -> None:
    stance = Stance(0.0, 0.6, (0.0, 0.0), leave_pitch=-1.0, rise=0.3)
    path = foot_path(np.linspace(0.0, 0.6, 61), [stance], [])
    assert path.angles[:, 1] + path.angles[:, 2] == pytest.approx(0.0, abs=1e-12)


@settings(deadline=None, max_examples=30)
@given(strike=st.floats(-0.4, 0.4), leave=st.floats(-1.1, 0.0))
def test_position_and_speed_are_continuous_into_and_out_of_a_swing(
    strike: float, leave: float
) -> None:
    stances = [
        Stance(0.0, 0.5, (0.0, 0.0), leave_pitch=leave),
        Stance(0.9, 1.5, (0.1, 0.8), strike_pitch=strike),
    ]
    small = 1e-5
    for edge in (0.5, 0.9):
        times = edge + small * np.array([-2.0, -1.0, 1.0, 2.0])
        path = foot_path(times, stances, [STEP])
        for values in (path.balls, path.angles):
            before, after = (values[1] - values[0]) / small, (values[3] - values[2]) / small
            assert np.abs(values[2] - values[1]).max() < 1e-3
            assert np.abs(after - before).max() < 0.03


def test_a_swing_passes_its_waypoints() -> None:
    swing = Swing(((0.5, 0.30),), ((0.5, -0.4),), ((0.5, 0.3, 0.2),))
    stances = [Stance(0.0, 0.5, (0.0, 0.0)), Stance(0.9, 1.5, (0.0, 0.8))]
    path = foot_path(np.array([0.7]), stances, [swing])
    assert path.balls[0] == pytest.approx([0.3, BALL_HEIGHT + 0.30, 0.2])
    assert path.angles[0, 1] == pytest.approx(-0.4)


def test_a_heel_that_rises_in_between_leaves_the_ball_where_it_is() -> None:
    stance = Stance(-9.0, 9.0, (0.1, 0.0), lifts=((0.2, 0.0), (0.5, -0.5), (0.8, 0.0)))
    path = foot_path(np.linspace(0.0, 1.0, 51), [stance], [])
    assert np.ptp(path.balls, axis=0) == pytest.approx(0.0, abs=1e-12)
    assert heels(path)[25, 1] > 0.05
    assert heels(path)[-1, 1] == pytest.approx(0.0, abs=1e-6)
