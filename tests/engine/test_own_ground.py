"""Ground that a program makes itself: walked on like any other, and its errors are told."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import footfall as ff
from footfall.adaptation import AnyGround, HeightField, Plane, Platform, ground_heights
from footfall.arrays import Floats
from footfall.errors import ArgumentError, GroundError


class Hill(ff.Ground):
    """A hill that a formula makes."""

    def heights(self, places: Floats, time: float) -> Floats:
        del time
        return 0.12 * np.sin(1.7 * places[:, 0] + 0.4) * np.cos(2.1 * places[:, 1])


class Raft(ff.Ground):
    """A level raft that drifts, turns and rises."""

    def heights(self, places: Floats, time: float) -> Floats:
        del time
        return np.zeros(len(places))

    def frame(self, time: float) -> tuple[float, float, float, float]:
        return 0.5 * time, 0.02 * time, 0.0, 0.3 * time


class Swell(ff.Ground):
    """A slope that swings."""

    def heights(self, places: Floats, time: float) -> Floats:
        return 0.25 * math.sin(1.5 * time) * places[:, 0]


class Trap(ff.Ground):
    """Ground that gives way after a second."""

    def __init__(self, answer: Any = None) -> None:
        self.answer = answer

    def heights(self, places: Floats, time: float) -> Floats:
        if time < 1.0:
            return np.zeros(len(places))
        if self.answer is None:
            raise RuntimeError("the ice\nbreaks")
        return self.answer(places)


class Stones:
    """Alike, and derived from nothing."""

    def heights(self, places: Floats, time: float) -> Floats:
        del time
        return np.where(np.sin(3.0 * places[:, 1]) > 0.5, 0.05, 0.0)

    def frame(self, time: float) -> tuple[float, float, float, float]:
        del time
        return 0.0, 0.0, 0.0, 0.0


def walker(ground: AnyGround) -> ff.Character:
    walk, supports = ff.sample("walk")
    hero = ff.Character(walk.skeleton, ground=ground)
    hero.add("walk", walk, supports)
    hero.start("walk")
    return hero


def positions(ground: AnyGround, frames: int = 180, dt: float = 1 / 60) -> Floats:
    hero = walker(ground)
    return np.array([hero.advance(dt if i else 0.0).world_positions.copy() for i in range(frames)])


def test_a_formula_is_walked_on_like_the_field_of_its_heights() -> None:
    x, z = np.meshgrid(np.arange(-3.0, 3.001, 0.05), np.arange(-3.0, 6.001, 0.05))
    places = np.stack([x, z], axis=-1).reshape(-1, 2)
    field = HeightField(Hill().heights(places, 0.0).reshape(x.shape), 0.05, (0.0, 1.5))
    apart = np.linalg.norm(positions(Hill()) - positions(field), axis=-1)
    assert apart.max() < 0.01


def test_its_frame_carries_who_stands_on_it_as_a_platform_does() -> None:
    platform = Platform((0, 0, 0), (90, 90), way=(0.5, 0.02, 0.0), turning=0.3)
    apart = np.linalg.norm(positions(Raft()) - positions(platform), axis=-1)
    assert apart.max() < 0.002


def test_a_slope_that_swings_is_the_platform_that_tilts() -> None:
    platform = Platform((0, 0, 0), (90, 90), period=2.0 * math.pi / 1.5, tilt=(0.25, 0.0))
    apart = np.linalg.norm(positions(Swell()) - positions(platform), axis=-1)
    assert apart.max() < 0.02


def test_a_class_that_is_alike_will_do() -> None:
    shown = positions(Stones())
    assert np.isfinite(shown).all()
    assert ground_heights(Stones(), np.array([[0.0, 9.0, 0.5]]), np.zeros(1)) == pytest.approx(0.05)


def test_heights_are_asked_for_where_the_frame_is() -> None:
    class Moved(ff.Ground):
        def heights(self, places: Floats, time: float) -> Floats:
            del time
            return places[:, 0] + 10.0 * places[:, 1]

        def frame(self, time: float) -> tuple[float, float, float, float]:
            del time
            return 1.0, 0.5, 2.0, 0.5 * math.pi

    # Its z leads to the world's x, its x to the world's -z.
    found = ground_heights(Moved(), np.array([[1.3, 0.0, 1.8]]), np.zeros(1))
    assert found == pytest.approx(0.5 + 0.2 + 10.0 * 0.3)


def test_a_crowd_that_is_scattered_stands_on_it_too() -> None:
    walk, supports = ff.sample("walk")
    library = ff.MotionLibrary(skeleton=walk.skeleton)
    library.add("walk", walk, supports)
    crowd = ff.Crowd(library, 3, ground=Hill())
    crowd.place([(0.0, 0.0), (30.0, 0.0), (0.0, 40.0)])
    crowd.start(0)
    for _ in range(60):
        crowd.advance(1 / 60)
    ground = crowd.characters["foot_ground"][:, 0, 0]
    points = crowd.characters["world_points"][:, 0, 0] + crowd.characters["foot_offset"][:, 0]
    expected = ground_heights(Hill(), points, np.zeros(3))
    assert ground == pytest.approx(expected, abs=0.01)
    crowd.place([(0.0, 0.0), (300.0, 0.0), (0.0, 400.0)])
    with pytest.raises(GroundError) as caught:
        crowd.advance(1 / 60)
    assert str(caught.value) == (
        "characters on ground Hill are scattered over 304 × 404 m; it is asked within 200 × 200 m "
        "at most (under 3 characters, 'walk')"
    )


@pytest.mark.parametrize("dt", [1 / 60, 0.4])
def test_an_error_names_the_ground_the_action_and_the_time_and_changes_nothing(dt: float) -> None:
    hero = walker(Trap())
    while hero.crowd.clock_of(0) + dt < 1.0 - 1e-9:
        hero.advance(dt)
    before = hero.crowd.snapshot()
    with pytest.raises(GroundError) as caught:
        hero.advance(dt)
    time = float(before["clock"][0])
    assert str(caught.value).startswith("ground Trap failed at 1.0")
    assert str(caught.value).endswith(
        " s: RuntimeError: the ice breaks (under character 0, 'walk')"
    )
    assert isinstance(caught.value.__cause__, RuntimeError)
    after = hero.crowd.snapshot()
    for name, array in before.items():
        assert np.array_equal(array, after[name]), name
    # And it goes on as soon as there is ground again.
    hero.crowd.ground = Plane()
    assert np.isfinite(hero.advance(dt).world_positions).all()
    assert hero.crowd.clock_of(0) == pytest.approx(time + dt)


def nowhere(places: Floats) -> Floats:
    return np.full(len(places), math.nan)


def too_few(places: Floats) -> Floats:
    return places[0]


def no_number(places: Floats) -> str:
    return f"{len(places)} of them"


@pytest.mark.parametrize(
    ("answer", "told"),
    [
        (nowhere, "the height of ground Trap at x -1."),
        (too_few, "ground Trap has heights of shape (2,) at 1.0"),
        (no_number, "ground Trap failed at 1.0"),
    ],
)
def test_an_answer_that_is_no_height_a_place_is_refused(answer: Any, told: str) -> None:
    hero = walker(Trap(answer))
    while hero.crowd.clock_of(0) + 1 / 60 < 1.0 - 1e-9:
        hero.advance(1 / 60)
    with pytest.raises(GroundError) as caught:
        hero.advance(1 / 60)
    assert str(caught.value).startswith(told)
    assert str(caught.value).endswith("(under character 0, 'walk')")


def test_a_frame_that_is_none_is_refused() -> None:
    class Adrift(Hill):
        def frame(self, time: float) -> Any:
            del time
            return (0.0, 0.0)

    with pytest.raises(GroundError) as caught:
        walker(Adrift()).advance(0.0)
    assert str(caught.value) == (
        "the frame of ground Adrift at 0.000 s is of shape (2,); it must be x, y, z and heading "
        "(under character 0, 'walk')"
    )


def test_ground_that_fails_when_it_is_exchanged_leaves_the_old_one() -> None:
    hero = walker(Plane(0.3))
    for _ in range(80):
        hero.advance(1 / 60)
    with pytest.raises(GroundError):
        hero.crowd.ground = Trap()
    assert hero.crowd.ground == Plane(0.3)
    hero.advance(1 / 60)


def test_what_is_no_ground_is_refused() -> None:
    with pytest.raises(ArgumentError) as caught:
        walker(3.0)  # pyright: ignore[reportArgumentType]
    assert str(caught.value) == (
        "a ground of type float; give a Plane or another one of footfall.adaptation, or an object "
        "with heights(places, time)"
    )
