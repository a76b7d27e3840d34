"""Priorities that change while motions play: weights come to them without a jerk."""

from __future__ import annotations

import itertools
from functools import lru_cache

import numpy as np
import pytest

import footfall as ff
from footfall.arrays import Floats
from footfall.errors import ArgumentError
from footfall.skeleton import BodyPart

FPS = 120
PAIR = ("walk", "side-step")

Change = tuple[int, str, float | dict[str, float]]


def performer() -> ff.Character:
    clips = [ff.sample(name) for name in PAIR]
    hero = ff.Character(clips[0][0].skeleton)
    for name, (clip, supports) in zip(PAIR, clips, strict=True):
        hero.add(name, clip, supports)
    return hero


def played(changes: list[Change], frames: int = 300) -> tuple[float, Floats]:
    """Return the greatest acceleration of any joint [m/s²] and the walk's weights."""
    hero = performer()
    for name in PAIR:
        hero.start(name)
    positions: list[Floats] = []
    weights: list[tuple[float, ...]] = []
    for frame in range(frames):
        for at, name, priority in changes:
            if at == frame:
                hero.set_priority(name, priority)
        positions.append(hero.advance(1.0 / FPS).world_positions.copy())
        weights.append(hero.state("walk").weights)
    accelerations = np.diff(np.array(positions), 2, axis=0) * FPS * FPS
    return float(np.linalg.norm(accelerations, axis=-1).max()), np.array(weights)


@lru_cache(maxsize=1)
def bound() -> float:
    """Return one and a half times what walking mainly, or side-stepping mainly, takes."""
    return 1.5 * max(played([(0, name, 12.0)])[0] for name in PAIR)


@pytest.mark.parametrize(
    "changes",
    [
        [(60, "walk", 6.0), (120, "walk", 12.0)],
        [(60, "walk", 12.0), (70, "walk", 0.1), (85, "walk", 12.0)],
        [(60, "walk", 12.0), (66, "side-step", 12.0)],
        [(60, "walk", {"legs": 1.0, "trunk": 1.0}), (150, "walk", 1.0)],
        [(60, "walk", {"legs": 1.0}), (75, "walk", 1.0), (90, "walk", {"legs": 1.0})],
        [(60 + frame, "walk", 1.0 + frame / 10.0) for frame in range(110)],
    ],
)
def test_accelerations_stay_those_of_the_motions(changes: list[Change]) -> None:
    acceleration, _ = played(changes)
    assert acceleration < bound()


def test_weights_arrive_where_they_would_be_from_the_beginning() -> None:
    _, weights = played([(60, "walk", 12.0)])
    assert np.allclose(weights[59], 0.5)
    arms = weights[:, BodyPart.LEFT_ARM]
    assert (np.diff(arms) >= -1e-12).all()
    assert arms[61] < 0.51
    # The action fades in within 0.3 s; on the legs it may take twice that.
    assert arms[60 + round(0.3 * FPS)] == pytest.approx(12.0 / 13.0, abs=1e-7)
    legs = weights[:, BodyPart.LEGS]
    assert legs[60 + round(0.6 * FPS)] == pytest.approx(12.0 / 13.0, abs=1e-7)


def test_weights_of_the_legs_rest_while_both_feet_carry() -> None:
    hero = performer()
    for name in PAIR:
        hero.start(name)
    hero.advance(0.5)
    while hero.advance(1.0 / FPS).support is not ff.Support.DOUBLE:
        pass
    hero.set_priority("walk", 12.0)
    before = hero.state("walk").weights
    hero.advance(1.0 / FPS)
    after = hero.state("walk").weights
    assert after[BodyPart.LEGS] == pytest.approx(before[BodyPart.LEGS], abs=1e-12)
    assert after[BodyPart.LEFT_ARM] > before[BodyPart.LEFT_ARM]


def test_a_body_part_that_nothing_else_moves_is_left_to_the_neutral_motion_gradually() -> None:
    hero = performer()
    hero.start("walk")
    hero.advance(0.5)
    hero.set_priority("walk", {"legs": 1.0})
    arms: list[float] = []
    for _ in range(60):
        hero.advance(1.0 / FPS)
        arms.append(hero.state("walk").weights[BodyPart.LEFT_ARM])
    assert arms[-1] == 0.0
    assert max(abs(one - other) for one, other in itertools.pairwise([1.0, *arms])) < 0.06


def test_a_change_with_no_time_happens_at_once_and_before_the_first_frame_it_is_there() -> None:
    hero = performer()
    for name in PAIR:
        hero.start(name)
    hero.set_priority("walk", 3.0)
    hero.advance(0.0)
    assert hero.state("walk").weights[BodyPart.LEGS] == pytest.approx(0.75)
    hero.advance(0.5)
    hero.set_priority("walk", 1.0, fade=0.0)
    hero.advance(0.0)
    assert hero.state("walk").weights[BodyPart.LEGS] == pytest.approx(0.5)


def test_how_time_is_cut_changes_nothing() -> None:
    ends: list[tuple[float, ...]] = []
    for pieces in (1, 4):
        hero = performer()
        hero.start("walk")
        hero.advance(0.4)
        hero.start("side-step")
        hero.advance(0.9)
        hero.set_priority("walk", 5.0)
        for _ in range(pieces):
            hero.advance(0.12 / pieces)
        ends.append(hero.state("walk").weights)
    assert ends[0][1:] == pytest.approx(ends[1][1:], abs=1e-9)


def test_a_time_that_is_none_is_refused() -> None:
    hero = performer()
    hero.start("walk")
    with pytest.raises(ArgumentError, match=r"^fade is -0\.1 s; it must be finite and >= 0$"):
        hero.set_priority("walk", 2.0, fade=-0.1)
