"""Equation 6: the duration of a slot is the mean of its phases', by the weights of the legs."""

from __future__ import annotations

import numpy as np
import pytest
from tests.paper.requirements import requirement

from footfall.support import SupportSequence
from footfall.timing import normalize_weights, slot_duration

WALK = SupportSequence.parse("R.38 D.12 L.38 D.12*")
RUN = SupportSequence.parse("R.24 -.12 L.24 -.12*")


def durations(priorities: tuple[float, float]) -> list[float]:
    """Return the durations of four slots of a walk beside a run, both fully active."""
    shares = np.empty((3, 1))
    normalize_weights(np.array(priorities).reshape(2, 1), np.ones(2), shares)
    return [
        slot_duration(shares[:2, 0], np.array([WALK.at(k).duration, RUN.at(k).duration]), 2)
        for k in range(4)
    ]


@requirement(76, "there remains to compute the duration of these elements")
@requirement(77, "in order to compute the normalized weight")
@pytest.mark.parametrize(
    ("priorities", "expected"),
    [
        ((1.0, 1.0), [0.31, 0.12, 0.31, 0.12]),
        ((3.0, 1.0), [0.345, 0.12, 0.345, 0.12]),
        ((1.0, 0.0), [0.38, 0.12, 0.38, 0.12]),
        ((0.0, 2.0), [0.24, 0.12, 0.24, 0.12]),
    ],
)
def test_durations_are_averaged_by_priority(
    priorities: tuple[float, float], expected: list[float]
) -> None:
    assert durations(priorities) == pytest.approx(expected, rel=1e-14)


def test_the_neutral_motion_never_votes() -> None:
    shares = np.empty((2, 1))
    normalize_weights(np.ones((1, 1)), np.array([0.01]), shares)
    assert shares[1, 0] == 0.99
    assert slot_duration(shares[:, 0], np.array([0.4, 100.0]), 1) == 0.4


@requirement(
    79,
    "Changing the duration of the elements of the sequences involves a compression or a dilation "
    "of time.",
)
def test_one_action_alone_keeps_its_own_durations_exactly() -> None:
    for phase in WALK.phases:
        assert slot_duration(np.array([1.0]), np.array([phase.duration]), 1) == phase.duration
