"""A ground that rises while it is walked on."""

from __future__ import annotations

import numpy as np
import pytest
from footfall.scenario.ground_lift import LIFT_SPEED, GroundLift

from footfall.scenario.cue_sheet import Cue, parse_scenario
from footfall.scenario.performance import perform

SHEET = """
duration = 2.0
[[action]]
name = "walk"
motion = "sample:walk"
[[cue]]
at = 0.0
start = "walk"
"""


def test_it_moves_steadily_and_stops_where_it_was_asked_to() -> None:
    lift = GroundLift(asked=0.1)
    heights: list[float] = []
    while lift.advance(1.0 / 60.0):
        heights.append(lift.height)
    assert np.diff(heights)[:-1] == pytest.approx(LIFT_SPEED / 60.0)
    assert heights[-1] == pytest.approx(0.1)
    lift.asked = -0.1
    assert lift.advance(0.1)
    assert lift.height == pytest.approx(0.06)


def test_a_cue_raises_the_ground_and_changes_nothing_else() -> None:
    sheet = SHEET + "[[cue]]\nat = 0.5\nground = 0.2\n"
    scenario = parse_scenario(sheet)
    assert scenario.cues[1] == Cue(0.5, "ground", ground=0.2)
    flat, raised = perform(parse_scenario(SHEET)), perform(scenario)
    up = raised.recording.world_positions - flat.recording.world_positions
    assert up[..., [0, 2]] == pytest.approx(0.0, abs=1e-9)
    np.testing.assert_allclose(up[..., 1], np.tile(raised.lifts[:, None], (1, up.shape[1])))
    assert raised.lifts[[0, 30, 45, -1]] == pytest.approx([0.0, 0.0, 0.1, 0.2])
    assert not flat.lifts.any()
