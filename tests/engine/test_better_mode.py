"""Ended motions, conflicts under flight, muting and arms alone, in the engine (S-3, S-6, S-15)."""

from __future__ import annotations

import numpy as np

import footfall as ff
from footfall.engine import Impossible, Waiting
from footfall.support import Support

FPS = 60


def character(**priorities: float | dict[str, float]) -> ff.Character:
    clips = {name.replace("_", "-"): priority for name, priority in priorities.items()}
    hero = ff.Character(ff.sample(next(iter(clips)))[0].skeleton)
    for name, priority in clips.items():
        hero.add(name, *ff.sample(name), priority=priority)
    return hero


def test_a_motion_that_has_ended_makes_way_by_itself_and_blocks_nobody() -> None:
    hero = character(walk=1.0, kick=3.0)
    hero.start("walk")
    hero.advance(0.4)
    hero.start("kick")
    active: list[bool] = []
    for _ in range(6 * FPS):
        support = hero.advance(1 / FPS).support
        assert support is not Support.CONFLICT
        active.append(hero.is_active("kick"))
    assert not active[-1]
    before = hero.advance(0.0).world_positions[0].copy()
    hero.advance(2.0)
    # The walk goes on at its own speed: S-3 had starved it.
    assert np.linalg.norm(hero.advance(0.0).world_positions[0] - before) > 2.0


def test_stopping_the_one_that_flies_never_reveals_a_conflict() -> None:
    for moment in range(10, 130, 7):
        hero = character(walk=1.0, side_step=1.0, hop_right=1.0)
        for name in ("walk", "side-step", "hop-right"):
            hero.start(name)
            hero.advance(0.15)
        for frame in range(240):
            if frame == moment:
                hero.stop("hop-right")
            assert hero.advance(1 / FPS).support is not Support.CONFLICT
            results = hero.schedule.results
            assert Support.CONFLICT not in results


def test_a_hop_on_each_leg_never_starts_and_says_that_it_cannot() -> None:
    hero = character(hop_right=1.0, hop_left=1.0)
    hero.start("hop-right")
    hero.advance(0.2)
    answer = hero.start("hop-left")
    assert isinstance(answer, Impossible)
    assert answer.until is None
    assert "hop-right" in answer.reason
    hero.advance(4.0)
    assert hero.is_waiting("hop-left")
    hero.stop("hop-right")
    hero.advance(2.0)
    assert not hero.is_waiting("hop-left")


def test_a_start_that_mutes_plays_its_arms_and_leaves_the_legs_alone() -> None:
    hero, alone = character(hop_right=1.0, hop_left=1.0), character(hop_right=1.0)
    for one in (hero, alone):
        one.start("hop-right")
        one.advance(0.2)
    assert isinstance(hero.start("hop-left", patience=0.3, late="mute"), Waiting)
    for _ in range(100):
        both, single = hero.advance(1 / FPS), alone.advance(1 / FPS)
        assert both.support is single.support
    state = hero.state("hop-left")
    assert state.activity != "waiting"
    assert state.weights[0] == 0.0
    assert state.weights[4] > 0.0


def test_an_action_of_the_arms_is_no_part_of_the_schedule_nor_of_its_durations() -> None:
    arms = {"arms": 2.0, "trunk": 1.0}
    hero, alone = character(walk=1.0, punch=arms), character(walk=1.0)
    for one in (hero, alone):
        one.start("walk")
        one.advance(0.33)
    assert isinstance(hero.start("punch"), ff.Started)
    feet = [leg.ankle for leg in hero.library.anatomy.legs]
    moved = False
    for _ in range(90):
        both, single = hero.advance(1 / FPS), alone.advance(1 / FPS)
        assert both.support is single.support
        assert str(hero.schedule) == str(alone.schedule)
        times = [one.state("walk").clip_time for one in (hero, alone)]
        assert abs(times[0] - times[1]) < 1e-12
        apart = both.world_positions[feet] - single.world_positions[feet]
        assert np.abs(apart).max() < 1e-9
        moved = moved or not np.array_equal(both.world_positions, single.world_positions)
    assert moved
    # It is not warped: its clip has gone on second by second.
    assert hero.state("punch").rate in (0.0, 1.0)
