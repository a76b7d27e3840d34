from __future__ import annotations

import pytest

from footfall.errors import UnknownNameError
from footfall.samples import quadruped_supports
from footfall.samples.quadruped import QUADRUPED_GAITS, LegGait


def symbols(name: str) -> list[str]:
    return [phase.support.symbol for phase in quadruped_supports(name).phases]


def test_a_walking_dog_stands_on_three_legs_and_two_in_turn_and_never_flies() -> None:
    assert symbols("walk") == ["D+r", "L+r", "L+lr", "L+l", "D+l", "R+l", "R+lr", "R+r"]


def test_a_trotting_dog_stands_on_diagonals_and_flies_between_them() -> None:
    assert symbols("trot") == ["L+r", "-", "R+l", "-"]


def test_a_galloping_dog_flies_gathered_and_extended() -> None:
    assert symbols("gallop") == ["L", "D", "R", "-", "+r", "+lr", "+l", "-"]


@pytest.mark.parametrize("name", QUADRUPED_GAITS)
def test_each_leg_carries_for_its_duty_and_a_stride_lasts_as_told(name: str) -> None:
    gait, supports = QUADRUPED_GAITS[name], quadruped_supports(name)
    assert supports.cyclic
    assert supports.duration == pytest.approx(gait.duration)
    for limb, duty in enumerate(gait.duties):
        carried = sum(p.duration for p in supports.phases if limb in p.support.limbs)
        assert carried == pytest.approx(duty * gait.duration)


@pytest.mark.parametrize(("name", "apart", "spread"), [("walk", 0.31, 0.02), ("trot", 0.02, 0.03)])
def test_diagonal_legs_are_as_far_apart_as_in_dogs(name: str, apart: float, spread: float) -> None:
    left_hind, right_hind, left_front, right_front = QUADRUPED_GAITS[name].strikes
    for hind, front in ((left_hind, right_front), (right_hind, left_front)):
        assert (hind - front) % 1.0 == pytest.approx(apart, abs=spread)


def test_a_walking_dog_sets_its_feet_in_the_lateral_sequence() -> None:
    strikes = QUADRUPED_GAITS["walk"].strikes
    # Left hind, left front, right hind, right front.
    assert sorted(range(4), key=lambda limb: strikes[limb]) == [0, 2, 1, 3]


def test_a_galloping_dog_sets_its_feet_in_the_rotary_order() -> None:
    strikes = QUADRUPED_GAITS["gallop"].strikes
    # The hind legs from one side to the other, the front legs back: round the body.
    assert sorted(range(4), key=lambda limb: strikes[limb]) == [0, 1, 3, 2]


def test_duty_factors_and_strides_fall_from_walk_to_gallop() -> None:
    gaits = [QUADRUPED_GAITS[name] for name in ("walk", "trot", "gallop")]
    duties = [sum(gait.duties) for gait in gaits]
    assert duties == sorted(duties, reverse=True)
    assert duties[0] > 2.0 > duties[1]
    assert [gait.duration for gait in gaits] == sorted((g.duration for g in gaits), reverse=True)


def test_a_phase_that_goes_on_over_the_strike_of_the_first_leg_stays_one() -> None:
    gait = LegGait(1.0, (0.0, 0.5), (0.6, 0.6))
    assert str(gait.supports()) == "D.1 L.4 D.1 R.4*"


def test_another_gait_is_told_to_be_unknown() -> None:
    with pytest.raises(UnknownNameError) as caught:
        quadruped_supports("pace")
    assert str(caught.value) == "no gait of four legs named 'pace'; there are: walk, trot, gallop"
