from __future__ import annotations

import math

import numpy as np
import pytest

from footfall.arrays import Positions
from footfall.report import Pops, joint_pops

FIGURES = (
    "speed_p999",
    "speed_max",
    "acceleration_p999",
    "acceleration_max",
    "root_acceleration_p99",
)


def circle(frames: int, radius: float, pace: float) -> Positions:
    """Return one joint on a circle at `pace` [rad/s], shape (frames, 1, 3)."""
    angle = pace * np.arange(frames) / 60.0
    way = np.stack([radius * np.cos(angle), np.zeros(frames), radius * np.sin(angle)], axis=-1)
    return way[:, np.newaxis]


def measured(joints: Positions, rate: float = 1.0) -> Pops:
    pops = joint_pops(joints, np.full(len(joints), rate))
    assert pops is not None
    return pops


def test_a_joint_on_a_circle_has_its_speed_and_its_acceleration() -> None:
    pops = measured(circle(600, 0.5, 2.0))
    chord = 2.0 * math.sin(1.0 / 60.0)
    assert pops.speed_p999 == pytest.approx(0.5 * chord * 60.0)
    assert pops.speed_max == pytest.approx(1.0, rel=1e-3)
    assert pops.acceleration_max == pytest.approx(2.0, rel=1e-3)
    assert pops.root_acceleration_p99 == pytest.approx(2.0, rel=1e-3)


@pytest.mark.parametrize("rate", [0.5, 2.0])
def test_a_clip_played_faster_is_not_livelier(rate: float) -> None:
    own, played = measured(circle(600, 0.5, 2.0)), measured(circle(600, 0.5, 2.0 * rate), rate)
    for figure in FIGURES:
        assert getattr(played, figure) == pytest.approx(getattr(own, figure), rel=3e-3)


def test_a_clip_that_hardly_plays_counts_as_a_tenth() -> None:
    joints = circle(600, 0.5, 0.2)
    assert measured(joints, 0.0) == measured(joints, 0.1)


def test_a_jump_of_one_joint_shows_in_the_greatest_figures_only() -> None:
    joints = np.zeros((1000, 20, 3))
    joints[500:, 7, 0] = 0.1
    pops = measured(joints)
    assert pops.speed_max == pytest.approx(6.0)
    assert pops.acceleration_max == pytest.approx(360.0)
    assert (pops.speed_p999, pops.root_acceleration_p99) == (0.0, 0.0)


def test_only_the_pelvis_counts_for_the_root() -> None:
    joints = np.zeros((100, 2, 3))
    joints[50, 1] = 1.0
    assert measured(joints).root_acceleration_p99 == 0.0
    assert measured(joints[:, ::-1]).root_acceleration_p99 > 0.0


def test_the_figures_stand_as_ratios_to_those_of_the_liveliest_clip() -> None:
    clips = Pops.greatest([Pops(1.0, 2.0, 3.0, 4.0, 5.0), Pops(2.0, 1.0, 4.0, 3.0, 1.0)])
    assert clips == Pops(2.0, 2.0, 4.0, 4.0, 5.0)
    assert Pops(3.0, 3.0, 4.0, 8.0, 1.0).over(clips) == Pops(1.5, 1.5, 1.0, 2.0, 0.2)


def test_there_is_no_ratio_to_a_clip_that_stands_still() -> None:
    assert Pops(1.0, 1.0, 1.0, 1.0, 1.0).over(Pops(1.0, 1.0, 1.0, 1.0, 0.0)) is None


def test_two_frames_have_no_acceleration() -> None:
    assert joint_pops(np.zeros((2, 1, 3))) is None
