"""Contacts of hand-made feet."""

from __future__ import annotations

import numpy as np
import pytest

from footfall.arrays import Floats
from footfall.detection.foot_contacts import foot_contacts
from footfall.detection.intervals import Interval
from footfall.detection.tracks import FootTracks

RATE = 120.0
LIMITS = np.array([0.04, 0.04]), np.array([0.4, 0.4])


def found(heights: Floats, forward: Floats, *, cyclic: bool = False) -> list[Interval]:
    """Return the contacts of a flat foot, from heights [m] and forward speeds [m/s]."""
    both = np.stack([heights, heights], axis=-1)
    velocities = np.zeros((len(heights), 2, 3))
    velocities[..., 2] = forward[:, np.newaxis]
    velocities[..., 1] = np.gradient(heights, 1.0 / RATE)[:, np.newaxis]
    tracks = FootTracks(
        positions=np.zeros((len(heights), 2, 2, 3)),
        velocities=np.zeros((len(heights), 2, 2, 3)),
        rate=RATE,
        duration=(len(heights) - (0 if cyclic else 1)) / RATE,
        cyclic=cyclic,
        leg_length=0.8,
        belt_velocity=(0.0, 0.0),
    )
    return foot_contacts(both, velocities, LIMITS, tracks)


def between(times: Floats, start: float, end: float) -> Floats:
    return ((times >= start) & (times < end)).astype(np.float64)


TIMES = np.arange(241) / RATE


def test_a_foot_stands_where_it_is_low_and_slow() -> None:
    up = 1.0 - between(TIMES, 0.5, 1.2)
    contacts = found(0.2 * up, 2.0 * up)
    assert len(contacts) == 1
    assert contacts[0].start == pytest.approx(0.5, abs=0.02)
    assert contacts[0].end == pytest.approx(1.2, abs=0.02)
    assert contacts[0].start_confidence > 0.9


def test_a_low_swing_is_no_contact_and_a_high_rest_is_none() -> None:
    assert found(np.full(241, 0.01), np.full(241, 2.0)) == []
    assert found(np.full(241, 0.2), np.zeros(241)) == []


def test_a_contact_that_flickers_is_bridged() -> None:
    speed = 2.0 * (1.0 - between(TIMES, 0.5, 1.2))
    speed += 0.5 * between(TIMES, 0.8, 0.86)
    assert len(found(np.zeros(241), speed)) == 1


def test_what_stands_from_the_first_to_the_last_frame_has_no_edges() -> None:
    assert found(np.zeros(241), np.zeros(241)) == [Interval(0.0, 2.0)]
    assert found(np.zeros(240), np.zeros(240), cyclic=True) == [Interval(0.0, 2.0)]


def test_a_contact_over_the_end_of_a_cycle_is_one() -> None:
    times = TIMES[:-1]
    up = between(times, 0.4, 1.7)
    contacts = found(0.2 * up, 2.0 * up, cyclic=True)
    assert len(contacts) == 1
    assert contacts[0].start == pytest.approx(1.7, abs=0.02)
    assert contacts[0].end == pytest.approx(2.4, abs=0.02)


def test_a_step_that_is_dragged_parts_two_contacts() -> None:
    speed = 0.02 + 0.38 * between(TIMES, 0.8, 1.1)
    contacts = found(np.zeros(241), np.minimum(speed, 0.39))
    assert [i.start for i in contacts] == pytest.approx([0.0, 1.1], abs=0.02)
    assert [i.end for i in contacts] == pytest.approx([0.8, 2.0], abs=0.02)
    assert contacts[0].end_confidence == contacts[1].start_confidence == 0.5


def test_a_foot_that_always_slides_is_not_parted() -> None:
    speed = 0.15 + 0.2 * between(TIMES, 0.8, 1.1)
    assert len(found(np.zeros(241), speed)) == 1


def test_a_foot_that_comes_down_gently_stands_later_than_it_is_low_and_slow() -> None:
    """Its height falls as the cube of the time left; it is low and nearly slow at 0.87 s."""
    left = np.clip((1.0 - TIMES) / 0.2, 0.0, None)
    contacts = found(0.1 * left**3, np.zeros(241))
    assert 0.9 < contacts[0].start < 1.0
