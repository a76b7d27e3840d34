"""A gait that follows its speed while it plays."""

from __future__ import annotations

import numpy as np
import pytest
from tests.paper.requirements import requirement

import footfall as ff
from footfall.arrays import Floats
from footfall.engine import Recorder, Recording
from footfall.errors import ArgumentError, UnknownNameError
from footfall.report import Trace, measure
from footfall.skeleton import find_anatomy
from footfall.sync.tables import Planner

FPS = 60
NAMES = ("walk-slow", "walk", "walk-fast", "run")


def goer(planner: Planner = "footfall", speed: float = 0.8) -> ff.Character:
    clips = [ff.sample(name) for name in NAMES]
    hero = ff.Character(clips[0][0].skeleton, planner=planner)
    hero.add_locomotion("go", clips, speed=speed)
    hero.add("kick", *ff.sample("kick"))
    return hero


def play(hero: ff.Character, speeds: dict[int, float], frames: int) -> tuple[Recording, Floats]:
    recorder, asked = Recorder(hero, FPS), np.zeros(frames)
    hero.start("go")
    for frame in range(frames):
        if frame in speeds:
            hero.set_parameters("go", speed=speeds[frame])
        hero.advance(1 / FPS if frame else 0.0)
        recorder.keep()
        asked[frame] = hero.parameters_of("go")[0]
    return recorder.finish(), asked


def acceleration(recording: Recording) -> Floats:
    moved = np.diff(recording.world_positions, 2, axis=0)
    greatest: Floats = np.linalg.norm(moved, axis=-1).max(axis=1) * FPS * FPS
    return greatest


@requirement(31, "can simply replay a motion or can adapt it to parameters as parametric models do")
@requirement(
    106, "It also works while using parametric models such as locomotion or grasping models."
)
@pytest.mark.parametrize("planner", ["footfall", "paper"])
def test_it_goes_from_a_walk_to_a_run_and_back_without_a_pop_or_a_slide(planner: Planner) -> None:
    recording, asked = play(goer(planner), {100: 3.2, 420: 1.0}, 700)
    assert "-" in recording.support_text[250:420]
    assert "-" not in recording.support_text[:100] + recording.support_text[600:]
    way = recording.world_positions[:, 0, 2]
    for begin in (20, 280, 600):
        spent = slice(begin, begin + 100)
        speed = (way[begin + 99] - way[begin]) * FPS / 99
        assert speed == pytest.approx(float(asked[spent].mean()), rel=0.06)
    # The run alone accelerates its feet by 147 m/s².
    assert acceleration(recording).max() < (1.2 if planner == "footfall" else 3.0) * 147.0
    trace = Trace(
        recording.world_positions,
        recording.world_rotations,
        find_anatomy(recording.skeleton),
        FPS,
        recording.supports,
    )
    slip = measure(trace).slip.overall.p95
    assert slip is not None
    # In millimeters; the rule as printed lets flights ring, and decides nothing anew (S-16, S-25).
    assert slip < (2.0 if planner == "footfall" else 15.0)


def test_its_speed_follows_what_is_asked_at_a_fixed_pace_however_time_is_cut() -> None:
    heroes = goer(), goer()
    for hero, step in zip(heroes, (1 / 60, 1 / 240), strict=True):
        hero.start("go")
        hero.advance(0.5)
        hero.set_parameters("go", speed=2.0)
        for _ in range(round(0.4 / step)):
            hero.advance(step)
    speeds = [hero.parameters_of("go")[0] for hero in heroes]
    assert speeds == pytest.approx([1.4, 1.4])
    places = [hero.advance(0.0).world_positions[0] for hero in heroes]
    assert places[0] == pytest.approx(places[1], abs=5e-3)


