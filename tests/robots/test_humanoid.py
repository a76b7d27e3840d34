from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from footfall.errors import ArgumentError
from footfall.robots import humanoid_mjcf, our_robot

mujoco: Any = pytest.importorskip("mujoco")


@pytest.mark.parametrize("stature", [0.5, 1.2, 1.75, 2.5])
def test_it_stands_on_the_floor_as_tall_as_asked(stature: float) -> None:
    model = mujoco.MjModel.from_xml_string(humanoid_mjcf(stature))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    feet = [
        data.geom_xpos[g, 2] - model.geom_size[g, 2]
        for g in range(model.ngeom)
        if model.geom_type[g] == mujoco.mjtGeom.mjGEOM_BOX
    ]
    assert np.abs(feet).max() < 0.01 * stature
    head = data.xpos[model.body("head").id, 2]
    assert 0.85 * stature < head + 0.13 * stature < 1.02 * stature


def test_a_person_of_average_stature_has_a_person_s_mass() -> None:
    model = mujoco.MjModel.from_xml_string(humanoid_mjcf())
    assert 60.0 < model.body_mass.sum() < 80.0


def test_both_sides_are_alike() -> None:
    robot = our_robot()
    model = robot.model
    for name in robot.hinges:
        if not name.startswith("left"):
            continue
        left, right = (model.joint(side + name[4:]) for side in ("left", "right"))
        mirrored = name.endswith(("yaw", "roll"))
        wanted = -left.range[::-1] if mirrored else left.range
        np.testing.assert_allclose(right.range, wanted)
        np.testing.assert_array_equal(left.axis, right.axis)


def test_zero_is_within_the_range_of_every_hinge_and_each_has_a_motor() -> None:
    model = our_robot().model
    assert model.nu == model.njnt - 1 == 25
    assert (model.jnt_range[1:, 0] <= 0.0).all()
    assert (model.jnt_range[1:, 1] >= 0.0).all()
    assert model.jnt_limited[1:].all()


@pytest.mark.parametrize("stature", [0.4, 3.0, float("nan")])
def test_an_impossible_stature_is_refused(stature: float) -> None:
    with pytest.raises(ArgumentError) as caught:
        humanoid_mjcf(stature)
    assert str(caught.value) == f"stature is {stature} m; it must be within 0.5 to 2.5 m"
