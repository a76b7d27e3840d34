"""A gait steered by hand: by speed and turn, and bit for bit the same out of its scenario file."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from footfall.errors import ArgumentError
from footfall.scenario.cue_sheet import ActionEntry, parse_scenario
from footfall.scenario.performance import perform
from footfall.studio.gaits import GAIT_SAMPLES
from footfall.studio.motion_list import MotionList
from footfall.studio.replay import due_cues, frame_cues, obey_cue
from footfall.studio.stage import Stage
from footfall.studio.take import scenario_text
from footfall.studio.work_folder import WorkFolder

GO = ActionEntry("go", GAIT_SAMPLES[0], others=GAIT_SAMPLES[1:])


def stage(folder: Path) -> Stage:
    motions = MotionList(WorkFolder.at(folder))
    motions.keep(motions.resolve("sample:walk"))
    motions.keep(motions.resolve_entry(GO))
    motions.keep(motions.resolve("sample:kick"))
    return Stage(motions)


def steered(folder: Path) -> Stage:
    """Steer before the start, while it goes, while it fades, and with other fades."""
    mine = stage(folder)
    go, kick = mine.cards[1], mine.cards[2]
    mine.steer(go, 1.0, 0.0)
    mine.start(go)
    for frame in range(420):
        mine.advance()
        if frame == 40:
            mine.steer(go, 3.1, 0.0)
        if frame == 47:
            mine.steer(go, 2.9, 0.0)
        if frame in (90, 300):
            mine.toggle(kick)
        if frame == 200:
            mine.toggle(go)
            mine.set_fades(go, 0.5, 0.2)
        if frame == 210:
            mine.steer(go, 1.2, 0.5)
        if frame == 260:
            mine.toggle(go)
    return mine


def test_what_was_steered_replays_bit_for_bit(tmp_path: Path) -> None:
    mine = steered(tmp_path)
    text = scenario_text(mine.scenario())
    assert 'motions = ["sample:walk", "sample:walk-slow", "sample:walk-fast", ' in text
    assert 'speed = { "go" = 3.1 }' in text
    assert 'turn = { "go fade 2" = 0.5 }' in text
    recording = perform(parse_scenario(text, tmp_path / "take.toml")).recording
    performer = mine.pair()[0]
    np.testing.assert_array_equal(recording.world_positions[-1], performer.positions)
    np.testing.assert_array_equal(recording.world_rotations[-1], performer.rotations)


def test_a_take_opened_again_is_steered_as_it_was(tmp_path: Path) -> None:
    mine = steered(tmp_path)
    scenario = parse_scenario(scenario_text(mine.scenario()), tmp_path / "take.toml")
    motions = MotionList(WorkFolder.at(tmp_path))
    for entry in scenario.actions:
        motions.keep(motions.resolve_entry(entry))
    again, script = Stage(motions), frame_cues(scenario)
    for _ in range(421):
        for cue in due_cues(script, again.pair()[0].clock, again.begun):
            obey_cue(again, cue)
        if again.pair()[0].frame < 420:
            again.advance()
    np.testing.assert_array_equal(again.pair()[0].positions, mine.pair()[0].positions)


def test_it_goes_as_fast_as_it_is_asked_and_does_not_slide(tmp_path: Path) -> None:
    mine = stage(tmp_path)
    go = mine.cards[1]
    mine.start(go)
    for speed in (3.2, 0.8):
        mine.steer(go, speed, 0.0)
        for _ in range(240):
            mine.advance()
        before = mine.pair()[0].root[1]
        for _ in range(120):
            mine.advance()
        assert (mine.pair()[0].root[1] - before) / 2.0 == pytest.approx(speed, rel=0.1)
    assert mine.pair()[0].gait("go") == (0.8, 0.0)
    assert mine.pair()[1].gait("go") == (0.8, 0.0)
    assert mine.pair()[0].slip.total < 0.06


@pytest.mark.parametrize(("speed", "turn"), [(1.3, 0.5), (1.3, -0.6), (3.2, 0.6)])
def test_it_goes_round_a_curve_and_does_not_slide(
    tmp_path: Path, speed: float, turn: float
) -> None:
    mine = stage(tmp_path)
    mine.start(mine.cards[1])
    mine.steer(mine.cards[1], speed, turn)
    for _ in range(240):
        mine.advance()
    before = mine.pair()[0].root[2]
    for _ in range(120):
        mine.advance()
    assert (mine.pair()[0].root[2] - before) / 2.0 == pytest.approx(turn, rel=0.15)
    assert mine.pair()[0].slip.total < 0.06


def test_another_take_begins_with_the_same_gait(tmp_path: Path) -> None:
    mine = stage(tmp_path)
    mine.steer(mine.cards[1], 2.5, 0.0)
    mine.restart()
    mine.start(mine.cards[1])
    assert mine.pair()[0].gait("go") == (2.5, 0.0)
    cues = mine.take.scenario.cues
    assert [(cue.at, cue.kind, cue.parameter) for cue in cues] == [
        (0.0, "speed", 2.5),
        (0.0, "turn", 0.0),
        (0.0, "start", 0.0),
    ]


def test_a_speed_out_of_reach_is_refused_and_changes_nothing(tmp_path: Path) -> None:
    mine = stage(tmp_path)
    with pytest.raises(ArgumentError) as caught:
        mine.steer(mine.cards[1], 4.0, 0.0)
    assert str(caught.value) == "speed is 4.0 m/s; the clips go from 0.75 to 3.30 m/s"
    assert mine.cards[1].gait is None
    with pytest.raises(ArgumentError) as caught:
        mine.steer(mine.cards[0], 1.0, 0.0)
    assert str(caught.value) == "'walk' is one motion; only a gait of several is steered"


def test_a_gait_is_not_the_motion_that_it_begins_with(tmp_path: Path) -> None:
    mine = stage(tmp_path)
    walk, go = mine.cards[0], mine.cards[1]
    assert mine.take.scenario.actions[0].motion == mine.take.scenario.actions[1].motion
    mine.start(go)
    mine.set_fades(go, 0.5, 0.2)
    assert go.action == "go fade 2"
    mine.set_fades(go, 0.3, 0.3)
    assert (walk.action, go.action) == ("walk", "go")
    assert [mine.motion_name(index) for index in range(4)] == ["walk", "go", "kick", "go"]


def test_a_smaller_body_is_asked_for_no_more_than_it_reaches(tmp_path: Path) -> None:
    from footfall.studio.bodies import bodies_of

    motions = MotionList(WorkFolder.at(tmp_path))
    motions.keep(motions.resolve_entry(GO))
    mine = Stage(motions)
    mine.steer(mine.cards[0], 3.3, 0.0)
    child = next(body for body in bodies_of(motions.skeletons) if body.name == "child")
    motions.body = child.skeleton
    mine.restart()
    spans = mine.pair()[0].reach("go")
    assert spans is not None
    assert mine.cards[0].gait is not None
    assert mine.cards[0].gait[0] == spans[0][1] < 3.0
    mine.start(mine.cards[0])
    mine.advance()
