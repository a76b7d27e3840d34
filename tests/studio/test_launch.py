"""A studio as its tabs meet it: what they are told, what they may say, and who is refused."""

from __future__ import annotations

import json
import threading
import urllib.error
import urllib.request
from collections.abc import Generator
from pathlib import Path
from typing import Any

import pytest

from footfall.studio import open_studio
from footfall.studio.commands import handle

pytest.importorskip("viser", reason="the extra [studio] is not installed")

from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Generator[Any]:
    folder = tmp_path_factory.mktemp("studio")
    with open_studio(["sample:walk", "sample:run"], folder=folder, port=0) as opened:
        opened.session.jobs.wait()
        yield opened


def notices(session: Any, message: dict[str, Any]) -> list[str]:
    return [one["text"] for one in handle(session, message) if one["kind"] == "notice"]


def test_its_page_and_its_scene_have_ports_of_their_own(studio: Any) -> None:
    assert studio.port != studio.scene_port
    assert studio.url == f"http://127.0.0.1:{studio.port}/"
    for name in ("", "main.js", "studio.css"):
        with urllib.request.urlopen(studio.url + name) as answer:
            assert answer.status == 200


@pytest.mark.parametrize("name", ["../launch.py", "%2e%2e/launch.py", "nothing.js", "index.html/"])
def test_nothing_but_the_page_is_served(studio: Any, name: str) -> None:
    with pytest.raises(urllib.error.HTTPError, match="404"):
        urllib.request.urlopen(studio.url + name)


def test_a_foreign_page_is_refused_by_both_servers(studio: Any) -> None:
    with pytest.raises(InvalidStatus, match="403"):
        connect(f"ws://127.0.0.1:{studio.port}/session", origin="http://evil.example")  # pyright: ignore
    with connect(
        f"ws://127.0.0.1:{studio.scene_port}/",
        origin="http://evil.example",  # pyright: ignore
        subprotocols=["viser-v1.1.1"],  # pyright: ignore
    ) as scene:
        with pytest.raises(ConnectionClosed) as caught:
            scene.recv(timeout=10.0)
        assert caught.value.rcvd is not None
        assert caught.value.rcvd.code == 1008


def test_many_tabs_speak_at_once_and_all_hear_the_same(studio: Any) -> None:
    origin: Any = f"http://127.0.0.1:{studio.port}"
    address = f"ws://127.0.0.1:{studio.port}/session"
    failures: list[str] = []

    def tab(number: int) -> None:
        with connect(address, origin=origin) as line:
            for count in range(25):
                name = ("walk", "run")[(count + number) % 2]
                line.send(json.dumps({"do": "toggle", "name": name, "id": count}))
                while True:
                    message = json.loads(line.recv(timeout=20.0))
                    if message["kind"] == "notice" and message["level"] == "error":
                        failures.append(message["text"])
                    if message["kind"] == "done" and message["id"] == count:
                        break

    tabs = [threading.Thread(target=tab, args=(number,)) for number in range(4)]
    for one in tabs:
        one.start()
    for one in tabs:
        one.join(timeout=60.0)
    assert failures == []
    assert studio.session.stage.performer.clock >= 0.0


@pytest.mark.parametrize(
    "text", ["HIERARCHY", "", "HIERARCHY\nROOT a\n{\n}\nMOTION\nFrames: 1\nFrame Time: 0\n"]
)
def test_a_broken_file_is_told_and_the_session_lives(studio: Any, text: str) -> None:
    session = studio.session
    (session.folder.root / "broken.bvh").write_text(text)
    told: list[dict[str, Any]] = []
    before, session.tell = session.tell, told.append
    try:
        assert notices(session, {"do": "load", "file": "broken.bvh"}) == []
        session.jobs.wait()
    finally:
        session.tell = before
    errors = [one["text"] for one in told if one["kind"] == "notice"]
    assert len(errors) == 1
    assert "broken.bvh" in errors[0]
    assert [one.name for one in session.motions.motions] == ["walk", "run"]
    assert notices(session, {"do": "start", "name": "walk"}) == []


