"""What tabs are told of a session: a page can show all of it, and it can be sent as JSON."""

from __future__ import annotations

import json
from importlib import resources
from pathlib import Path

from tests.studio.sessions import session_of

from footfall.samples import sample_names
from footfall.scenario.cue_sheet import ActionEntry
from footfall.studio.news import greet, news, state_json
from footfall.studio.telling import tick_json


def test_a_new_tab_is_told_everything(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path, "walk")
    assert [one["kind"] for one in greet(session)] == ["state", "crowd", "jobs"]
    session.select("walk")
    kinds = [one["kind"] for one in greet(session)]
    assert kinds == ["state", "clip", "edit", "crowd", "jobs"]
    assert json.loads(json.dumps(greet(session), allow_nan=False)) == greet(session)


def test_the_editor_is_told_only_after_what_may_have_changed_it(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path, "walk")
    session.select("walk")
    for word in ("select", "view", "save", "option"):
        assert [one["kind"] for one in news(session, word)] == ["state", "clip", "edit"]
    for word in ("start", "pause", None):
        assert [one["kind"] for one in news(session, word)] == ["state"]


def test_the_state_names_cards_motions_files_and_bodies(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path, "walk", "run")
    for name in ("b.bvh", "s.toml", "hero.glb"):
        (tmp_path / name).write_bytes(b"")
    state = state_json(session)
    assert [card["name"] for card in state["cards"]] == ["walk", "run"]
    assert [card["gait"] for card in state["cards"]] == [None, None]
    assert [one["mixes"] for one in state["motions"]] == [True, True]
    assert "b.bvh" in state["files"]
    assert state["scenarios"] == ["s.toml"]
    assert state["bodies"] == ["own", "child", "tall", "long legs", "hero.glb"]
    assert state["body"] in state["bodies"]
    assert state["ground"] in state["grounds"]
    assert (state["folder"], state["editing"]) == (str(tmp_path.resolve()), None)


def test_a_gait_tells_its_reach_and_where_it_is(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path)
    names = ("sample:walk", "sample:run", "sample:walk-left")
    entry = ActionEntry("go", names[0], others=names[1:])
    session.take_in(session.motions.resolve_entry(entry))
    (card,) = state_json(session)["cards"]
    assert card["supports"] == "walk, run, walk-left"
    spans = {key: [round(value, 2) for value in span] for key, span in card["gait"].items()}
    assert spans == {"speeds": [1.28, 3.3], "turns": [0.0, 0.65]}
    (motion,) = state_json(session)["motions"]
    assert motion["gait"] is True
    session.stage.steer(session.stage.cards[0], 2.0, 0.25)
    (action,) = tick_json(session.stage)["actions"]
    assert action["gait"] == [1.312, 0.0, 2.0, 0.25]
    session.stage.start(session.stage.cards[0])
    (action,) = tick_json(session.stage)["actions"]
    assert action["gait"] == [2.0, 0.25, 2.0, 0.25]


def test_the_page_offers_every_sample() -> None:
    page = resources.files("footfall.studio").joinpath("page", "main.js").read_text()
    begin = page.index("const SAMPLES = [")
    listed = page[begin + len("const SAMPLES = ") : page.index("]", begin) + 1]
    assert sorted(json.loads(listed)) == sorted(sample_names())
