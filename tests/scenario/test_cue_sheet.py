"""A cue sheet is read whole, or refused in one line that names the file and the key."""

from __future__ import annotations

from pathlib import Path

import pytest

from footfall.errors import FileFormatError, ScenarioError
from footfall.scenario.cue_sheet import Scenario, load_scenario, parse_scenario
from footfall.scenario.entries import ActionEntry, Cue
from footfall.scenario.motions import resolve_motion, supports_path
from footfall.support import Support

WALK = '[[action]]\nname = "walk"\nmotion = "sample:walk"\n'
START = '[[cue]]\nat = 0.0\nstart = "walk"\n'

WHOLE = """
fps = 30
duration = 6
body = "walk.bvh"
planner = "paper"
[[action]]
name = "walk"
motion = "walk.bvh"
priority = { legs = 1.0, arms = 0.2 }
fade_in = 0.1
fade_out = 0.2
cyclic = true
supports = "walk.supports"
mirror = true
crop = [0.5, 1.5]
clean = true
[[action]]
name = "run"
motion = "sample:run"
[[cue]]
at = 4.2
stop = "walk"
[[cue]]
at = 0
start = "walk"
[[cue]]
at = 5.0
priority = { walk = 2.0, run = { legs = 3 } }
"""


def test_a_whole_cue_sheet_is_read_with_its_cues_in_order_of_time() -> None:
    read = parse_scenario(WHOLE, "a.toml")
    walk = ActionEntry(
        "walk",
        "walk.bvh",
        {"legs": 1.0, "arms": 0.2},
        0.1,
        0.2,
        True,
        "walk.supports",
        True,
        (0.5, 1.5),
        True,
    )
    cues = (
        Cue(0.0, "start", "walk"),
        Cue(4.2, "stop", "walk"),
        Cue(5.0, "priority", "walk", 2.0),
        Cue(5.0, "priority", "run", {"legs": 3}),
    )
    actions = (walk, ActionEntry("run", "sample:run"))
    assert read == Scenario(Path("a.toml"), actions, cues, 30.0, 6.0, "paper", "walk.bvh")


BAD = {
    "fps = 0\n": "fps is 0; it must be a number, above 0 and at most 1000",
    "fps = inf\n": "fps is inf; it must be a number, above 0 and at most 1000",
    "duration = true\n": "duration is True; it must be a number, above 0 and at most 3600",
    "colour = 1\n": (
        "no key named 'colour'; there are: fps, duration, body, planner, action, layer, cue"
    ),
    'planner = "best"\n': "planner is 'best'; there are: footfall, paper",
    'body = ""\n': "body is ''; it must be a text, not empty",
}


@pytest.mark.parametrize("text", BAD)
def test_a_bad_key_of_the_file_is_told(text: str) -> None:
    with pytest.raises(ScenarioError) as raised:
        parse_scenario(text + WALK + START, "a.toml")
    assert str(raised.value) == f"a.toml: {BAD[text]}"


BAD_ACTIONS = {
    "fade_in = -1\n": "action[0].fade_in is -1; it must be a number, 0 to 60",
    "mirror = 1\n": "action[0].mirror is 1; it must be true or false",
    "crop = [2, 1]\n": (
        "action[0].crop is [2, 1]; it must be two times in seconds, such as [0.5, 1.8]"
    ),
    "pace = 1\n": (
        "no key named 'pace' in action[0]; there are: name, motion, motions, priority, fade_in, "
        "fade_out, cyclic, supports, mirror, crop, clean, speed, turn"
    ),
    "speed = 1\n": (
        "action[0].speed needs motions: a list of gaits that go at different ones, instead of "
        "motion"
    ),
    "motions = ['sample:run']\n": "action[0] has motion and motions; give one of them",
    "[[action]]\nname = 'go'\nmotions = ['a.bvh']\n": (
        "action[1].motions is one; a gait needs two or more"
    ),
    "[[action]]\nname = 'go'\nmotions = []\n": (
        "action[1].motions is []; it must be a list, each a file beside the scenario or "
        '"sample:walk"'
    ),
    "priority = { tail = 1 }\n": (
        "action[0].priority: no body part named 'tail'; there are: legs, trunk, head, arms, "
        "left_arm, right_arm"
    ),
    "priority = 'high'\n": (
        "action[0].priority is 'high'; it must be a number, or a table of numbers by body part "
        "such as { legs = 1.0, arms = 0.2 }"
    ),
    '[[action]]\nname = "walk"\nmotion = "x.bvh"\n': (
        "action[1].name is 'walk', as is that of action[0]; names must differ"
    ),
    '[[action]]\nname = "run"\n': (
        'action[1].motion is missing; give a file beside the scenario or "sample:walk"'
    ),
}


