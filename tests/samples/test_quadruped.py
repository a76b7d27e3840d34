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
def test_each_leg_carries_for_its_duty_and_a_stride_lasts_as_published(name: str) -> None:
    gait, supports = QUADRUPED_GAITS[name], quadruped_supports(name)
    assert supports.cyclic
    assert supports.duration == pytest.approx(gait.duration)
    for limb, duty in enumerate(gait.duties):
        carried = sum(p.duration for p in supports.phases if limb in p.support.limbs)
        assert carried == pytest.approx(duty * gait.duration)


def test_a_phase_that_goes_on_over_the_strike_of_the_first_leg_stays_one() -> None:
    gait = LegGait(1.0, (0.0, 0.5), (0.6, 0.6))
    assert str(gait.supports()) == "D.1 L.4 D.1 R.4*"


def test_another_gait_is_told_to_be_unknown() -> None:
    with pytest.raises(UnknownNameError) as caught:
        quadruped_supports("pace")
    assert str(caught.value) == "no gait of four legs named 'pace'; there are: walk, trot, gallop"