@pytest.mark.parametrize(("speed", "turn"), [(1.6, 0.3), (2.2, 0.4), (2.6, -0.5), (3.0, 0.6)])
def test_it_turns_as_asked_between_the_clips_and_its_feet_hold(speed: float, turn: float) -> None:
    names = ("walk", "walk-fast", "run", "walk-left", "walk-right", "run-left", "run-right")
    clips = [ff.sample(name) for name in names]
    hero = ff.Character(clips[0][0].skeleton)
    hero.add_locomotion("go", clips, speed=speed, turn=turn)
    recording, _ = play(hero, {}, 180)
    begun = hero.root[2]
    seconds = 1.5
    way = 0.0
    for _ in range(round(seconds * FPS)):
        before = hero.root
        hero.advance(1 / FPS)
        way += float(np.hypot(hero.root[0] - before[0], hero.root[1] - before[1]))
    # A stride does not turn evenly, and is no whole part of the time.
    assert (hero.root[2] - begun) / seconds == pytest.approx(turn, rel=0.06)
    assert way / seconds == pytest.approx(speed, rel=0.03)
    motion = recording.world_positions, recording.world_rotations
    trace = Trace(*motion, find_anatomy(recording.skeleton), FPS, recording.supports)
    slip = measure(trace).slip.overall.p95
    assert slip is not None
    assert slip < 1.5


def test_where_nobody_goes_the_speed_is_there_at_once() -> None:
    hero = goer()
    hero.set_parameters("go", speed=3.0)
    assert hero.parameters_of("go") == (3.0, pytest.approx(0.0, abs=1e-9))
    hero.start("go")
    hero.advance(0.5)
    assert hero.schedule.rows[0].supports[0] is not None
    hero.add("late", *ff.sample("punch"))
    hero.advance(0.1)
    assert hero.parameters_of("go")[0] == 3.0
    assert {phase.support.symbol for phase in hero.crowd.supports_of(0).phases} == {"R", "-", "L"}


@requirement(
    32, "information on used motions cannot be precomputed since they can be modified in real-time"
)
def test_it_is_synchronized_with_others_while_its_sequence_changes() -> None:
    hero = goer(speed=1.3)
    hero.start("go")
    supports: set[str] = set()
    for frame in range(600):
        if frame == 60:
            hero.start("kick")
            hero.set_parameters("go", speed=3.0)
        if frame == 300:
            hero.start("kick")
        hero.advance(1 / FPS)
        supports.add(hero.advance(0.0).support.symbol)
    assert "Err" not in supports
    assert "-" in supports


def test_a_crowd_shares_one_speed_and_every_row_keeps_its_place() -> None:
    library = ff.MotionLibrary()
    library.add_locomotion("go", [ff.sample(name) for name in NAMES], speed=1.0)
    crowd = ff.Crowd(library, 3)
    for row in range(3):
        crowd.start(0, [row])
        crowd.advance(0.21)
    before = crowd.world_positions.copy()
    crowd.set_parameters(0, speed=3.0)
    crowd.advance(1 / 60)
    assert np.abs(crowd.world_positions - before).max() < 0.1
    crowd.advance(3.0)
    assert crowd.parameters_of(0)[0] == 3.0


def test_what_cannot_be_asked_for_is_told() -> None:
    hero = goer()
    with pytest.raises(ArgumentError) as caught:
        hero.set_parameters("kick", speed=1.0)
    assert str(caught.value) == (
        "'kick' is one clip and has no parameters; add_locomotion makes an action of several"
    )
    with pytest.raises(ArgumentError) as caught:
        hero.set_parameters("go", speed=5.0)
    assert str(caught.value) == "speed is 5.0 m/s; the clips go from 0.75 to 3.30 m/s"
    with pytest.raises(UnknownNameError):
        hero.set_parameters("fly", speed=1.0)
    with pytest.raises(ArgumentError) as caught:
        hero.add_locomotion("none", [])
    assert str(caught.value) == "'none' has no clip; a locomotion needs at least one"
    with pytest.raises(ArgumentError) as caught:
        hero.add_locomotion("go", [ff.sample("walk")])
    assert str(caught.value) == "there already is an action named 'go'; names must differ"
