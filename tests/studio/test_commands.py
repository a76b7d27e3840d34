"""What a page may say: each word is known, obeyed under the lock, and answered."""

from __future__ import annotations

import re
from importlib import resources
from pathlib import Path
from typing import Any

import pytest
from tests.studio.sessions import session_of

from footfall.scenario.cue_sheet import ActionEntry
from footfall.studio.commands import COMMANDS, EDITS, QUIET, handle
from footfall.studio.session import Session

GAIT = ActionEntry("go", "sample:walk", others=("sample:run", "sample:walk-left"))


def errors(session: Session, word: str, **fields: Any) -> list[str]:
    answers = handle(session, {"do": word, **fields})
    return [one["text"] for one in answers if one["kind"] == "notice"]


def test_every_word_of_the_page_is_a_command() -> None:
    pages = resources.files("footfall.studio").joinpath("page")
    said: set[str] = set()
    for entry in pages.iterdir():
        if entry.name.endswith(".js"):
            said |= set(re.findall(r'\bsay\("([a-z-]+)"', entry.read_text()))
        if entry.name.endswith((".js", ".html")):
            said |= set(re.findall(r'data-do="([a-z-]+)"', entry.read_text()))
    assert len(said) > 30
    assert said <= set(COMMANDS)
    assert set(EDITS) <= set(COMMANDS)
    assert set(QUIET) <= set(COMMANDS)


def test_what_was_said_with_a_number_is_answered_with_it(tmp_path: Path) -> None:
    session, heard = session_of(tmp_path, "walk")
    assert handle(session, {"do": "pause", "on": True, "id": 7}) == [{"kind": "done", "id": 7}]
    assert session.paused
    assert heard.kinds() == ["state"]
    answers = handle(session, {"do": "start", "name": "fly", "id": 8})
    assert [one["kind"] for one in answers] == ["notice", "done"]
    assert heard.kinds() == ["state"]


def test_edits_tell_the_editor_and_quiet_words_nothing(tmp_path: Path) -> None:
    session, heard = session_of(tmp_path, "walk")
    session.select("walk")
    heard.messages.clear()
    assert errors(session, "drag", foot=0, band=0, side="end", time=0.4) == []
    assert heard.kinds() == ["edit"]
    assert errors(session, "seek", time=0.3) == []
    assert heard.kinds() == ["edit"]
    assert (session.clip_time, session.clip_plays) == (0.3, False)


def test_a_full_disk_is_told_and_the_session_lives(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    session, _ = session_of(tmp_path, "walk")

    def full() -> None:
        raise OSError(28, "no space left on device")

    monkeypatch.setattr(session, "save_supports", full)
    assert errors(session, "save") == ["cannot be done: [Errno 28] no space left on device"]
    assert errors(session, "start", name="walk") == []


def test_a_gait_is_steered(tmp_path: Path) -> None:
    session, heard = session_of(tmp_path, "kick")
    session.take_in(session.motions.resolve_entry(GAIT))
    heard.messages.clear()
    assert errors(session, "steer", name="go", speed=2.0, turn=0.1) == []
    assert heard.messages == []
    assert session.stage.cards[1].gait == (2.0, 0.1)
    assert errors(session, "steer", name="go", speed=9.0, turn=0.0) == [
        "speed is 9.0 m/s; the clips go from 1.28 to 3.30 m/s"
    ]
    assert errors(session, "steer", name="go", speed=2.0) == [
        "turn is None; a number from -20 to 20"
    ]
    assert errors(session, "steer", name="kick", speed=2.0, turn=0.0) == [
        "'kick' is one motion; only a gait of several is steered"
    ]
    assert session.stage.cards[1].gait == (2.0, 0.1)


@pytest.mark.parametrize(
    ("word", "fields", "told"),
    [
        ("priority", {"name": "walk", "part": "tail", "value": 1},
         "no body part 'tail'; there are: all, legs, trunk, head, left_arm, right_arm"),
        ("priority", {"name": "walk", "part": "all", "value": 0},
         "an action with no priority anywhere does nothing; keep one above 0"),
        ("fades", {"name": "walk", "fadeIn": -1, "fadeOut": 0},
         "fadeIn is -1; a number from 0 to 5"),
        ("tilt", {"ahead": 0.5, "aside": 0}, "ahead is 0.5; a number from -0.25 to 0.25"),
        ("ground", {"name": "lava"}, "no ground 'lava'; there are: level, ramp, stairs, hills, "
         "moving plate, turning plate, course"),
        ("drag", {"foot": 0, "band": 0, "side": "top", "time": 0},
         "no side 'top'; there are: start, end"),
        ("drag", {"foot": 0.5, "band": 0, "side": "end", "time": 0},
         "foot is 0.5; a whole number from 0 to 1"),
        ("gather", {"size": 0}, "size is 0; a number from 1 to 2000"),
        ("crowd-start", {"name": "walk", "group": 0}, "no action 'walk' in this crowd"),
        ("gait", {}, "a gait is made of two or more walks and runs; load them first"),
    ],
)  # fmt: skip
def test_what_makes_no_sense_is_told(
    tmp_path: Path, word: str, fields: dict[str, Any], told: str
) -> None:
    session, _ = session_of(tmp_path, "walk")
    session.select("walk")
    assert errors(session, word, **fields) == [told]


def test_one_part_or_all_of_a_priority_is_changed(tmp_path: Path) -> None:
    session, _ = session_of(tmp_path, "walk")
    assert errors(session, "priority", name="walk", part="head", value=3) == []
    assert session.stage.cards[0].priority["head"] == 3.0
    assert session.stage.cards[0].priority["legs"] == 1.0
    assert errors(session, "priority", name="walk", part="all", value=2) == []
    assert set(session.stage.cards[0].priority.values()) == {2.0}
