"""Figure 16 and dynamicEnv.avi: several motions on a floor that is changed while they play."""

from __future__ import annotations

import numpy as np
import pytest
from tests.engine.test_pipeline import FPS
from tests.engine.test_treading import GROUNDS, trace, walked
from tests.paper.requirements import requirement

import footfall as ff
from footfall.adaptation import AnyGround, Plane
from footfall.arrays import Floats
from footfall.engine.recording import Recorder, Recording
from footfall.report import Track, measure


@pytest.fixture(scope="module")
def resting() -> Floats:
    return Track.from_trace(trace(walked(Plane()), Plane(), None)).resting_levels


def performed(ground: AnyGround, changes: dict[int, AnyGround] | None = None) -> Recording:
    """Let a walk, a faster walk and a run come and go on a ground."""
    hero = ff.Character(ff.sample("walk")[0].skeleton, ground=ground)
    for name in ("walk", "walk-fast", "run"):
        hero.add(name, *ff.sample(name))
    cues = {
        0: (hero.start, "walk"),
        80: (hero.start, "walk-fast"),
        150: (hero.stop, "walk"),
        200: (hero.start, "run"),
    }
    recorder = Recorder(hero, FPS)
    for frame in range(300):
        if changes and frame in changes:
            hero.crowd.ground = changes[frame]
        if frame in cues:
            command, name = cues[frame]
            command(name)
        hero.advance(1 / FPS if frame else 0.0)
        recorder.keep()
    return recorder.finish()


@requirement(98, "The dynamic synchronization associated with footprint handling")
@requirement(102, "gives the complete animation with the moving floor")
@pytest.mark.parametrize("name", ["a platform that rises and sinks", "a turntable", "hills"])
def test_planted_feet_keep_their_prints_on_a_floor_that_moves(name: str, resting: Floats) -> None:
    report = measure(trace(performed(GROUNDS[name]), GROUNDS[name], resting))
    assert report.drift.overall.p95 is not None
    assert report.drift.overall.p95 <= 5.0


@requirement(101, "the character is animated on an interactively changing ground")
def test_the_floor_is_changed_by_the_user_while_motions_are_mixed() -> None:
    changes: dict[int, AnyGround] = {
        60: Plane(0.05),
        120: Plane(0.05, (0.0, 0.01)),
        240: Plane(0.1, (0.03, 0.0)),
    }
    changed, level = performed(Plane(), changes), performed(Plane())
    assert np.array_equal(changed.phases, level.phases, equal_nan=True)
    assert np.isfinite(changed.world_positions).all()
    rise = changed.world_positions[:, 0, 1] - level.world_positions[:, 0, 1]
    assert np.abs(rise[:60]).max() < 1e-12
    assert np.abs(rise[60:]).max() > 0.04

    def sudden(recording: Recording) -> float:
        jumps = np.diff(recording.world_positions, n=2, axis=0)
        return float(np.abs(jumps).max()) * FPS**2

    assert sudden(changed) < 4.0 * sudden(level)
