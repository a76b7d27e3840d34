"""The whole engine on motions with exactly known supports."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import footfall as ff
from footfall.arrays import Floats, Positions
from footfall.engine import Recorder, Recording
from footfall.errors import ArgumentError, SkeletonError, UnknownNameError
from footfall.motion import extract_root_path
from footfall.report import Trace, measure
from footfall.skeleton import find_anatomy

FPS = 60


def walker(*, synchronized: bool = True, footprints: bool = True) -> ff.Character:
    walk, supports = ff.sample("walk")
    hero = ff.Character(walk.skeleton, synchronized=synchronized, footprints=footprints)
    hero.add("walk", walk, supports)
    run, run_supports = ff.sample("run")
    hero.add("run", run, run_supports)
    return hero


def play(hero: ff.Character, cues: dict[int, tuple[str, str]], frames: int) -> Recording:
    recorder = Recorder(hero, FPS)
    for frame in range(frames):
        if frame in cues:
            command, name = cues[frame]
            getattr(hero, command)(name)
        hero.advance(1 / FPS if frame else 0.0)
        recorder.keep()
    return recorder.finish()


CUES = {0: ("start", "walk"), 100: ("start", "run"), 171: ("stop", "walk")}


def drift(recording: Recording) -> float:
    trace = Trace(
        recording.world_positions,
        recording.world_rotations,
        find_anatomy(recording.skeleton),
        recording.fps,
        recording.supports,
        shares=recording.shares,
        moving=recording.moving,
    )
    drifts: Any = measure(trace).to_json()["drift_mm"]
    return float(drifts["p95"])


def test_one_clip_alone_comes_back_as_it_was() -> None:
    walk, _ = ff.sample("walk")
    hero = walker(footprints=False)
    recording = play(hero, {0: ("start", "walk")}, 180)
    _, clip_positions = walk.world_poses()
    stride = clip_positions[-1, 0] - clip_positions[0, 0]
    stride[1] = 0.0
    for frame in range(180):
        cycles, within = divmod(frame, walk.frames - 1)
        expected = clip_positions[within] + cycles * stride
        moved = recording.world_positions[frame] - expected
        start = recording.world_positions[0] - clip_positions[0]
        assert np.abs(moved - start).max() < 1e-5


@pytest.mark.parametrize("name", ["kick", "jump", "walk-to-hop"])
def test_a_clip_that_plays_once_comes_back_as_it_was(name: str) -> None:
    clip, supports = ff.sample(name)
    hero = ff.Character(clip.skeleton, footprints=False)
    hero.add(name, clip, supports)
    path = extract_root_path(clip, find_anatomy(clip.skeleton))
    hero.place(path.positions[0, 0], path.positions[0, 1], path.headings[0])
    recording = play(hero, {0: ("start", name)}, clip.frames)
    _, clip_positions = clip.world_poses()
    moved = recording.world_positions - clip_positions
    assert np.abs(moved - moved[0]).max() < 1e-3


def test_feet_hold_through_a_start_and_a_stop() -> None:
    assert drift(play(walker(), CUES, 260)) < 5.0


def test_without_synchronization_feet_slide() -> None:
    assert drift(play(walker(synchronized=False), CUES, 260)) > 20.0


def test_the_same_commands_give_the_same_bits() -> None:
    one, other = play(walker(), CUES, 200), play(walker(), CUES, 200)
    assert np.array_equal(one.world_positions, other.world_positions)
    assert np.array_equal(one.world_rotations, other.world_rotations)


def test_a_crowd_moves_each_row_like_a_character_alone() -> None:
    hero = walker()
    crowd = ff.Crowd(hero.library, 3)
    crowd.start(0)
    hero.start("walk")
    for frame in range(120):
        if frame == 70:
            crowd.start(1, [1])
            hero.start("run")
        crowd.advance(1 / FPS)
        hero.advance(1 / FPS)
    alone = hero.crowd.world_positions[0]
    assert np.array_equal(crowd.world_positions[1], alone)
    assert not np.array_equal(crowd.world_positions[0], alone)


def accelerations(positions: Positions) -> Floats:
    return np.linalg.norm(np.diff(positions, n=2, axis=0), axis=-1) * FPS**2


def test_joints_do_not_pop() -> None:
    run, _ = ff.sample("run")
    _, clip_positions = run.world_poses()
    recording = play(walker(), CUES, 260)
    assert (
        accelerations(recording.world_positions).max() < 1.5 * accelerations(clip_positions).max()
    )


def test_a_long_advance_equals_short_ones_in_clock_and_schedule() -> None:
    one, other = walker(), walker()
    for hero in (one, other):
        hero.start("walk")
        hero.advance(0.0)
    one.advance(1.0)
    for _ in range(60):
        other.advance(1 / FPS)
    for field in ("clock", "slot_index", "phases", "support"):
        assert np.allclose(
            one.crowd.characters[field].astype(float), other.crowd.characters[field].astype(float)
        )


def test_commands_that_cannot_be_meant_are_refused() -> None:
    hero = walker()
    with pytest.raises(UnknownNameError, match="no action named 'walc'; there are: walk, run"):
        hero.start("walc")
    with pytest.raises(ArgumentError, match="dt is -1 s; it must be finite and >= 0"):
        hero.advance(-1)
    with pytest.raises(ArgumentError, match="there already is an action named 'walk'"):
        hero.add("walk", *ff.sample("walk"))
    small = ff.Skeleton(("Hips",), np.array([-1]), np.zeros((1, 3)))
    clip = ff.Clip(small, np.zeros((2, 3)), np.tile([1.0, 0, 0, 0], (2, 1, 1)), 1.0)
    with pytest.raises(
        SkeletonError, match="'stub' moves another skeleton and cannot be retargeted: no legs found"
    ):
        hero.add("stub", clip, ff.SupportSequence.parse("D"))
