"""What became of each start: at once, later, never, and for how long without its legs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import footfall as ff
from footfall.cli.staging import starts_text
from footfall.engine.recording import Recorder
from footfall.scenario.cue_sheet import parse_scenario
from footfall.scenario.performance import perform
from footfall.scenario.playing import with_muting

SHEET = """
duration = 1.0

[[action]]
name = "right"
motion = "sample:hop-right"

[[action]]
name = "left"
motion = "sample:hop-left"
priority = 0.5

[[cue]]
at = 0.0
start = "right"

[[cue]]
at = 0.3
start = "left"
"""


def test_an_impossible_start_is_told_from_one_that_waits() -> None:
    performance = perform(parse_scenario(SHEET, "hops.toml"))
    first, second = performance.starts
    assert not first.impossible
    assert second.impossible
    assert second.actual is None
    assert second.to_json()["impossible"] is True
    assert (
        starts_text(performance)
        .splitlines()[1]
        .startswith("  left: commanded at 0.30 s, never started: impossible beside 'right': ")
    )


def test_what_is_muted_says_for_how_long() -> None:
    sheet = parse_scenario(SHEET, "hops.toml")
    performance = perform(sheet)
    assert [start.muted for start in performance.starts] == [0.0, 0.0]
    recording = performance.recording
    muted = np.zeros_like(recording.muted)
    muted[3:9, 0] = True
    told = with_muting(performance.starts, replace(recording, muted=muted))
    assert [start.muted for start in told] == [pytest.approx(0.1), 0.0]
    text = starts_text(replace(performance, starts=told))
    assert text.splitlines()[0] == (
        "  right: commanded at 0.00 s, started at once; 0.10 s of it muted, without its legs"
    )


def test_a_muted_start_is_recorded() -> None:
    clips = {name: ff.sample(name) for name in ("hop-right", "hop-left")}
    hero = ff.Character(clips["hop-right"][0].skeleton)
    for name, (clip, supports) in clips.items():
        hero.add(name, clip, supports)
    hero.start("hop-right")
    hero.advance(0.1)
    hero.start("hop-left", patience=0.0, late="mute")
    recorder = Recorder(hero, 60.0)
    for _ in range(5):
        hero.advance(1 / 60)
        recorder.keep()
    assert recorder.finish().muted.tolist() == [[False, True]] * 5
