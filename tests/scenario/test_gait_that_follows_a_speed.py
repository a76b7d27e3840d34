"""A scenario whose action is made of several gaits and follows cues."""

from __future__ import annotations

import pytest

from footfall.errors import ScenarioError
from footfall.scenario.cue_sheet import parse_scenario
from footfall.scenario.performance import perform

TEXT = """
duration = 6.0
[[action]]
name = "go"
motions = ["sample:walk-slow", "sample:walk", "sample:walk-fast", "sample:run"]
speed = 1.0
[[cue]]
at = 0.0
start = "go"
[[cue]]
at = 1.5
speed = { go = 3.2 }
"""


def test_it_walks_and_then_runs_as_the_cues_say() -> None:
    performance = perform(parse_scenario(TEXT))
    way = performance.recording.world_positions[:, 0, 2]
    assert way[80] - way[20] == pytest.approx(1.0, rel=0.1)
    assert way[355] - way[295] == pytest.approx(3.2, rel=0.05)
    assert "-" not in performance.recording.support_text[:90]
    assert "-" in performance.recording.support_text[250:]


def test_a_speed_that_the_gaits_do_not_reach_is_told_with_the_file() -> None:
    with pytest.raises(ScenarioError) as caught:
        perform(parse_scenario(TEXT.replace("3.2", "9"), "a.toml"))
    assert str(caught.value) == ("a.toml: speed is 9.0 m/s; the clips go from 0.75 to 3.30 m/s")