@pytest.mark.parametrize(
    ("message", "told"),
    [
        ({"do": "start", "name": "fly"}, "no action 'fly' on this stage"),
        ({"do": "start"}, "name is None; a text is needed"),
        ({"do": "view", "view": "moon"}, "no view 'moon'; there are: stage, supports, crowd"),
        ({"do": "lift", "value": 9}, "value is 9; a number from -0.5 to 0.5"),
        ({"do": "lift", "value": True}, "value is True; a number from -0.5 to 0.5"),
        ({"do": "speed", "value": 0.3}, "no speed 0.3; there are: 1.0, 0.5, 0.25, 0.1"),
        ({"do": "pause", "on": 1}, "on is 1; true or false is needed"),
        ({"do": "body", "name": "cat"}, "no body 'cat'; there are: own, child, tall, long legs"),
        ({"do": "undo"}, "no motion is open in the editor; choose one"),
        (
            {"do": "export", "form": "mp3", "name": "a"},
            "no form 'mp3'; there are: scenario, bvh, glb, page, picture",
        ),
        (
            {"do": "export", "form": "bvh", "name": "../a"},
            "'../a' is no name for a take; use letters, digits, blanks and - _ .",
        ),
    ],
)
def test_what_makes_no_sense_is_answered(studio: Any, message: dict[str, Any], told: str) -> None:
    assert notices(studio.session, message) == [told]


def test_an_unknown_word_lists_those_there_are(studio: Any) -> None:
    assert notices(studio.session, {"do": "dance"})[0].startswith("no command 'dance'; there are: ")
    assert notices(studio.session, {"do": ["x"]})[0].startswith("no command ['x']")


def test_a_file_outside_is_not_read_for_a_page(studio: Any) -> None:
    told = notices(studio.session, {"do": "load", "file": "../../etc/passwd.bvh"})
    assert "lies outside of" in told[0]


@pytest.mark.parametrize("body", ["child", "tall", "long legs", "own"])
def test_every_body_performs(studio: Any, body: str) -> None:
    assert notices(studio.session, {"do": "body", "name": body}) == []
    assert notices(studio.session, {"do": "start", "name": "walk"}) == []
    with studio.session.lock:
        for _ in range(30):
            studio.session.stage.advance()
        assert studio.session.stage.activity()["walk"] == "running"


def test_a_take_of_another_body_replays_bit_for_bit(studio: Any) -> None:
    import numpy as np

    from footfall.scenario.cue_sheet import load_scenario
    from footfall.scenario.performance import perform

    session, folder = studio.session, studio.session.folder.root
    notices(session, {"do": "body", "name": "tall"})
    with session.lock:
        notices(session, {"do": "start", "name": "run"})
        for _ in range(100):
            session.stage.advance()
        assert notices(session, {"do": "export", "form": "scenario", "name": "tall one"}) == []
        positions = session.stage.performer.positions.copy()
    session.jobs.wait()
    recording = perform(load_scenario(folder / "tall one.toml")).recording
    np.testing.assert_array_equal(recording.world_positions[-1], positions)
    notices(session, {"do": "body", "name": "own"})


def test_a_notebook_shows_the_page_in_a_frame(studio: Any) -> None:
    assert f'src="{studio.url}"' in studio._repr_html_()


def test_a_character_shows_its_own_actions_and_body(tmp_path: Path, monkeypatch: Any) -> None:
    import footfall as ff

    monkeypatch.chdir(tmp_path)
    clip, supports = ff.sample("walk")
    hero = ff.Character(clip.skeleton)
    hero.add("my walk", clip, supports, priority={"legs": 2.0})
    shown: Any = hero.show()
    with shown:
        session = shown.session
        assert [card.name for card in session.stage.cards] == ["my walk"]
        assert session.stage.cards[0].priority["legs"] == 2.0
        assert notices(session, {"do": "start", "name": "my walk"}) == []


def test_a_gait_of_a_character_is_steered_and_replays(tmp_path: Path, monkeypatch: Any) -> None:
    import numpy as np

    import footfall as ff
    from footfall.scenario.cue_sheet import load_scenario
    from footfall.scenario.performance import perform

    monkeypatch.chdir(tmp_path)
    clips = [ff.sample(name) for name in ("walk", "run", "walk-left")]
    hero = ff.Character(clips[0][0].skeleton)
    hero.add_locomotion("go", clips, speed=2.0)
    shown: Any = hero.show()
    with shown:
        session = shown.session
        with session.lock:
            assert notices(session, {"do": "start", "name": "go"}) == []
            assert session.stage.pair()[0].gait("go")[0] == 2.0
            assert notices(session, {"do": "steer", "name": "go", "speed": 3, "turn": 0.2}) == []
            for _ in range(60):
                session.stage.advance()
            notices(session, {"do": "export", "form": "scenario", "name": "mine"})
            positions = session.stage.performer.positions.copy()
        session.jobs.wait()
    assert {path.name for path in tmp_path.glob("*.npz")} >= {"go.npz", "go 2.npz", "go 3.npz"}
    recording = perform(load_scenario(tmp_path / "mine.toml")).recording
    np.testing.assert_array_equal(recording.world_positions[-1], positions)
