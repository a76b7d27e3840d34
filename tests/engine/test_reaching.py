"""A hand that reaches, closes on an object and carries it (requirement 106)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.paper.requirements import requirement

import footfall as ff
from footfall.arrays import Floats, Positions
from footfall.errors import ArgumentError, SkeletonError

FPS = 60


def stander(action: str = "idle") -> ff.Character:
    clip, supports = ff.sample(action)
    hero = ff.Character(clip.skeleton)
    hero.add(action, clip, supports)
    hero.start(action)
    hero.advance(0.0)
    return hero


def shoulder(hero: ff.Character) -> Positions:
    arm = hero.library.anatomy.arms[1]
    assert arm is not None
    place: Positions = hero.advance(0.0).world_positions[arm.shoulder].copy()
    return place


def play(hero: ff.Character, frames: int) -> Floats:
    """Return all joints in the world, frame by frame [m]."""
    return np.array([hero.advance(1 / FPS).world_positions.copy() for _ in range(frames)])


def test_a_hand_gets_to_a_point_in_reach_and_back() -> None:
    hero, twin = stander(), stander()
    point = shoulder(hero) + np.array([0.05, -0.1, 0.4])
    hero.reach("right", point)
    shown = play(hero, 40)
    hand = hero.hand("right")
    assert (hand.task, hand.weight, hand.problem) == ("reaches", 1.0, "")
    assert hand.palm == pytest.approx(point.tolist(), abs=1e-6)
    accelerations = np.linalg.norm(np.diff(shown, 2, axis=0), axis=-1) * FPS * FPS
    assert accelerations.max() < 30.0
    hero.release("right")
    play(hero, 30)
    twin.advance(70 / FPS)
    assert hero.advance(0.0).world_positions == pytest.approx(
        twin.advance(0.0).world_positions, abs=1e-3
    )


@requirement(
    106, "It also works while using parametric models such as locomotion or grasping models."
)
def test_a_hand_closes_on_an_object_and_carries_it_while_the_body_goes_on() -> None:
    hero = stander("walk-slow")
    play(hero, 30)
    thing = shoulder(hero) + np.array([0.0, -0.25, 0.55])
    hero.reach("right", thing, grasp=True, fade=0.25)
    tasks: list[str] = []
    things: list[tuple[float, ...]] = []
    for _ in range(150):
        hero.advance(1 / FPS)
        hand = hero.hand("right")
        tasks.append(hand.task)
        things.append(hand.object)
    taken = tasks.index("holds")
    assert set(tasks[:taken]) == {"reaches"}
    assert set(tasks[taken:]) == {"holds"}
    assert np.array(things[:taken]) == pytest.approx(np.tile(thing, (taken, 1)))
    # It is carried: in the palm to the end, which has gone on with the body.
    assert np.linalg.norm(np.subtract(hero.hand("right").object, hero.hand("right").palm)) < 0.011
    assert hero.hand("right").object[2] - thing[2] > 0.5
    leaps = np.linalg.norm(np.diff(np.array(things), axis=0), axis=-1)
    assert leaps.max() * FPS < 4.0
    assert hero.hand("right").weight == 0.0
    hero.release("right")
    left = hero.hand("right").object
    play(hero, 10)
    assert hero.hand("right").object == left


@requirement(
    120,
    "We have decided to ensure secondary constraints (feet are primaries) with another part of MKM",
)
def test_the_legs_know_nothing_of_it() -> None:
    reaching, walking = stander("walk"), stander("walk")
    reaching.reach("left", [0.3, 1.4, 0.8])
    for _ in range(90):
        one, other = reaching.advance(1 / FPS), walking.advance(1 / FPS)
        legs = [leg.ankle for leg in reaching.library.anatomy.legs]
        assert one.support is other.support
        assert np.array_equal(one.world_positions[legs], other.world_positions[legs])
    assert str(reaching.schedule) == str(walking.schedule)


def test_what_is_out_of_reach_is_approached_without_a_pop_and_named() -> None:
    hero = stander()
    start = shoulder(hero)
    far = start + np.array([0.0, 0.0, 1.5])
    hero.reach("right", start + np.array([0.0, -0.2, 0.35]))
    play(hero, 60)
    shown: list[Positions] = []
    for frame in range(120):
        share = min(frame / 60, 1.0)
        hero.reach("right", (1.0 - share) * (start + np.array([0.0, -0.2, 0.35])) + share * far)
        shown.append(hero.advance(1 / FPS).world_positions.copy())
    accelerations = np.linalg.norm(np.diff(np.array(shown), 2, axis=0), axis=-1) * FPS * FPS
    assert accelerations.max() < 60.0
    hand = hero.hand("right")
    assert hand.missing > 0.5
    assert hand.problem == (
        f"({far[0]:.2f}, {far[1]:.2f}, {far[2]:.2f}) is {hand.missing:.2f} m out of reach"
    )
    assert hero.hand("left").problem == ""


def test_another_point_is_gone_to_smoothly() -> None:
    hero = stander()
    start = shoulder(hero)
    hero.reach("right", start + np.array([0.1, -0.1, 0.3]))
    play(hero, 60)
    other = start + np.array([-0.1, 0.2, 0.35])
    hero.reach("right", other)
    shown = play(hero, 60)
    speeds = np.linalg.norm(np.diff(shown, axis=0), axis=-1) * FPS
    assert speeds.max() < 2.5
    assert hero.hand("right").palm == pytest.approx(
        (start + np.array([-0.1, 0.2, 0.35])).tolist(), abs=2e-3
    )


def test_every_character_of_a_crowd_has_hands_of_its_own() -> None:
    clip, supports = ff.sample("idle")
    library = ff.MotionLibrary()
    library.add("idle", clip, supports)
    crowd = ff.Crowd(library, 2)
    crowd.place([[0.0, 0.0], [3.0, 0.0]])
    crowd.start(0)
    crowd.advance(0.1)
    crowd.reach("left", [3.2, 1.2, 0.4], [1])
    crowd.advance(1.0)
    assert crowd.hand("left", 0).task == "free"
    assert crowd.hand("left", 1).palm == pytest.approx((3.2, 1.2, 0.4), abs=1e-3)


def test_what_cannot_be_is_told() -> None:
    hero = stander()
    for words, message in (
        ({"hand": "third", "point": [0, 1, 0]}, "no hand 'third'; there are left and right"),
        (
            {"hand": "left", "point": [0.0, float("nan"), 0.0]},
            "the point of a reach is [0.0, nan, 0.0]; it must be finite",
        ),
        (
            {"hand": "left", "point": [0, 1, 0], "fade": 0.0},
            "the fade of a reach is 0.0 s; it must be finite and > 0",
        ),
    ):
        with pytest.raises(ArgumentError) as caught:
            hero.reach(**words)  # pyright: ignore[reportArgumentType]
        assert str(caught.value) == message


def test_a_body_without_arms_cannot_reach(monkeypatch: pytest.MonkeyPatch) -> None:
    hero = stander()
    bare = replace(hero.library.anatomy, arms=(None, None))
    monkeypatch.setattr(hero.library, "_anatomy", bare)
    with pytest.raises(SkeletonError) as caught:
        hero.reach("left", [0.0, 1.0, 0.3])
    assert str(caught.value) == (
        "the skeleton has no left arm that is known by its names; it cannot reach"
    )
