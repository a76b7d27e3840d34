"""Figure 2: t1 start command, t2 complete activation, t3 stop command, t4 complete deactivation."""

from __future__ import annotations

import numpy as np
import pytest
from tests.paper.requirements import requirement

import footfall as ff
from footfall.arrays import Floats
from footfall.timing import advance_progress, level, normalize_weights

FPS = 60
FADE_IN, FADE_OUT = 0.5, 0.25
T1, T3 = 1.0, 2.0
T2, T4 = T1 + FADE_IN, T3 + FADE_OUT


def levels(carried: bool = True) -> Floats:
    """Return the level at each frame of three seconds, on one foot all along or never."""
    rising, falling = 0.0, 0.0
    result: list[float] = []
    for frame in range(3 * FPS):
        now = frame / FPS
        result.append(level(rising) - level(falling))
        if now >= T1:
            rising = advance_progress(rising, now - T1, FADE_IN, 1 / FPS, carried)
        if now >= T3:
            falling = advance_progress(falling, now - T3, FADE_OUT, 1 / FPS, carried)
    return np.array(result)


def frame_at(seconds: float) -> int:
    return round(seconds * FPS)


@requirement(
    33,
    "t1 is the starting time of the action and t3 its ending time. t2 (resp. t4) is the complete "
    "activation (resp. deactivation) of the action.",
)
def test_the_level_is_zero_up_to_t1_and_from_t4_on() -> None:
    assert not levels()[: frame_at(T1) + 1].any()
    assert not levels()[frame_at(T4) :].any()


def test_the_level_is_one_from_t2_to_t3() -> None:
    assert (levels()[frame_at(T2) : frame_at(T3) + 1] == 1.0).all()


def test_between_them_it_rises_and_falls_without_a_corner() -> None:
    slopes = np.diff(levels()) * FPS
    assert (slopes[frame_at(T1) : frame_at(T2)] > 0.0).all()
    assert (slopes[frame_at(T3) : frame_at(T4)] < 0.0).all()
    # A smoothstep's curvature is at most 6 over the square of its length.
    assert np.abs(np.diff(slopes) * FPS).max() <= 6.0 / FADE_OUT**2


def test_where_the_weights_may_not_move_t2_and_t4_are_put_off_by_the_time_asked() -> None:
    waiting = levels(carried=False)
    assert waiting[: frame_at(T2) + 1].max() < 1e-12
    assert waiting[frame_at(T2 + FADE_IN) : frame_at(T3 + FADE_OUT) + 1].min() > 1.0 - 1e-12
    assert not waiting[frame_at(T4 + FADE_OUT) :].any()


@requirement(34, "The weights associated to motions are then computed automatically")
@pytest.mark.parametrize("seconds", [0.5, T1 + 0.2, 1.75, T3 + 0.1, 2.5])
def test_a_lone_action_takes_its_level_and_the_neutral_motion_the_rest(seconds: float) -> None:
    now = levels()[frame_at(seconds)]
    out = np.empty((2, 1))
    normalize_weights(np.array([[5.0]]), np.array([now]), out)
    np.testing.assert_allclose(out[:, 0], [now, 1.0 - now], rtol=0, atol=1e-15)


@requirement(
    35,
    "The duration used to activate or deactivate the motion is parameterized for each action as "
    "well as the priorities.",
)
def test_each_action_has_a_fade_in_and_a_fade_out_of_its_own() -> None:
    punch, supports = ff.sample("punch")
    hero = ff.Character(punch.skeleton)
    hero.add("walk", *ff.sample("walk"))
    arms = {"arms": 1.0}
    hero.add("slow", punch, supports, priority=arms, fade_in=0.5, fade_out=0.1)
    hero.add("quick", punch, supports, priority=arms, fade_in=0.1, fade_out=0.5)
    hero.start("walk")
    hero.advance(0.2)
    for name, fade_in, fade_out in (("slow", 0.5, 0.1), ("quick", 0.1, 0.5)):
        hero.start(name)
        hero.advance(0.95 * fade_in)
        short = max(hero.state(name).weights)
        hero.advance(0.1 * fade_in)
        full = max(hero.state(name).weights)
        assert short < full
        hero.stop(name)
        hero.advance(0.9 * fade_out)
        assert hero.is_active(name)
        hero.advance(0.2 * fade_out)
        assert not hero.is_active(name)
