"""Several cycles laid over each other by speed and turn."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.actions import GaitCycle, Locomotion
from footfall.actions.cycle_poses import root_way, root_ways, turned_steps
from footfall.engine.packing import pack_clip
from footfall.errors import ArgumentError
from footfall.samples import sample, sample_skeleton
from footfall.skeleton import find_anatomy
from footfall.skeleton.rig import rig_of
from footfall.support import Support, SupportSequence

ANATOMY = find_anatomy(sample_skeleton())
RIG = rig_of(sample_skeleton(), ANATOMY)
NAMES = ("walk-slow", "walk", "walk-fast", "run")


def cycle(name: str, turning: float = 0.0) -> GaitCycle:
    """Return a sample's cycle, its way bent by so many radians a cycle."""
    clip, supports = sample(name)
    packed = pack_clip(clip, ANATOMY, supports)
    roots = packed.roots.copy()
    roots[:, 2] += turning * np.linspace(0.0, 1.0, len(roots))
    return GaitCycle.of(name, packed.keys, roots, clip.fps, supports)


GAITS = Locomotion([cycle(name) for name in NAMES], RIG.leg_sides, RIG.leg_length)
LEAST, MOST = float(GAITS.speeds.min()), float(GAITS.speeds.max())


def speed_of(roots: np.ndarray, supports: SupportSequence) -> float:
    return float(roots[-1, 1]) * RIG.leg_length / supports.duration


@given(st.floats(LEAST, MOST))
@settings(max_examples=60, deadline=None)
def test_a_mix_goes_as_fast_as_asked_and_its_cycle_closes(speed: float) -> None:
    mix = GAITS.mix(speed, 0.0)
    assert speed_of(mix.roots, mix.supports) == pytest.approx(speed, abs=1e-6)
    assert mix.shares.sum() == pytest.approx(1.0)
    assert (mix.shares > 0.0).sum() <= 2
    first, last = mix.keys[0].reshape(-1), mix.keys[-1].reshape(-1)
    count = len(first) - 7
    dots = (first[:count].reshape(-1, 4) * last[:count].reshape(-1, 4)).sum(axis=-1)
    assert np.abs(np.abs(dots) - 1.0).max() < 1e-4
    assert np.abs(first[count:] - last[count:]).max() < 1e-3


@pytest.mark.parametrize("index", range(len(NAMES)))
def test_a_clip_is_whole_at_its_own_speed(index: int) -> None:
    mix = GAITS.mix(float(GAITS.speeds[index]), 0.0)
    own = GAITS.cycles[index]
    assert mix.shares[index] == pytest.approx(1.0)
    assert [phase.support for phase in mix.supports.phases] == list(own.supports)
    durations = [phase.duration for phase in mix.supports.phases]
    assert durations == pytest.approx(np.diff(own.starts).tolist(), abs=1e-6)


def test_a_walk_becomes_a_run_when_its_double_support_is_used_up() -> None:
    speeds = np.linspace(LEAST, MOST, 60)
    kinds = ["".join(p.support.symbol for p in GAITS.mix(v, 0.0).supports.phases) for v in speeds]
    turning = kinds.index("R-L-")
    assert set(kinds[:turning]) == {"RDLD"}
    assert set(kinds[turning:]) == {"R-L-"}


def test_nothing_leaps_where_a_walk_becomes_a_run() -> None:
    speeds = np.linspace(1.9, 3.1, 241)
    keys = np.array([GAITS.mix(float(speed), 0.0).keys for speed in speeds])
    steps = np.abs(np.diff(keys[..., -6:], axis=0)).max(axis=(1, 2))
    assert steps.max() < 3.0 * np.median(steps)


def test_a_phase_that_is_played_keeps_its_support() -> None:
    kept = {1: Support.DOUBLE}
    kinds = [phase.support for phase in GAITS.mix(3.2, 0.0, kept).supports.phases]
    assert kinds == [Support.RIGHT, Support.DOUBLE, Support.LEFT, Support.FLIGHT]


