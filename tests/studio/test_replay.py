"""A scenario that is opened again: its cues at their times, and only those of the folder."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.studio.sessions import session_of

from footfall.errors import FileFormatError, ScenarioError
from footfall.scenario.cue_sheet import Cue, parse_scenario
from footfall.scenario.ground_change import GroundChange
from footfall.scenario.performance import perform
from footfall.studio.card import by_part
from footfall.studio.replay import due_cues, frame_cues, obey_cue, open_scenario

SHEET = """
duration = 3.0
[[action]]
name = "go"
motion = "sample:walk"
[[action]]
name = "faster"
motion = "sample:run"
[[cue]]
at = 0.0
stop = "go"
[[cue]]
at = 0.0
ground = 0.1
[[cue]]
at = 0.0
start = "go"
[[cue]]
at = 0.5
priority = { go = { legs = 2.0 } }
[[cue]]
at = 1.0
start = "faster"
[[cue]]
at = 2.0
stop = "go"
"""


def test_cues_without_effect_before_the_first_start_are_left_out(tmp_path: Path) -> None:
    cues = frame_cues(parse_scenario(SHEET, tmp_path / "a.toml"))
    assert [(cue.at, cue.kind) for cue in cues] == [
        (0.0, "ground"),
        (0.0, "start"),
        (0.5, "priority"),
        (1.0, "start"),
        (2.0, "stop"),
    ]


def test_a_scenario_without_a_start_keeps_its_ground_only() -> None:
    sheet = parse_scenario(
        '[[action]]\nname = "a"\nmotion = "sample:walk"\n'
        '[[cue]]\nat = 0\nstop = "a"\n[[cue]]\nat = 1\nground = 0.1\n'
    )
    assert [cue.kind for cue in frame_cues(sheet)] == ["ground"]


def test_cues_are_due_at_their_time_and_the_first_start_begins_the_take() -> None:
    script = [
        Cue(0.5, "ground", ground=GroundChange(0.1)),
        Cue(1.0, "start", "go"),
        Cue(1.0 + 5e-10, "start", "b"),
        Cue(1.5, "stop", "go"),
    ]
    # Nothing has begun: what comes before the first start is not waited for.
    assert [cue.at for cue in due_cues(script, 0.0, False)] == [0.5, 1.0]
    assert due_cues(script, 0.9, True) == []
    assert [cue.action for cue in due_cues(script, 1.0, True)] == ["b"]
    assert [cue.kind for cue in due_cues(script, 9.0, True)] == ["stop"]
    assert script == []


def test_every_kind_of_cue_is_obeyed_and_an_unknown_action_is_none(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path, "walk", "run")
    stage = session.stage
    obey_cue(stage, Cue(0.0, "start", "nobody"))
    assert not stage.begun
    obey_cue(stage, Cue(0.0, "ground", ground=GroundChange(0.2)))
    obey_cue(stage, Cue(0.0, "start", "walk"))
    obey_cue(stage, Cue(0.0, "priority", "walk", {"legs": 2.0}))
    assert stage.asked == GroundChange(0.2)
    assert stage.cards[0].priority == by_part({"legs": 2.0})
    stage.advance()
    assert stage.activity()["walk"] != "idle"
    obey_cue(stage, Cue(0.0, "stop", "walk"))
    stage.advance()
    assert stage.activity()["walk"] == "fading out"


def test_an_opened_scenario_is_played_as_it_is_performed(tmp_path: Path) -> None:
    session, heard = session_of(tmp_path, "walk")
    (tmp_path / "a.toml").write_text(SHEET)
    session.paused, session.view = True, "crowd"
    open_scenario(session, "a.toml")
    session.jobs.wait()
    assert (session.view, session.paused) == ("stage", False)
    assert [card.name for card in session.stage.cards] == ["go", "faster"]
    assert ("info", "playing a.toml") in heard.notices()
    stage, script = session.stage, session.script
    for _ in range(180):
        for cue in due_cues(script, stage.pair()[0].clock, stage.begun):
            obey_cue(stage, cue)
        stage.advance()
    scenario = parse_scenario(SHEET, tmp_path / "a.toml")
    told = perform(scenario).recording.world_positions[180]
    np.testing.assert_array_equal(stage.pair()[0].positions, told)


def test_what_cannot_be_opened_is_refused_and_changes_nothing(tmp_path: Path) -> None:
    session, heard = session_of(tmp_path, "walk")
    (tmp_path / "deep").mkdir()
    (tmp_path / "deep" / "a.toml").write_text(SHEET)
    with pytest.raises(ScenarioError, match="the studio opens scenarios beside it; start it in "):
        open_scenario(session, "deep/a.toml")
    with pytest.raises(FileFormatError, match="lies outside of"):
        open_scenario(session, "../a.toml")
    (tmp_path / "b.toml").write_text(SHEET.replace("sample:run", "nowhere.bvh"))
    open_scenario(session, "b.toml")
    session.jobs.wait()
    assert [level for level, _ in heard.notices()] == ["error"]
    assert "action 'faster'" in heard.notices()[0][1]
    assert [card.name for card in session.stage.cards] == ["walk"]
    assert session.script == []


def test_a_scenario_with_layers_is_refused_in_words(tmp_path: Path) -> None:
    layer = '[[layer]]\nname = "blow"\nmotion = "sample:punch"\n'
    (tmp_path / "a.toml").write_text(SHEET + layer, encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        open_scenario(session_of(tmp_path)[0], "a.toml")
    assert str(caught.value).endswith(
        "a.toml: has the layer 'blow'; the studio lays none, footfall blend does"
    )
