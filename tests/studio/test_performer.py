"""The studio's character performs as a scenario does, frame by frame, and measures itself."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from footfall.adaptation import Plane
from footfall.errors import ArgumentError
from footfall.scenario.cue_sheet import parse_scenario
from footfall.scenario.performance import load_motions, perform
from footfall.studio.performer import Performer
from footfall.support import Support

SHEET = """
duration = 2.0
[[action]]
name = "walk"
motion = "sample:walk"
[[action]]
name = "left"
motion = "sample:hop-left"
[[action]]
name = "right"
motion = "sample:hop-right"
[[action]]
name = "go"
motions = ["sample:walk", "sample:run"]
[[cue]]
at = 0.0
start = "walk"
[[cue]]
at = 1.0
stop = "walk"
"""


@pytest.fixture
def performer(tmp_path: Path) -> Performer:
    scenario = parse_scenario(SHEET, tmp_path / "a.toml")
    return Performer(scenario, load_motions(scenario))


def test_it_performs_bit_for_bit_as_a_scenario_does(tmp_path: Path, performer: Performer) -> None:
    recording = perform(parse_scenario(SHEET, tmp_path / "a.toml")).recording
    assert performer.start("walk") == ""
    for frame in range(121):
        np.testing.assert_array_equal(performer.positions, recording.world_positions[frame])
        np.testing.assert_array_equal(performer.rotations, recording.world_rotations[frame])
        assert (performer.frame, performer.clock) == (frame, frame / 60.0)
        if frame == 60:
            performer.stop("walk")
        performer.advance()


def test_it_says_why_a_start_waits_and_whether_it_is_active(performer: Performer) -> None:
    assert not performer.is_active("left")
    assert performer.start("left") == ""
    for _ in range(60):
        performer.advance()
    assert "impossible beside 'left'" in performer.start("right")
    assert performer.is_active("right")
    performer.stop("right")
    performer.advance()
    assert not performer.is_active("right")


def test_its_feet_stand_on_its_ground_while_they_carry(performer: Performer) -> None:
    performer.start("walk")
    seen: set[Support] = set()
    for _ in range(180):
        performer.advance()
        seen.add(performer.support)
        points = performer.foot_points
        assert points.shape == (2, 2, 3)
        lowest = (points[..., 1] - performer.heights(points)).min(axis=1)
        if performer.support.left:
            assert abs(lowest[0]) < 0.02
        if performer.support.right:
            assert abs(lowest[1]) < 0.02
    assert seen == {Support.LEFT, Support.RIGHT, Support.DOUBLE}
    assert performer.slip.total < 0.03
    assert sum(slot.duration for slot in performer.planned()) > 0.0
    assert "walk" in performer.schedule_text()


def test_other_ground_takes_it_along(performer: Performer) -> None:
    performer.start("walk")
    for _ in range(30):
        performer.advance()
    hips = float(performer.positions[0, 1])
    performer.exchange_ground(Plane(performer.floor + 0.3), 0.3)
    performer.advance()
    assert performer.positions[0, 1] == pytest.approx(hips + 0.3, abs=0.02)
    assert performer.ground == Plane(performer.floor + 0.3)


def test_only_a_gait_has_a_reach_and_only_within_it_is_it_steered(performer: Performer) -> None:
    assert performer.reach("walk") is None
    spans = performer.reach("go")
    assert spans is not None
    assert [round(value, 2) + 0.0 for value in spans[0]] == [1.31, 3.3]
    performer.check_gait("go", 2.0, 0.0)
    with pytest.raises(ArgumentError, match=r"turn is 0.4 rad/s; the clips go from"):
        performer.check_gait("go", 2.0, 0.4)
    with pytest.raises(ArgumentError, match="'walk' is one motion; only a gait"):
        performer.check_gait("walk", 1.0, 0.0)
    performer.start("go")
    performer.steer("go", "speed", 3.0)
    for _ in range(30):
        performer.advance()
    # It follows at 1.5 m/s².
    assert performer.gait("go")[0] == pytest.approx(1.3125 + 0.75, abs=0.03)
