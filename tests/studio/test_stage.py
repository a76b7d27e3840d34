"""What was steered by hand comes out of its scenario file bit for bit."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from footfall.errors import MissingViewerError
from footfall.scenario.cue_sheet import Scenario, parse_scenario
from footfall.scenario.ground_change import GROUND_KINDS, GroundChange, GroundKind
from footfall.scenario.performance import perform
from footfall.studio.card import PARTS
from footfall.studio.motion_list import MotionList
from footfall.studio.stage import Stage
from footfall.studio.take import scenario_text
from footfall.studio.work_folder import WorkFolder


def stage(folder: Path, *names: str) -> Stage:
    motions = MotionList(WorkFolder.at(folder))
    for name in names:
        motions.keep(motions.resolve(f"sample:{name}"))
    return Stage(motions)


def steer(one: Stage, frames: int = 400) -> None:
    """Start, stop, change fades, priorities and the ground, at frames of no pattern."""
    one.start(one.cards[0])
    chosen = np.random.default_rng(3)
    for frame in range(frames):
        one.advance()
        if frame % 37 == 11:
            one.toggle(one.cards[int(chosen.integers(len(one.cards)))])
        if frame == 120:
            one.set_fades(one.cards[0], 0.55, 0.65)
        if frame == 150:
            one.set_priority(one.cards[0], dict.fromkeys(PARTS, 2.5))
        if frame == 200:
            one.lift_to(0.3)
        if frame == 240:
            one.tilt_to(0.1, -0.05)
        if frame == 300:
            one.put("course")
        if frame == 390:
            one.lift_to(-0.1)


def replayed(one: Stage, folder: Path) -> tuple[Scenario, np.ndarray, np.ndarray]:
    scenario = parse_scenario(scenario_text(one.scenario()), folder / "take.toml")
    recording = perform(scenario).recording
    return scenario, recording.world_positions[-1], recording.world_rotations[-1]


def test_a_take_replays_bit_for_bit(tmp_path: Path) -> None:
    mine = stage(tmp_path, "walk", "run", "kick", "punch")
    steer(mine)
    _, positions, rotations = replayed(mine, tmp_path)
    performer = mine.pair()[0]
    assert -0.1 < mine.ground.height < 0.3
    assert performer.ground == mine.ground.ground
    np.testing.assert_array_equal(positions, performer.positions)
    np.testing.assert_array_equal(rotations, performer.rotations)


def test_a_ground_raised_before_the_take_rises_in_it(tmp_path: Path) -> None:
    mine = stage(tmp_path, "walk")
    mine.lift_to(0.2)
    for _ in range(40):
        mine.advance()
    steer(mine, 90)
    scenario, positions, _ = replayed(mine, tmp_path)
    assert scenario.cues[0].ground == GroundChange(0.2)
    np.testing.assert_array_equal(positions, mine.pair()[0].positions)


def test_the_ghost_slides_and_the_character_does_not(tmp_path: Path) -> None:
    mine = stage(tmp_path, "walk", "run")
    mine.start(mine.cards[0])
    for frame in range(400):
        mine.advance()
        if frame in (100, 200):
            mine.toggle(mine.cards[1])
    performer, ghost = mine.pair()
    assert performer.slip.total < 0.1
    assert ghost.slip.total > 5.0 * performer.slip.total


def test_a_motion_added_while_it_walks_lets_it_walk_on(tmp_path: Path) -> None:
    mine = stage(tmp_path, "walk")
    mine.start(mine.cards[0])
    for _ in range(60):
        mine.advance()
    frame = mine.pair()[0].frame
    motions = MotionList(WorkFolder.at(tmp_path))
    mine.add(motions.resolve("sample:run"))
    assert (mine.pair()[0].frame, mine.begun) == (frame, True)
    mine.start(mine.cards[1])
    mine.advance()
    assert mine.activity()["run"] != "idle"


def test_an_engine_without_viewers_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    from footfall.engine import showing

    def no_viewers(*, group: str) -> list[object]:
        del group
        return []

    monkeypatch.setattr(showing, "entry_points", no_viewers)
    with pytest.raises(MissingViewerError, match=r"no viewer is registered as 'footfall.viewers'"):
        showing.show_character(None)  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize("kind", GROUND_KINDS)
def test_it_walks_over_whatever_is_put_ahead_of_it(tmp_path: Path, kind: GroundKind) -> None:
    mine = stage(tmp_path, "walk")
    mine.start(mine.cards[0])
    performer = mine.pair()[0]
    lowest, highest = 0.0, 0.0
    for frame in range(600):
        mine.advance()
        if frame == 60:
            mine.put(kind)
        points = performer.foot_points
        clearances = points[..., 1] - performer.heights(points)
        lowest = min(lowest, float(clearances.min()))
        highest = max(highest, float(performer.heights(points).max()) - performer.floor)
    assert np.isfinite(performer.positions).all()
    # A foot that rolls over an edge is in it for a moment: deep at a step, little at a ramp.
    assert lowest > {"level": -0.01, "hills": -0.01, "ramp": -0.012}.get(kind, -0.06)
    assert (highest > 0.06) == (kind != "level")
    assert performer.slip.total < 0.06


def test_the_ground_tilts_about_the_character(tmp_path: Path) -> None:
    mine = stage(tmp_path, "walk")
    mine.start(mine.cards[0])
    for _ in range(300):
        mine.advance()
    performer = mine.pair()[0]
    assert abs(performer.root[1]) > 3.0
    mine.tilt_to(0.2, 0.0)
    before = float(performer.heights(performer.positions[0]))
    mine.advance()
    assert float(performer.heights(performer.positions[0])) == pytest.approx(before, abs=1e-3)
    for _ in range(180):
        mine.advance()
    assert mine.tilt == pytest.approx((0.2, 0.0), abs=0.01)
    assert performer.slip.total < 0.06


def test_the_ghost_stands_on_the_same_ground(tmp_path: Path) -> None:
    mine = stage(tmp_path, "walk")
    mine.put("stairs")
    mine.tilt_to(0.1, 0.0)
    mine.start(mine.cards[0])
    for _ in range(100):
        mine.advance()
    performer, ghost = mine.pair()
    assert ghost.ground == performer.ground
