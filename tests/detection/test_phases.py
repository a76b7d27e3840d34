from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.detection import contact_supports, detect_supports, frame_symbols
from footfall.detection.contacts import Contacts
from footfall.detection.intervals import Interval
from footfall.errors import ArgumentError
from footfall.samples import sample
from footfall.support import SupportSequence


def contacts(
    left: list[tuple[float, float]],
    right: list[tuple[float, float]],
    *,
    cyclic: bool = False,
    duration: float = 1.0,
) -> Contacts:
    return Contacts(
        intervals=(
            tuple(Interval(*bounds) for bounds in left),
            tuple(Interval(*bounds) for bounds in right),
        ),
        flags=np.zeros((0, 2), dtype=np.bool_),
        heights=np.zeros((0, 2)),
        speeds=np.zeros((0, 2)),
        ground=np.zeros((0, 2, 2)),
        height_limits=np.ones((2, 2)),
        speed_limits=np.ones((2, 2)),
        belt_velocity=(0.0, 0.0),
        duration=duration,
        cyclic=cyclic,
    )


def test_phases_follow_from_which_feet_are_in_contact() -> None:
    found = contact_supports(contacts([(0.0, 0.3)], [(0.2, 0.7)]))
    assert str(found) == "L.2 D.1 R.4 -.3"


def test_a_cycle_cut_in_mid_phase_begins_before_zero() -> None:
    found = contact_supports(contacts([(0.9, 1.5)], [(0.4, 1.0)], cyclic=True))
    assert str(found) == "L.4 D.1 R.4 D.1*"
    assert found.start == 0.0
    found = contact_supports(contacts([(0.8, 1.4)], [(0.3, 0.9)], cyclic=True))
    assert str(found) == "L.4 D.1 R.4 D.1*"
    assert found.start == pytest.approx(-0.1)


def test_a_foot_that_always_stands_is_one_phase() -> None:
    assert str(contact_supports(contacts([(0.0, 1.0)], [(0.0, 1.0)], cyclic=True))) == "D1*"


def test_a_short_phase_between_two_of_the_same_support_becomes_theirs() -> None:
    found = contact_supports(contacts([(0.0, 1.0)], [(0.5, 0.55)]))
    assert str(found) == "L1"


def test_a_short_double_support_between_two_feet_is_made_long_enough() -> None:
    found = contact_supports(contacts([(0.0, 0.52)], [(0.48, 1.0)]))
    assert str(found) == "L.465 D.07 R.465"


def test_a_very_short_double_support_and_a_short_flight_are_shared() -> None:
    found = contact_supports(contacts([(0.0, 0.51)], [(0.49, 1.0)]))
    assert str(found) == "L.5 R.5"
    found = contact_supports(contacts([(0.0, 0.475)], [(0.525, 1.0)]))
    assert str(found) == "L.5 R.5"


def test_a_short_phase_at_the_end_goes_to_its_only_neighbor() -> None:
    found = contact_supports(contacts([(0.0, 0.96)], []))
    assert str(found) == "L1"


def test_the_minimum_is_the_users() -> None:
    found = contact_supports(contacts([(0.0, 0.51)], [(0.49, 1.0)]), min_duration=0.01)
    assert str(found) == "L.49 D.02 R.49"


TIMES = st.lists(st.floats(0.0, 1.0), min_size=0, max_size=8).map(sorted)


def paired(times: list[float]) -> list[tuple[float, float]]:
    return [(a, b) for a, b in zip(times[::2], times[1::2], strict=False) if b - a > 1e-6]


@settings(deadline=None, max_examples=300)
@given(TIMES, TIMES, st.booleans())
def test_whatever_the_contacts_phases_fill_the_clip_and_none_is_short(
    left: list[float], right: list[float], cyclic: bool
) -> None:
    found = contact_supports(contacts(paired(left), paired(right), cyclic=cyclic))
    assert found.duration == pytest.approx(1.0, abs=1e-9)
    assert min(phase.duration for phase in found.phases) >= 0.06 - 1e-9
    # Construction itself refuses equal neighbors and a first phase that is over at time zero.
    assert isinstance(found, SupportSequence)


def test_a_clip_of_one_frame_has_no_phases() -> None:
    clip, _ = sample("idle", fps=30)
    one = clip.evolve(
        pelvis_positions=clip.pelvis_positions[:1],
        local_rotations=clip.local_rotations[:1],
        cyclic=False,
    )
    with pytest.raises(ArgumentError) as raised:
        detect_supports(one)
    assert str(raised.value) == ("a clip of a single frame has no phases; at least two are needed")


def test_symbols_of_frames() -> None:
    assert frame_symbols(SupportSequence.parse("R.12 D.05 -.1"), 20.0, 5) == "RRRD-"