@pytest.mark.parametrize("text", BAD_ACTIONS)
def test_a_bad_key_of_an_action_is_told(text: str) -> None:
    with pytest.raises(ScenarioError) as raised:
        parse_scenario(WALK + text + START, "a.toml")
    assert str(raised.value) == f"a.toml: {BAD_ACTIONS[text]}"


BAD_CUES = {
    "": "there is no [[cue]]; at least one is needed",
    "[[cue]]\nstart = 'walk'\n": "cue[0].at is missing; give a number, 0 to 10",
    "[[cue]]\nat = 10.5\nstart = 'walk'\n": "cue[0].at is 10.5; it must be a number, 0 to 10",
    "[[cue]]\nat = -0.1\nstart = 'walk'\n": "cue[0].at is -0.1; it must be a number, 0 to 10",
    "[[cue]]\nat = 1\nstart = 'run'\n": "cue[0].start is 'run'; there are: walk",
    "[[cue]]\nat = 1\npriority = { run = 1 }\n": "cue[0].priority names 'run'; there are: walk",
    "[[cue]]\nat = 1\nspeed = { walk = 'fast' }\n": (
        "cue[0].speed.walk is 'fast'; it must be a number, -20 to 20"
    ),
    "[[cue]]\nat = 1\nturn = { run = 1 }\n": "cue[0].turn names 'run'; there are: walk",
    "[[cue]]\nat = 1\n": (
        "cue[0] has no command; it must have one of start, stop, "
        "priority, speed, turn, layer and ground"
    ),
    "[[cue]]\nat = 1\nstart = 'walk'\nstop = 'walk'\n": (
        "cue[0] has start and stop; it must have one of start, stop, "
        "priority, speed, turn, layer and ground"
    ),
}


@pytest.mark.parametrize("text", BAD_CUES)
def test_a_bad_cue_is_told(text: str) -> None:
    with pytest.raises(ScenarioError) as raised:
        parse_scenario(WALK + text, "a.toml")
    assert str(raised.value) == f"a.toml: {BAD_CUES[text]}"


def test_text_that_is_no_toml_is_told_with_its_line() -> None:
    with pytest.raises(FileFormatError) as raised:
        parse_scenario("fps = 60\nduration = \n", "a.toml")
    assert str(raised.value) == "a.toml:2: not TOML at column 12: invalid value"


def test_a_missing_file_is_told(tmp_path: Path) -> None:
    path = tmp_path / "none.toml"
    with pytest.raises(FileFormatError) as raised:
        load_scenario(path)
    assert str(raised.value) == f"{path}: there is no such file; check the name"


def test_a_missing_motion_is_told_with_its_action() -> None:
    sheet = parse_scenario('[[action]]\nname = "a"\nmotion = "no.bvh"\n[[cue]]\nat=0\nstart="a"')
    with pytest.raises(ScenarioError) as raised:
        resolve_motion(sheet.actions[0], sheet)
    assert str(raised.value) == (
        "scenario.toml: action 'a': no.bvh: there is no such file; check the name"
    )


def test_a_mirrored_sample_stands_on_the_other_foot() -> None:
    sheet = parse_scenario(
        WALK.replace("walk", "run") + "mirror = true\n" + START.replace("walk", "run")
    )
    plain = parse_scenario(WALK.replace("walk", "run") + START.replace("walk", "run"))
    mirrored = resolve_motion(sheet.actions[0], sheet).supports.phases
    usual = resolve_motion(plain.actions[0], plain).supports.phases
    other = {Support.LEFT: Support.RIGHT, Support.RIGHT: Support.LEFT}
    assert [phase.support for phase in mirrored] == [
        other.get(phase.support, phase.support) for phase in usual
    ]


@pytest.mark.parametrize("name", ["walk.bvh", "walk.bvh.gz", "walk.npz", "walk.glb"])
def test_supports_stand_beside_a_file_under_its_name(name: str) -> None:
    assert supports_path(Path("there") / name) == Path("there/walk.supports")
