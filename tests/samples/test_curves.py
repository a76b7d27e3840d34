from __future__ import annotations

import numpy as np
import pytest

from footfall.samples.curves import GRAVITY, ballistic_speeds, keyed, quintic, waypoints


def test_between_two_knots_of_one_parabola_lies_the_parabola() -> None:
    up, down = ballistic_speeds(-0.1, 0.4)
    times = np.linspace(0.0, 0.4, 41)
    heights = quintic(times, [(0.0, 1.0, up, -GRAVITY), (0.4, 0.9, down, -GRAVITY)])
    assert heights == pytest.approx(1.0 + up * times - 0.5 * GRAVITY * times**2, abs=1e-12)


def test_a_quintic_stays_on_its_ends() -> None:
    knots = [(0.0, 1.0, 0.0, 0.0), (1.0, 2.0, 0.0, 0.0)]
    assert quintic(np.array([-1.0, 0.0, 1.0, 9.0]), knots).tolist() == [1.0, 1.0, 2.0, 2.0]


def test_waypoints_are_met_with_the_slopes_asked_for() -> None:
    knots = [(0.0, 1.0), (0.4, 3.0), (1.0, 2.0)]
    values = waypoints(np.array([0.0, 1e-6, 0.4, 1.0 - 1e-6, 1.0]), knots, (2.0, -3.0))
    assert values[[0, 2, 4]] == pytest.approx([1.0, 3.0, 2.0])
    assert (values[1] - values[0]) / 1e-6 == pytest.approx(2.0, abs=1e-3)
    assert (values[4] - values[3]) / 1e-6 == pytest.approx(-3.0, abs=1e-3)


def test_keyed_curves_never_overshoot_and_turn_smoothly() -> None:
    nodes, values = [0.0, 0.3, 0.4, 1.0], np.array([[0.0], [1.0], [1.0], [-2.0]])
    times = np.linspace(-0.5, 1.5, 2001)
    curve = keyed(times, nodes, values)[:, 0]
    assert curve.max() <= 1.0 + 1e-12
    assert curve.min() >= -2.0 - 1e-12
    assert curve[0] == pytest.approx(0.0, abs=1e-12)
    assert curve[-1] == pytest.approx(-2.0, abs=1e-12)
    acceleration = np.diff(curve, n=2) * 1e6
    assert np.abs(np.diff(acceleration)).max() < 4.0
