"""A ground that rises, tilts and is exchanged while it is walked on."""

from __future__ import annotations

import math

import numpy as np
import pytest

from footfall.adaptation import HeightField, Plane, Terrain, ground_heights
from footfall.errors import ScenarioError
from footfall.scenario.cue_sheet import Cue, parse_scenario
from footfall.scenario.ground_change import GROUND_KINDS, GroundChange, GroundKind
from footfall.scenario.moving_ground import LIFT_SPEED, TILT_SPEED, MovingGround
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

HERE = (2.0, -3.0, 0.4)


def height_at(ground: MovingGround, x: float, z: float) -> float:
    return float(ground_heights(ground.ground, np.array([x, 0.0, z]), np.zeros(())))


def test_it_rises_steadily_and_stops_where_it_was_asked_to() -> None:
    ground = MovingGround(0.5, GroundChange(0.1))
    heights: list[float] = []
    while ground.advance(1.0 / 60.0, HERE):
        heights.append(ground.height)
    assert np.diff(heights)[:-1] == pytest.approx(LIFT_SPEED / 60.0)
    assert heights[-1] == pytest.approx(0.1)
    assert ground.ground == Plane(0.6)
    ground.ask(GroundChange(-0.1), HERE)
    assert ground.advance(0.1, HERE)
    assert ground.height == pytest.approx(0.06)


def test_it_tilts_steadily_about_whoever_is_on_it() -> None:
    ground = MovingGround(0.5)
    ground.ask(GroundChange(slope=(0.03, 0.04)), HERE)
    steepness: list[float] = []
    while ground.advance(1.0 / 60.0, HERE):
        steepness.append(math.hypot(*ground.slope))
        assert height_at(ground, HERE[0], HERE[1]) == pytest.approx(0.5)
    assert np.diff(steepness)[:-1] == pytest.approx(TILT_SPEED / 60.0)
    assert ground.slope == (0.03, 0.04)
    assert height_at(ground, HERE[0] + 1.0, HERE[1]) == pytest.approx(0.53)


@pytest.mark.parametrize("kind", GROUND_KINDS)
def test_what_is_put_on_it_begins_ahead_and_goes_along(kind: GroundKind) -> None:
    ground = MovingGround(0.2)
    ground.ask(GroundChange(kind=kind), HERE)
    assert ground.advance(0.0, HERE) == (kind != "level")
    along = np.linspace(-0.5, 30.0, 3000)
    way = np.array([math.sin(HERE[2]), 0.0, math.cos(HERE[2])])
    points = np.array([HERE[0], 0.0, HERE[1]]) + along[:, np.newaxis] * way
    heights = ground_heights(ground.ground, points, np.zeros(len(points))) - 0.2
    assert heights[along < 0.6] == pytest.approx(0.0, abs=1e-9)
    assert heights.min() == pytest.approx(0.0, abs=1e-9)
    assert (heights.max() > 0.05) == (kind != "level")
    assert heights[-1] == pytest.approx(0.0, abs=1e-9)
    ground.ask(GroundChange(0.1, (0.05, 0.0), kind), HERE)
    for _ in range(60):
        ground.advance(1.0 / 60.0, HERE)
    risen = ground_heights(ground.ground, points, np.zeros(len(points))) - 0.2
    hill = 0.1 + 0.05 * (points[:, 0] - HERE[0])
    assert np.all(risen >= hill - 1e-9)
    assert risen[along < 0.6] == pytest.approx(hill[along < 0.6])


def test_an_obstacle_that_is_asked_for_again_stays_where_it_is() -> None:
    ground = MovingGround(0.0, GroundChange(kind="stairs"))
    before = ground.ground
    ground.ask(GroundChange(kind="stairs"), HERE)
    assert ground.ground == before


def test_hills_are_no_steeper_than_can_be_walked_on() -> None:
    ground = MovingGround(0.0, GroundChange(kind="hills"))
    assert isinstance(ground.ground, Terrain)
    field = ground.ground.parts[1]
    assert isinstance(field, HeightField)
    for axis in (0, 1):
        assert np.abs(np.diff(field.heights, axis=axis)).max() / field.spacing < 0.35


def test_a_cue_raises_the_ground_and_changes_nothing_else() -> None:
    sheet = SHEET + "[[cue]]\nat = 0.5\nground = 0.2\n"
    scenario = parse_scenario(sheet)
    assert scenario.cues[1] == Cue(0.5, "ground", ground=GroundChange(0.2))
    flat, raised = perform(parse_scenario(SHEET)), perform(scenario)
    up = raised.recording.world_positions - flat.recording.world_positions
    assert up[..., [0, 2]] == pytest.approx(0.0, abs=1e-9)
    np.testing.assert_allclose(up[..., 1], np.tile(raised.lifts[:, None], (1, up.shape[1])))
    assert raised.lifts[[0, 30, 45, -1]] == pytest.approx([0.0, 0.0, 0.1, 0.2])
    assert not flat.lifts.any()
    assert raised.grounds[0] == Plane(raised.ground)
    assert raised.grounds[-1] == Plane(raised.ground + 0.2)


def test_a_cue_may_say_all_of_the_ground() -> None:
    table = 'ground = { height = 0.1, slope = [0.1, 0.0], kind = "ramp" }'
    scenario = parse_scenario(f"{SHEET}[[cue]]\nat = 0.5\n{table}\n")
    assert scenario.cues[1].ground == GroundChange(0.1, (0.1, 0.0), "ramp")
    last = perform(scenario).grounds[-1]
    assert isinstance(last, Terrain)
    assert isinstance(last.parts[0], Plane)
    assert last.parts[0].slope == (0.1, 0.0)


@pytest.mark.parametrize(
    ("table", "told"),
    [
        (
            '{ kind = "sea" }',
            "cue[1].ground.kind is 'sea'; there are: level, ramp, stairs, hills, moving plate, "
            "turning plate, course",
        ),
        (
            "{ slope = [0.5, 0.0] }",
            "cue[1].ground.slope is [0.5, 0.0]; it must be two numbers from -0.4 to 0.4",
        ),
        (
            "{ slope = 0.1 }",
            "cue[1].ground.slope is 0.1; it must be two numbers from -0.4 to 0.4",
        ),
        (
            "{ deep = 1.0 }",
            "no key named 'deep' in cue[1].ground; there are: height, slope, kind",
        ),
        ('"high"', "cue[1].ground is 'high'; it must be a number, -10 to 10"),
    ],
)
def test_a_ground_that_is_none_is_refused(table: str, told: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(f"{SHEET}[[cue]]\nat = 0.5\nground = {table}\n")
    assert str(caught.value) == f"scenario.toml: {told}"
