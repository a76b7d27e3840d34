"""Section 4.2 and figure 5: supports by two thresholds, and by hand."""

from __future__ import annotations

import numpy as np
import pytest
from tests.paper.requirements import requirement

import footfall as ff
from footfall.detection import contact_supports, detect_contacts
from footfall.errors import SupportSequenceError
from footfall.studio.bands import Bands
from footfall.support import SupportSequence
from footfall.sync import Synchronizer

WALK, MADE = ff.sample("walk")


def carrying(height: float, speed: float) -> tuple[float, float]:
    """Return the share of the frames in which each foot is found in contact."""
    left, right = detect_contacts(WALK, height=height, speed=speed, min_duration=0.0).flags.mean(
        axis=0
    )
    return float(left), float(right)


@requirement(
    50, "the synchronization algorithm uses the support phases in whatever way they were generated"
)
def test_supports_made_detected_and_written_by_hand_are_all_synchronized() -> None:
    for sequence in (MADE, ff.detect_supports(WALK), SupportSequence.parse("R.4 D.14 L.4 D.14*")):
        synchronizer = Synchronizer([sequence, SupportSequence.parse("R -*")])
        assert synchronizer.start(0)
        synchronizer.start(1)
        for _ in range(8):
            synchronizer.next_slot()
        assert set(synchronizer.playing) == {0, 1}


@requirement(
    51, "It only considers that two successive elements in a sequence are never identical."
)
@pytest.mark.parametrize("text", ["R R", "D L L D", "R D L R*", "- R -*"])
def test_two_equal_neighbors_are_refused_those_across_the_wrap_too(text: str) -> None:
    with pytest.raises(SupportSequenceError, match="merge them into one"):
        SupportSequence.parse(text)


@requirement(52, "the maximum authorized height for the lowest extremity of the foot")
def test_a_foot_above_the_height_is_not_in_contact() -> None:
    limits = (0.002, 0.01, 0.03, 0.08)
    shares = [sum(carrying(height=height, speed=0.8)) for height in limits]
    assert shares == sorted(shares)
    assert shares[0] < shares[-1]
    found = detect_contacts(WALK, height=0.03, speed=0.8, min_duration=0.0)
    assert found.heights[found.flags].max() <= 0.03 + 1e-6


@requirement(53, "the maximum authorized speed when the foot is under the previous threshold")
def test_a_foot_above_the_speed_is_not_in_contact() -> None:
    limits = (0.05, 0.3, 0.8, 2.0)
    shares = [sum(carrying(height=0.05, speed=speed)) for speed in limits]
    assert shares == sorted(shares)
    assert shares[0] < 0.8 * shares[-1]


@requirement(
    54,
    "The foot is considered in contact with the ground if the two previous parameters are "
    "respected.",
)
def test_the_low_and_fast_foot_of_the_swing_is_no_contact() -> None:
    height = 0.12
    found = detect_contacts(WALK, height=height, speed=0.8, min_duration=0.0)
    swings_low = (found.heights < height) & (found.speeds > 1.5)
    assert swings_low.any()
    assert not found.flags[swings_low].any()


@requirement(55, "At the bottom, the two horizontal areas define the support phases for each foot.")
def test_each_foot_has_a_band_that_can_be_edited_and_the_supports_follow() -> None:
    bands = Bands.of(MADE, WALK.duration)
    assert [len(row) for row in bands.feet] == [1, 1]
    contacts = detect_contacts(WALK)
    before = bands.sequence(contacts)
    assert before.boundaries == pytest.approx(MADE.boundaries, abs=1e-9)
    left = bands.feet[0][0]
    after = bands.with_edge(0, 0, "end", left.end - 0.04).sequence(contacts)
    assert np.abs(np.subtract(after.boundaries, before.boundaries)).max() == pytest.approx(0.04)
    assert contact_supports(contacts).cyclic
