from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.geometry import from_axis_angle, multiply, rotate
from footfall.samples.body import SHANK, THIGH
from footfall.samples.limbs import arm_rotations, extension, from_axes, leg_rotations, share

DOWN = np.array([0.0, -1.0, 0.0])
AHEAD = np.array([0.0, 0.0, 1.0])


@settings(deadline=None)
@given(st.tuples(*[st.floats(-1.0, 1.0)] * 4).filter(lambda q: sum(v * v for v in q) > 0.01))
def test_axes_and_rotation_say_the_same(components: tuple[float, ...]) -> None:
    rotation = np.array(components) / np.linalg.norm(components)
    x_axis, y_axis = (rotate(rotation, np.eye(3)[i]) for i in range(2))
    found = from_axes(x_axis, y_axis)
    assert abs(float(found @ rotation)) == pytest.approx(1.0, abs=1e-12)


@settings(deadline=None)
@given(
    x=st.floats(-0.3, 0.3),
    y=st.floats(-0.8, -0.2),
    z=st.floats(-0.7, 0.7),
    heading=st.floats(-1.0, 1.0),
)
def test_a_leg_ends_at_its_ankle_with_the_knee_ahead(
    x: float, y: float, z: float, heading: float
) -> None:
    hip, ankle = np.zeros(3), np.array([x, y, z])
    if extension(hip, ankle) > 0.985:
        return
    thigh, shank = leg_rotations(hip, ankle, np.array(heading))
    knee = THIGH * rotate(thigh, DOWN)
    assert knee + SHANK * rotate(shank, DOWN) == pytest.approx(ankle, abs=1e-12)
    line = ankle / np.linalg.norm(ankle)
    off = knee - line * float(knee @ line)
    assert float(off @ rotate(thigh, AHEAD)) > 0.0


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_arm_angles_mean_what_they_say(side: float) -> None:
    out = np.array([side, 0.0, 0.0])

    def pointing(**degrees: float) -> tuple[list[float], list[float]]:
        names = ("turn", "flexion", "abduction", "external", "elbow")
        angles = np.radians([degrees.get(name, 0.0) for name in names])
        upper, lower = arm_rotations(angles, side)
        both = (rotate(upper, out), rotate(multiply(upper, lower), out))
        first, second = (np.round(direction, 9).tolist() for direction in both)
        return first, second

    down, ahead, up = [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]
    assert pointing() == (down, down)
    assert pointing(elbow=90.0) == (down, ahead)
    assert pointing(flexion=90.0) == (ahead, ahead)
    assert pointing(abduction=90.0) == (out.tolist(), out.tolist())
    assert pointing(abduction=90.0, external=90.0, elbow=90.0) == (out.tolist(), up)
    assert pointing(flexion=90.0, turn=90.0)[0] == out.tolist()


@pytest.mark.parametrize("angle", [0.0, 1e-9, 0.5, -2.0, 3.1])
def test_thirds_add_up_to_the_whole(angle: float) -> None:
    whole = from_axis_angle(np.array([0.6, 0.0, 0.8]), angle)
    third = share(whole, 1.0 / 3.0)
    again = multiply(multiply(third, third), third)
    assert abs(float(again @ whole)) == pytest.approx(1.0, abs=1e-12)
