from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.adaptation.footprints import (
    GRIP_TIME,
    LIFT_SPEED,
    LOWER,
    SLOWER,
    approach,
    gentle_spring,
    hold_foot,
    release_foot,
    spring,
    toe_lead,
)
from footfall.arrays import Floats

DT = 1.0 / 60.0
NOWHERE = (0.0, 0.0, 0.0)
"""A foot on its way to no particular place."""

numbers = st.floats(-1.0, 1.0)
times = st.floats(0.0, 0.5)


def still() -> tuple[Floats, Floats]:
    return np.zeros(3), np.zeros(3)


@settings(deadline=None)
@given(numbers, numbers, numbers, st.floats(1.0, 50.0), times, times)
def test_a_spring_does_not_care_how_time_is_cut(
    value: float, speed: float, goal: float, stiffness: float, one: float, other: float
) -> None:
    whole = spring(value, speed, goal, stiffness, one + other)
    half = spring(value, speed, goal, stiffness, one)
    assert spring(*half, goal, stiffness, other) == pytest.approx(whole, abs=1e-9)


def test_a_spring_from_rest_comes_to_its_goal_without_passing_it() -> None:
    value, speed = 1.0, 0.0
    for _ in range(120):
        before = value
        value, speed = spring(value, speed, 0.0, 14.0, DT)
        assert 0.0 <= value <= before
    assert value < 1e-6


@settings(deadline=None)
@given(numbers, numbers, numbers, st.floats(1.0, 50.0), st.floats(1e-3, 0.1))
def test_a_gentle_spring_is_a_spring_that_is_never_accelerated_more_than_told(
    value: float, speed: float, goal: float, stiffness: float, dt: float
) -> None:
    _, after = gentle_spring(value, speed, goal, stiffness, 30.0, dt)
    assert abs(after - speed) <= 30.0 * dt + 1e-9
    free = gentle_spring(value, speed, goal, stiffness, 1e9, dt)
    assert free == spring(value, speed, goal, stiffness, dt)


def test_a_gentle_spring_comes_to_its_goal_too() -> None:
    value, speed = 0.2, 0.0
    for _ in range(120):
        value, speed = gentle_spring(value, speed, 0.0, 30.0, 40.0, DT)
        assert value > -0.01
    assert abs(value) < 1e-4


@settings(deadline=None)
@given(numbers, numbers, st.floats(0.01, 0.5), times, times)
def test_an_approach_does_not_care_how_time_is_cut(
    value: float, goal: float, time: float, one: float, other: float
) -> None:
    whole = approach(value, goal, time, one + other)
    halves = approach(approach(value, goal, time, one), goal, time, other)
    assert halves == pytest.approx(whole, abs=1e-12)


def test_the_lower_point_carries_and_of_two_level_ones_the_slower() -> None:
    assert toe_lead(2.0 * LOWER, 0.0, 0.0, 0.0) > 1.0
    assert toe_lead(0.0, 2.0 * LOWER, 0.0, 0.0) < -1.0
    assert toe_lead(0.0, 0.0, 2.0 * SLOWER, 0.0) > 1.0
    assert toe_lead(0.0, 0.0, 0.0, 2.0 * SLOWER) < -1.0
    assert abs(toe_lead(0.001, 0.001, 0.5, 0.5)) < 1e-9


def test_a_foot_held_firmly_takes_back_every_slide() -> None:
    offset, velocity = still()
    for _ in range(10):
        hold_foot(offset, velocity, (0.003, -0.002), 0.0, 1.0, DT)
    assert offset == pytest.approx([-0.03, 0.0, 0.02])
    assert velocity[[0, 2]] == pytest.approx([-0.003 / DT, 0.002 / DT])


@pytest.mark.parametrize("grip", [0.0, 0.25, 1.0])
def test_a_foot_is_held_in_proportion_to_its_grip(grip: float) -> None:
    offset, velocity = still()
    hold_foot(offset, velocity, (0.004, 0.0), 0.0, grip, DT)
    assert offset[0] == pytest.approx(-0.004 * grip)


def test_a_carrying_foot_settles_to_the_height_of_the_ground() -> None:
    offset, velocity = still()
    heights: list[float] = []
    for _ in range(60):
        hold_foot(offset, velocity, (0.0, 0.0), -0.02, 1.0, DT)
        heights.append(0.02 + float(offset[1]))
    assert heights[0] > 0.015
    assert min(heights) >= 0.0
    assert heights[-1] < 1e-6


def test_a_released_foot_goes_on_without_a_jump_and_comes_back() -> None:
    offset, velocity = np.array([0.05, 0.0, 0.0]), np.array([0.2, 0.0, 0.0])
    path = [0.05]
    for _ in range(60):
        release_foot(offset, velocity, NOWHERE, -0.1, LIFT_SPEED, DT)
        path.append(float(offset[0]))
    # A spring of 14 /s accelerates by at most 14² times how far it is, and twice 14 its speed.
    assert np.abs(np.diff(path, n=2) / DT**2).max() < 14.0**2 * 0.06 + 28.0 * 0.2
    assert abs(path[-1]) < 1e-4


def test_a_swinging_foot_is_not_let_below_the_ground() -> None:
    offset, velocity = np.array([0.0, -0.03, 0.0]), np.array([0.0, -1.0, 0.0])
    release_foot(offset, velocity, NOWHERE, -0.01, LIFT_SPEED, DT)
    assert offset[1] == -0.01
    assert velocity[1] >= 0.0


def test_a_swinging_foot_is_raised_over_what_lies_ahead() -> None:
    offset, velocity = still()
    for _ in range(30):
        release_foot(offset, velocity, (0.0, 0.18, 0.0), -1.0, LIFT_SPEED, DT)
    assert offset[1] == pytest.approx(0.18, abs=0.001)


def test_without_time_nothing_is_divided_by_it() -> None:
    offset, velocity = still()
    hold_foot(offset, velocity, (0.001, 0.0), 0.01, 1.0, 0.0)
    release_foot(offset, velocity, NOWHERE, 0.0, LIFT_SPEED, 0.0)
    assert np.isfinite(offset).all()
    assert np.isfinite(velocity).all()
    assert GRIP_TIME > 0.0
