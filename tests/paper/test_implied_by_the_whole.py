"""What the paper does not write and does not work without."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from tests.engine.test_pipeline import FPS, drift, play, walker
from tests.paper.requirements import requirement

import footfall as ff
from footfall.engine.recording import Recording
from footfall.engine.state import RUNNING
from footfall.support import Support, SupportSequence
from footfall.sync import Synchronizer


@requirement(127, "All running actions change element together, never inside a column.")
@pytest.mark.parametrize("planner", ["paper", "footfall"])
def test_phases_change_where_a_slot_ends_and_nowhere_else(planner: str) -> None:
    walk, supports = ff.sample("walk")
    hero = ff.Character(walk.skeleton, planner=planner)  # pyright: ignore[reportArgumentType]
    hero.add("walk", walk, supports)
    hero.add("run", *ff.sample("run"))
    hero.start("walk")
    hero.advance(0.5)
    hero.start("run")
    me = hero.crowd.characters[0]
    seen: list[tuple[int, tuple[int, ...]]] = []
    for _ in range(400):
        hero.advance(1 / 240)
        running = me["playing"].astype(bool)
        seen.append((int(me["slot_index"]), tuple(me["phases"][running, 0].tolist())))
    changes = 0
    for (slot, phases), (next_slot, next_phases) in pairwise(seen):
        assert slot != next_slot or phases == next_phases or len(phases) != len(next_phases)
        changes += phases != next_phases
    assert changes > 5


@requirement(130, "Each character has a synchronizer of its own, without shared state.")
def test_what_one_character_is_told_another_does_not_notice() -> None:
    crowd, alone = ff.Crowd(walker().library, 3), ff.Crowd(walker().library, 1)
    for frame in range(150):
        if frame == 0:
            crowd.start(0)
            alone.start(0)
        if frame == 40:
            crowd.start(1, [0])
            crowd.set_priority(0, 5.0, [0])
        if frame == 90:
            crowd.stop(0, [2])
        crowd.advance(1 / FPS)
        alone.advance(1 / FPS)
    assert np.array_equal(crowd.world_positions[1], alone.world_positions[0])
    assert not np.array_equal(crowd.world_positions[0], alone.world_positions[0])
    assert not np.array_equal(crowd.world_positions[2], alone.world_positions[0])


@requirement(
    131, "An action of the upper body only takes part neither in the relation nor in equation 6."
)
def test_an_action_of_the_arms_changes_neither_supports_nor_durations() -> None:
    def recorded(with_arms: bool) -> Recording:
        hero = ff.Character(ff.sample("walk")[0].skeleton)
        hero.add("walk", *ff.sample("walk"))
        hero.add("punch", *ff.sample("punch"), priority={"arms": 3.0, "trunk": 1.0})
        cues = (
            {0: ("start", "walk"), 33: ("start", "punch")} if with_arms else {0: ("start", "walk")}
        )
        return play(hero, cues, 120)

    with_it, without = recorded(True), recorded(False)
    assert np.array_equal(with_it.supports, without.supports)
    np.testing.assert_allclose(
        with_it.clip_times[:, 0], without.clip_times[:, 0], rtol=0, atol=1e-9
    )
    assert not with_it.shares[:, 1].any()
    assert np.isnan(with_it.phases[:, 1]).all()
    # It is not warped either.
    times = with_it.clip_times[:, 1]
    own = np.diff(times[~np.isnan(times)])
    np.testing.assert_allclose(own[:30], 1 / FPS, rtol=0, atol=1e-9)
    arms = [i for i, name in enumerate(ff.sample("walk")[0].skeleton.names) if "Hand" in name]
    moved = np.abs(with_it.world_positions - without.world_positions)
    assert moved[:, arms].max() > 0.05


@requirement(132, "Synchronization can be switched on and off for each character.")
def test_of_two_characters_one_is_synchronized_and_the_other_is_not() -> None:
    on, off = walker(synchronized=True), walker(synchronized=False)
    for hero in (on, off):
        hero.start("walk")
    on.advance(0.1)
    off.advance(0.1)
    recordings = [
        play(hero, {100: ("start", "run"), 171: ("stop", "walk")}, 260) for hero in (on, off)
    ]
    assert drift(recordings[0]) < 5.0
    assert drift(recordings[1]) > 20.0
    me = off.crowd.characters[0]
    assert (me["status"] >= RUNNING).any()
    assert not me["playing"].any()


@requirement(
    133,
    "The trace holds, per column, the elements, the result, who was held, durations, and the "
    "reason of a delay.",
)
def test_the_trace_tells_everything_that_a_figure_is_drawn_from() -> None:
    synchronizer = Synchronizer(
        [SupportSequence.parse("R.4 D.1 L.4 D.1*"), SupportSequence.parse("L.3 -.2*")],
        [0.7, 0.3],
        names=["walk", "hop"],
        planner="paper",
    )
    synchronizer.start(0)
    assert not synchronizer.start(1)
    for _ in range(3):
        synchronizer.next_slot()
    trace = synchronizer.trace
    walk, hop = trace.rows
    assert trace.first_slot == 0
    assert trace.results == (Support.RIGHT, Support.LEFT, Support.FLIGHT, Support.LEFT)
    assert walk.phases == (0, 1, 2, 3)
    assert hop.phases == (None, 0, 1, 0)
    assert hop.waits == ("waits: L of 'hop' conflicts with R of 'walk'", "", "", "")
    assert trace.durations == pytest.approx((0.4, 0.16, 0.34, 0.16))
    assert walk.held == hop.held == (False,) * 4
    assert walk.muted == (False,) * 4
    assert walk.stretches == pytest.approx((1.0, 1.6, 0.85, 1.6))