def test_the_feet_of_a_mix_stand_where_they_stand() -> None:
    for speed in (1.0, 1.6, 2.0, 2.4, 2.8):
        mix = GAITS.mix(speed, 0.0)
        joints = (mix.keys.shape[1] - 15) // 4
        times = np.linspace(0.0, mix.supports.duration, len(mix.keys))
        supports = mix.supports.supports_at(times)
        for side, alone in enumerate((Support.LEFT, Support.RIGHT)):
            ankle = mix.keys[:, 4 * joints + 9 + 3 * side :][:, [0, 2]] + mix.roots[:, :2]
            stands = np.flatnonzero(supports == int(alone))
            runs = np.split(stands, np.flatnonzero(np.diff(stands) > 1) + 1)
            longest = max(runs, key=len)
            middle = longest[len(longest) // 4 : -max(len(longest) // 4, 1)]
            # The ankle itself rolls over the foot by some centimeters.
            assert np.ptp(ankle[middle], axis=0).max() * RIG.leg_length < 0.08


CURVES = ("walk", "walk-fast", "run", "walk-left", "walk-right", "run-left", "run-right")
TURNING = Locomotion([cycle(name) for name in CURVES], RIG.leg_sides, RIG.leg_length)


def turn_of(roots: np.ndarray, supports: SupportSequence) -> float:
    return float(roots[-1, 2]) / supports.duration


@pytest.mark.parametrize("speed", np.linspace(1.29, 3.22, 8))
def test_a_mix_turns_as_asked_wherever_the_clips_reach(speed: float) -> None:
    for turn in np.linspace(-0.64, 0.64, 9):
        mix = TURNING.mix(speed, float(turn))
        assert turn_of(mix.roots, mix.supports) == pytest.approx(turn, abs=0.003)
        forward = float(root_ways(mix.roots)[:, 1].sum()) * RIG.leg_length
        assert forward / mix.supports.duration == pytest.approx(speed, abs=1e-6)


def test_shares_never_leap_and_far_clips_have_none() -> None:
    turns = np.linspace(-0.65, 0.65, 400)
    shares = np.array([TURNING.shares(2.4, float(turn)) for turn in turns])
    assert np.abs(np.diff(shares, axis=0)).max() < 0.02
    left, right = CURVES.index("walk-left"), CURVES.index("walk-right")
    assert (shares[turns > 0.4, right] == 0.0).all()
    assert (shares[turns < -0.4, left] == 0.0).all()
    np.testing.assert_allclose(shares[:, left], shares[::-1, right], atol=2e-3)


def test_beyond_the_clips_the_nearest_they_can_do_is_done() -> None:
    # Nothing turns as slowly as the slow walk goes: the box of speeds and turns has empty corners.
    names = ("walk-slow", "walk", "walk-left")
    gaits = Locomotion([cycle(name) for name in names], RIG.leg_sides, RIG.leg_length)
    mix = gaits.mix(0.75, 0.6)
    assert np.isfinite(mix.roots).all()
    assert mix.shares[1] == 0.0
    assert 0.2 < turn_of(mix.roots, mix.supports) < 0.6


def test_the_foot_that_carries_stays_where_a_turn_is_made_up_for() -> None:
    steps, pivots = (
        np.array([[0.0, 0.02, 0.0]] * 4),
        np.array([[0.1, 0.3 - 0.02 * i] for i in range(4)]),
    )
    roots = root_way(turned_steps(steps, pivots, 0.2))
    assert roots[-1, 2] == pytest.approx(0.2)
    cosine, sine = np.cos(roots[:4, 2]), np.sin(roots[:4, 2])
    x = roots[:4, 0] + cosine * pivots[:, 0] + sine * pivots[:, 1]
    z = roots[:4, 1] + cosine * pivots[:, 1] - sine * pivots[:, 0]
    assert np.ptp(x) < 1e-12
    assert np.ptp(z) < 1e-12


def test_turns_are_mixed_like_speeds() -> None:
    straight, left, right = (cycle("walk", turn) for turn in (0.0, 0.6, -0.6))
    gaits = Locomotion([straight, left, right, cycle("run")], RIG.leg_sides, RIG.leg_length)
    most = float(gaits.turns.max())
    mix = gaits.mix(float(gaits.speeds[0]), 0.5 * most)
    assert mix.shares[:2] == pytest.approx([0.5, 0.5], abs=0.05)
    assert mix.roots[-1, 2] / mix.supports.duration == pytest.approx(0.5 * most, abs=0.05)
    assert gaits.shares(float(gaits.speeds[3]), 0.0)[3] == pytest.approx(1.0)


def test_what_the_clips_do_not_reach_is_refused() -> None:
    with pytest.raises(ArgumentError) as caught:
        GAITS.checked(9.0, None)
    assert str(caught.value) == "speed is 9.0 m/s; the clips go from 0.75 to 3.30 m/s"
    with pytest.raises(ArgumentError) as caught:
        GAITS.checked(None, float("nan"))
    assert "turn is nan rad/s; the clips go from" in str(caught.value)


def test_clips_that_step_differently_are_refused() -> None:
    with pytest.raises(ArgumentError) as caught:
        Locomotion([cycle("walk"), cycle("hop-left")], RIG.leg_sides, RIG.leg_length)
    assert str(caught.value) == (
        "hop-left steps L -, walk R D L D; the clips of a locomotion must step on the same feet "
        "in the same order"
    )
    with pytest.raises(ArgumentError) as caught:
        cycle("idle")
    assert str(caught.value) == (
        "idle stands on D4*; a locomotion is made of steps, on one foot and then on the other"
    )
    with pytest.raises(ArgumentError) as caught:
        cycle("kick")
    assert str(caught.value) == "kick is not cyclic; a locomotion is made of cycles"
    with pytest.raises(ArgumentError) as caught:
        Locomotion([cycle("walk"), cycle("walk")], RIG.leg_sides, RIG.leg_length)
    assert str(caught.value) == (
        "walk and walk both go at 1.31 m/s and turn by -0.00 rad/s; the clips of a locomotion "
        "must differ in one of them"
    )
