"""Figures 13 to 15 and section 6: handball shots with a run, walk-to-hop, side step with walks."""

from __future__ import annotations

import math

import numpy as np
import pytest
from tests.engine.test_pipeline import FPS
from tests.paper.requirements import requirement

import footfall as ff
from footfall.arrays import Floats
from footfall.support import Support, SupportSequence
from footfall.sync import Synchronizer


@requirement(94, "some examples of handball shots synchronized with a run")
@pytest.mark.parametrize("planner", ["paper", "footfall"])
@pytest.mark.parametrize("slots", range(4))
def test_figure_13_handball_shots_go_with_a_run_begun_at_any_of_its_phases(
    planner: str, slots: int
) -> None:
    synchronizer = Synchronizer(
        [ff.sample("run")[1], ff.sample("shot")[1]],
        planner=planner,  # pyright: ignore[reportArgumentType]
        ended="stop" if planner == "paper" else None,
    )
    synchronizer.start(0)
    for _ in range(slots):
        synchronizer.next_slot()
    synchronizer.start(1)
    waited = 0
    while synchronizer.waiting:
        synchronizer.next_slot()
        waited += 1
    assert waited <= 3
    played: set[int] = set()
    for _ in range(24):
        assert synchronizer.next_slot() is not Support.CONFLICT
        phase = synchronizer.trace.rows[1].phases[-1]
        if phase is not None:
            played.add(phase)
    # The shot comes to its end, with each of its phases.
    assert played | {0} == set(range(len(ff.sample("shot")[1].phases)))


@requirement(96, "These cases can be avoided by coupling normal motions with critical ones")
def test_figure_14_a_hop_that_begins_with_steps_goes_with_what_a_bare_hop_does_not() -> None:
    left, right = SupportSequence.parse("L -*"), SupportSequence.parse("R -*")
    led_in = SupportSequence.parse("R D L D R - R - R D")
    for late, starts in ((right, False), (led_in, True)):
        synchronizer = Synchronizer([left, late], names=["left hop", "late"])
        synchronizer.start(0)
        synchronizer.start(1)
        for _ in range(12):
            synchronizer.next_slot()
        assert (1 not in synchronizer.waiting) is starts


def displacement(heading: float, shares: tuple[float, float], seconds: float) -> Floats:
    """Return where a mix of a walk and a side step takes a body that looks this way [m]."""
    hero = ff.Character(ff.sample("walk")[0].skeleton)
    for name, share in zip(("walk", "side-step"), shares, strict=True):
        if share > 0.0:
            hero.add(name, *ff.sample(name), priority=share)
    hero.place(0.0, 0.0, heading)
    for action in hero.library.actions:
        hero.start(action.name)
    places = np.array([_root(hero, 1 / FPS) for _ in range(round(seconds * FPS))])
    return places[-1] - places[round(0.5 * seconds * FPS)]


def _root(hero: ff.Character, dt: float) -> Floats:
    """Let time pass, and return where the body then is on the ground, x and z [m]."""
    hero.advance(dt)
    me = hero.crowd.characters[0]
    return np.array([float(me["root"][0]), float(me["root"][1])])


def angle(way: Floats) -> float:
    return math.atan2(way[0], way[1])


@requirement(
    99,
    "in order to force the avatar's displacement on a linear path whatever its local orientation",
)
@pytest.mark.parametrize("share", [0.0, 0.25, 0.5, 0.75, 1.0])
def test_figure_15_side_step_and_walk_go_straight_whatever_the_bodys_orientation(
    share: float,
) -> None:
    shares = (1.0 - share, share)
    local = angle(displacement(0.0, shares, 8.0))
    # Turned by as much, the body goes along +z, looking elsewhere.
    way = displacement(-local, shares, 8.0)
    assert abs(math.degrees(angle(way))) < 3.0
    assert np.linalg.norm(way) > 0.5
    assert (share > 0.0) == (abs(math.degrees(local)) > 2.0)


@requirement(100, "The same example could be easily extended to a non-linear path.")
def test_and_on_a_path_that_bends_while_the_body_looks_the_same_way() -> None:
    hero = ff.Character(ff.sample("walk")[0].skeleton)
    hero.add("walk", *ff.sample("walk"), priority=8.0)
    hero.add("side-step", *ff.sample("side-step"), priority=0.1)
    hero.start("walk")
    hero.start("side-step")
    places: list[Floats] = []
    headings: list[float] = []
    for frame in range(12 * FPS):
        if frame % 30 == 29:
            share = frame / (12 * FPS)
            hero.set_priority("walk", 8.0 * (1.0 - share) + 0.01, fade=0.0)
            hero.set_priority("side-step", 8.0 * share + 0.01, fade=0.0)
        places.append(_root(hero, 1 / FPS))
        headings.append(float(hero.crowd.characters[0]["root"][2]))
    thirds = [places[4 * FPS * k + 4 * FPS - 1] - places[4 * FPS * k] for k in range(3)]
    turns = np.degrees(np.unwrap([angle(way) for way in thirds]))
    assert np.abs(np.diff(turns)).min() > 10.0
    assert np.abs(np.degrees(np.array(headings) - headings[0])).max() < 8.0
