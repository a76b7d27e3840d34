"""A user's program makes a motion: it plays as a clip does, and a crash in it harms nothing."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from tests.actions.test_motion_source import Replay, crash, nowhere, replay

from footfall.arrays import Positions
from footfall.engine import Character, Crowd, MotionLibrary
from footfall.errors import ArgumentError, ClipError, SourceError, UnknownNameError
from footfall.geometry import from_yaw, multiply
from footfall.samples import sample
from footfall.skeleton import Skeleton
from footfall.support import SupportSequence


def higher(given: Any) -> Any:
    return given[0] + np.array([0.0, 0.05, 0.0]), given[1]


def walker(*, source: Replay | None = None) -> Character:
    walk, supports = sample("walk")
    hero = Character(walk.skeleton)
    if source is None:
        hero.add("walk", walk, supports)
    else:
        hero.add_source("walk", source)
    hero.add("run", *sample("run"), priority=2.0)
    hero.start("walk")
    return hero


def play(hero: Character, frames: int = 30) -> Positions:
    return np.stack([hero.advance(1 / 60).world_positions.copy() for _ in range(frames)])


def test_a_source_plays_as_the_clip_that_it_replays() -> None:
    one, other = walker(), walker(source=replay("walk"))
    for hero in (one, other):
        hero.advance(0.4)
        hero.start("run")
    np.testing.assert_allclose(play(one), play(other), atol=1e-5)


def test_a_crash_names_the_action_and_nothing_else_has_changed() -> None:
    untouched, hero = walker(), walker()
    np.testing.assert_array_equal(play(untouched), play(hero))
    with pytest.raises(SourceError) as caught:
        hero.add_source("wave", replay("walk", broken=crash))
    assert str(caught.value) == (
        "the source of 'wave' raised ZeroDivisionError: division by zero; "
        "the library is as it was before"
    )
    with pytest.raises(UnknownNameError, match="no action named 'wave'; there are: walk, run"):
        hero.start("wave")
    hero.start("run")
    untouched.start("run")
    np.testing.assert_array_equal(play(untouched, 60), play(hero, 60))
    hero.add_source("wave", replay("walk"))
    assert hero.start("wave") is not None
    assert np.isfinite(play(hero)).all()


def test_a_source_that_is_asked_again_plays_what_it_gives_now() -> None:
    source = replay("walk")
    hero = walker(source=source)
    before = play(hero)

    def turn_head(given: Any) -> Any:
        positions, rotations = given
        head = source.skeleton.names.index("Head")
        turned = rotations.copy()
        turned[:, head] = multiply(from_yaw(np.full(len(turned), 0.8)), turned[:, head])
        return positions, turned

    source.broken = turn_head
    untouched = walker(source=replay("walk"))
    np.testing.assert_array_equal(play(untouched), before)
    np.testing.assert_array_equal(play(untouched), play(hero))
    hero.library.resample("walk")
    one, other = untouched.advance(1 / 60), hero.advance(1 / 60)
    head = source.skeleton.names.index("Head")
    assert not np.allclose(one.world_rotations[head], other.world_rotations[head], atol=0.1)
    others = [index for index in range(source.skeleton.count) if index != head]
    np.testing.assert_allclose(
        one.world_positions[others], other.world_positions[others], atol=1e-5
    )


def test_a_crash_when_asked_again_leaves_the_old_motion_playing() -> None:
    source = replay("walk")
    untouched, hero = walker(), walker(source=source)
    for one in (untouched, hero):
        play(one)
    for broken in (crash, nowhere):
        source.broken = broken
        with pytest.raises((SourceError, ClipError), match="'walk'"):
            hero.library.resample("walk")
    np.testing.assert_allclose(play(untouched), play(hero), atol=1e-5)


def test_what_has_no_source_or_other_supports_cannot_be_asked_again() -> None:
    library = MotionLibrary()
    source = replay("walk")
    library.add_source("walk", source)
    library.add("run", *sample("run"))
    with pytest.raises(ArgumentError) as caught:
        library.resample("run")
    assert str(caught.value) == "'run' has no source to ask again; `add_source` gives it one"
    source.supports = sample("run")[1]
    with pytest.raises(ArgumentError) as caught:
        library.resample("walk")
    assert str(caught.value).startswith("the source of 'walk' now has the supports ")
    with pytest.raises(UnknownNameError):
        library.resample("hop")


def test_every_crowd_of_a_library_hears_of_it() -> None:
    library = MotionLibrary()
    source = replay("walk")
    library.add_source("walk", source)
    one, other = Crowd(library, 2), Crowd(library, 9)
    for crowd in (one, other):
        crowd.start(0)
        crowd.advance(0.1)
    first = library.actions[0].clip
    source.broken = higher
    library.resample("walk")
    assert library.actions[0].clip is not first
    for crowd in (one, other):
        crowd.advance(0.1)
    np.testing.assert_array_equal(one.world_positions[0], other.world_positions[8])


def test_a_first_motion_that_is_refused_leaves_the_library_without_a_body() -> None:
    library = MotionLibrary()
    walk, _ = sample("walk")
    with pytest.raises(ClipError):
        library.add("walk", walk, SupportSequence.parse("R.1 D.1 L.1 D.1*"))
    with pytest.raises(ArgumentError, match="the library is empty"):
        _ = library.skeleton
    with pytest.raises(ClipError):
        library.add_locomotion("gait", [(walk, SupportSequence.parse("R.1 D.1 L.1 D.1*"))])
    with pytest.raises(ArgumentError, match="the library is empty"):
        _ = library.skeleton


def test_a_body_of_another_kind_performs_what_a_source_gives_now() -> None:
    library = MotionLibrary()
    source = replay("walk")
    library.add_source("walk", source)
    walk = sample("walk")[0].skeleton
    renamed = Skeleton(
        tuple(name.lower() for name in walk.names), walk.parents, 0.9 * walk.rest_offsets
    )
    other = library.adapted(renamed)
    before = other.actions[0].packed.keys.copy()

    def turned(given: Any) -> Any:
        positions, rotations = given
        turns = np.array(rotations)
        head = walk.names.index("Head")
        turns[:, head] = multiply(from_yaw(np.full(len(turns), 0.8)), turns[:, head])
        return positions, turns

    source.broken = turned
    library.resample("walk")
    assert not np.allclose(other.actions[0].packed.keys, before, atol=1e-3)
