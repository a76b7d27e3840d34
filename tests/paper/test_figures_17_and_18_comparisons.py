"""Figures 17 and 18: the same commands without and with synchronization."""

from __future__ import annotations

import json
import struct
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from tests.engine.test_pipeline import FPS, drift
from tests.paper.requirements import requirement

import footfall as ff
from footfall.engine.recording import Recorder, Recording
from footfall.report import Trace, measure_spans
from footfall.report.track import Track
from footfall.skeleton import find_anatomy
from footfall.sync.tables import Planner

Cues = dict[int, tuple[str, str]]

FIGURE_17: Cues = {
    0: ("start", "walk"),
    70: ("start", "walk-fast"),
    75: ("stop", "walk"),
    152: ("start", "run"),
    157: ("stop", "walk-fast"),
    230: ("start", "walk-slow"),
    235: ("stop", "run"),
}
SAME_KIND: Cues = {frame: cue for frame, cue in FIGURE_17.items() if frame < 152}
FIGURE_18: Cues = {
    0: ("start", "walk"),
    64: ("start", "kick"),
    68: ("stop", "walk"),
    190: ("start", "walk-fast"),
    290: ("start", "jump"),
    294: ("stop", "walk-fast"),
}


def perform(
    cues: Cues, synchronized: bool, frames: int, planner: Planner = "footfall"
) -> tuple[Recording, list[str]]:
    """Play some cues; return the recording and the actions that had to wait."""
    body = ff.sample("walk")[0].skeleton
    hero = ff.Character(body, synchronized=synchronized, planner=planner)
    for name in dict.fromkeys(name for _, name in cues.values()):
        hero.add(name, *ff.sample(name))
    recorder = Recorder(hero, FPS)
    waited: list[str] = []
    for frame in range(frames):
        command, name = cues.get(frame, ("", ""))
        if command == "start" and isinstance(hero.start(name), ff.Waiting):
            waited.append(name)
        elif command == "stop":
            hero.stop(name)
        hero.advance(1 / FPS if frame else 0.0)
        recorder.keep()
    return recorder.finish(), waited


@cache
def figure(number: int, synchronized: bool) -> tuple[Recording, list[str]]:
    if number == 17:
        return perform(FIGURE_17, synchronized, 320)
    # The default planner finds room for all of them at once: the delays are the paper's.
    return perform(FIGURE_18, synchronized, 420, "paper")


def slides(recording: Recording) -> int:
    """Return how many times a planted foot slides by more than two centimeters."""
    track = Track.from_trace(
        Trace(
            recording.world_positions,
            recording.world_rotations,
            find_anatomy(recording.skeleton),
            recording.fps,
            recording.supports,
            shares=recording.shares,
            moving=recording.moving,
        )
    )
    return sum(span.drift > 0.02 for span in measure_spans(track))


@requirement(
    88,
    "When there are transitions between motions (in red) the feet are sliding on the floor. With "
    "synchronization (second row), the foot strikes are respected.",
)
def test_figure_17_feet_slide_at_the_transitions_without_and_nowhere_with() -> None:
    without, with_it = (figure(17, synchronized)[0] for synchronized in (False, True))
    assert slides(without) >= 3
    assert slides(with_it) == 0
    assert drift(with_it) < 5.0
    assert drift(without) > 4.0 * drift(with_it)


@requirement(
    89,
    "even with motions of the same kind (such as locomotion in this example), the synchronization"
    " of motions is really important",
)
def test_walks_alone_need_it_too() -> None:
    without, with_it = (perform(SAME_KIND, on, 150)[0] for on in (False, True))
    assert slides(without) >= 1
    assert slides(with_it) == 0


@requirement(
    90,
    "This animation with motions such as walking, fighting, another walking and a jump shows "
    "delayed actions.",
)
def test_figure_18_a_locomotion_a_fight_another_locomotion_and_a_jump() -> None:
    (without, at_once), (with_it, waited) = figure(18, False), figure(18, True)
    assert at_once == []
    assert waited
    for recording in (without, with_it):
        played = ~np.isnan(recording.clip_times)
        assert played.any(axis=0).all()
    # The delay: what waited begins later than without.
    late = [with_it.actions.index(name) for name in waited]
    begins = [(~np.isnan(one.clip_times)).argmax(axis=0)[late] for one in (without, with_it)]
    assert (begins[1] >= begins[0]).all()
    assert (begins[1] > begins[0] + 10).any()
    assert drift(with_it) < 5.0
    assert slides(with_it) == 0


@requirement(91, "The last row gives the same synchronized animation using a skinned character.")
@pytest.mark.parametrize("ending", ["glb"])
def test_figure_18_is_written_as_a_skinned_character(ending: str, tmp_path: Path) -> None:
    recording, _ = figure(18, True)
    path = tmp_path / f"figure_18.{ending}"
    ff.save(recording.to_clip("figure 18"), path)
    content = path.read_bytes()
    (length,) = struct.unpack("<I", content[12:16])
    document = json.loads(content[20 : 20 + length])
    assert len(document["skins"]) == 1
    assert any("JOINTS_0" in p["attributes"] for m in document["meshes"] for p in m["primitives"])
    assert len(document["animations"]) == 1
