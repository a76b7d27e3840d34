"""Time in the studio: as many frames as pass, whatever the speed, and none while it is paused."""

from __future__ import annotations

import time
from contextlib import nullcontext
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.studio.sessions import Heard, session_of

from footfall.scenario.cue_sheet import Cue
from footfall.scenario.ground_change import GroundChange
from footfall.studio.clock import FRAME, MOST_BEHIND, StudioClock
from footfall.studio.session import Session


class Scene:
    """Keeps what it is told to show."""

    crowd = None

    def __init__(self) -> None:
        self.called: list[str] = []
        self.hips: list[Any] = []

    def atomic(self) -> Any:
        return nullcontext()

    def pose_body(self, positions: Any, *_: Any) -> None:
        self.called.append("pose_body")
        self.hips.append(positions[0].copy())

    def __getattr__(self, name: str) -> Any:
        def shown(*_: object, **__: object) -> None:
            self.called.append(name)

        return shown


def clock_of(folder: Path, *names: str) -> tuple[StudioClock, Session, Scene, Heard]:
    session, heard = session_of(folder, *names)
    scene: Any = Scene()
    return StudioClock(session, scene), session, scene, heard


@pytest.mark.parametrize(("speed", "frames"), [(1.0, 60), (0.5, 30), (0.25, 15), (0.1, 6)])
def test_a_second_is_so_many_frames(tmp_path: Path, speed: float, frames: int) -> None:
    clock, session, _, heard = clock_of(tmp_path, "walk")
    session.stage.start(session.stage.cards[0])
    session.speed = speed
    for _ in range(60):
        clock.tick(FRAME)
    assert abs(session.stage.pair()[0].frame - frames) <= 1
    # Every second picture is told.
    assert heard.kinds().count("tick") in (0, 60)


def test_a_jittering_clock_gives_one_frame_a_picture(tmp_path: Path) -> None:
    clock, session, _, _ = clock_of(tmp_path, "walk")
    session.stage.start(session.stage.cards[0])
    frames: list[int] = []
    for number in range(60):
        clock.tick(FRAME * (1.3 if number % 2 else 0.7))
        frames.append(session.stage.pair()[0].frame)
    assert set(np.diff(frames)) == {1}


def test_a_long_halt_is_made_up_for_only_so_far(tmp_path: Path) -> None:
    clock, session, _, _ = clock_of(tmp_path, "walk")
    session.stage.start(session.stage.cards[0])
    clock.tick(5.0)
    assert session.stage.pair()[0].frame == int(MOST_BEHIND * 60)


def test_nothing_moves_while_it_is_paused_and_it_is_still_drawn(tmp_path: Path) -> None:
    clock, session, scene, _ = clock_of(tmp_path, "walk")
    session.stage.start(session.stage.cards[0])
    clock.tick(FRAME)
    session.paused = True
    frame = session.stage.pair()[0].frame
    for _ in range(10):
        clock.tick(FRAME)
    assert session.stage.pair()[0].frame == frame
    assert scene.called.count("pose_body") == 11


def test_slow_motion_shows_what_is_between_two_frames(tmp_path: Path) -> None:
    clock, session, scene, _ = clock_of(tmp_path, "walk")
    session.stage.start(session.stage.cards[0])
    for _ in range(60):
        clock.tick(FRAME)
    session.speed = 0.25
    scene.hips.clear()
    for _ in range(24):
        clock.tick(FRAME)
    steps = np.linalg.norm(np.diff(scene.hips, axis=0), axis=-1)
    assert steps.min() > 0.0
    assert steps[4:].max() < 1.5 * steps[4:].min()


def test_a_take_that_is_opened_plays_by_itself(tmp_path: Path) -> None:
    clock, session, _, _ = clock_of(tmp_path, "walk", "run")
    session.script = [
        Cue(0.0, "start", "walk"),
        Cue(0.25, "start", "run"),
        Cue(0.5, "ground", ground=GroundChange(0.1)),
    ]
    for _ in range(60):
        clock.tick(FRAME)
    assert session.script == []
    cues = session.stage.take.scenario.cues
    assert [(cue.kind, cue.at) for cue in cues] == [
        ("start", 0.0),
        ("start", 0.25),
        ("ground", 0.5),
    ]


def test_the_ghost_is_drawn_only_where_it_is_wanted(tmp_path: Path) -> None:
    clock, session, scene, _ = clock_of(tmp_path, "walk")
    clock.tick(FRAME)
    assert "pose_ghost" not in scene.called
    session.ghost = True
    clock.tick(FRAME)
    assert scene.called.count("pose_ghost") == 1


def test_the_clip_that_is_edited_plays_round_and_stands_where_it_is_sought(tmp_path: Path) -> None:
    clock, session, scene, heard = clock_of(tmp_path, "walk")
    session.show("supports")
    assert session.editor is not None
    duration = session.editor.clip.duration
    for _ in range(round(duration / FRAME) + 30):
        clock.tick(FRAME)
    assert session.clip_time == pytest.approx(30 * FRAME, abs=2 * FRAME)
    session.clip_plays, session.clip_time = False, 0.4
    scene.hips.clear()
    clock.tick(FRAME)
    clock.tick(FRAME)
    assert session.clip_time == 0.4
    assert scene.hips[0][1] == pytest.approx(
        float(np.interp(0.4 * 60, range(65), session.editor.clip.pelvis_positions[:, 1])), abs=1e-6
    )
    assert heard.messages[-1]["kind"] == "clock"


def test_a_crowd_lives_at_half_the_rate(tmp_path: Path) -> None:
    clock, session, scene, heard = clock_of(tmp_path, "walk")
    session.crowd_size = 5
    session.show("crowd")
    session.jobs.wait()
    assert session.crowd is not None
    before = session.crowd.frame
    for _ in range(60):
        clock.tick(FRAME)
    assert abs(session.crowd.frame - before - 30) <= 1
    assert "pose_crowd" in scene.called
    assert "herd" in heard.kinds()


def test_it_runs_by_itself_until_it_is_stopped(tmp_path: Path) -> None:
    clock, session, scene, _ = clock_of(tmp_path, "walk")
    session.stage.start(session.stage.cards[0])
    clock.start()
    for _ in range(500):
        if session.stage.pair()[0].frame > 5:
            break
        time.sleep(0.02)
    clock.stop()
    frame = session.stage.pair()[0].frame
    assert frame > 5
    assert "follow" in scene.called
    time.sleep(0.1)
    assert session.stage.pair()[0].frame == frame


def test_a_stage_without_a_motion_lets_time_pass(tmp_path: Path) -> None:
    clock, session, scene, _ = clock_of(tmp_path)
    for view in ("stage", "supports", "crowd"):
        session.show(view)
        clock.tick(FRAME)
    assert set(scene.called) == {"look"}
