"""Contact bands: whatever is done to them, they stay in order, apart, and what they say."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from footfall.detection import detect_contacts
from footfall.errors import ArgumentError
from footfall.samples import sample, sample_names
from footfall.studio.bands import SHORTEST, Bands

NAMES = [name for name in sample_names() if sample(name)[1].duration > 0.3]
WALK, WALK_SUPPORTS = sample("walk")


def walking() -> Bands:
    return Bands.of(WALK_SUPPORTS, WALK.duration)


def apart(bands: Bands) -> bool:
    for row in bands.feet:
        for index, one in enumerate(row):
            after = row[index + 1].start if index + 1 < len(row) else None
            if after is None and bands.cyclic:
                after = row[0].start + bands.duration
            if one.duration < SHORTEST - 1e-9 or (after is not None and one.end > after + 1e-9):
                return False
    return True


@pytest.mark.parametrize("name", NAMES)
def test_the_bands_of_a_sequence_say_that_sequence(name: str) -> None:
    clip, supports = sample(name)
    again = Bands.of(supports, clip.duration).sequence(detect_contacts(clip))
    assert [phase.support for phase in again.phases] == [phase.support for phase in supports.phases]
    assert again.boundaries == pytest.approx(supports.boundaries, abs=1e-9)


@given(
    foot=st.integers(0, 1),
    side=st.sampled_from(["start", "end"]),
    time=st.floats(-5.0, 5.0),
    name=st.sampled_from(["walk", "run", "kick", "jump"]),
)
def test_an_edge_never_passes_its_neighbors(foot: int, side: str, time: float, name: str) -> None:
    clip, supports = sample(name)
    bands = Bands.of(supports, clip.duration)
    assert apart(bands.with_edge(foot, 0, side, time))


def test_an_edge_goes_where_it_is_dragged() -> None:
    start = walking().feet[0][0].start
    moved = walking().with_edge(0, 0, "start", start + 0.05)
    assert moved.feet[0][0].start == pytest.approx(start + 0.05)
    assert moved.feet[1] == walking().feet[1]


def test_a_band_is_split_where_it_is_and_deleted_again() -> None:
    first, second = walking().with_split(0, 0.7).feet[0]
    assert (first.start, second.end) == (walking().feet[0][0].start, walking().feet[0][0].end)
    assert first.end == pytest.approx(0.67)
    assert second.start == pytest.approx(0.73)
    assert walking().with_split(0, 0.7).without(0, 1).feet[0] == (first,)


def test_a_new_band_takes_only_the_room_there_is() -> None:
    bands = walking().with_band(0, 0.1, 0.9)
    assert apart(bands)
    assert len(bands.feet[0]) == 2
    with pytest.raises(ArgumentError, match="there is no room for another band here"):
        walking().with_band(0, 0.5, 0.8)


@pytest.mark.parametrize(
    ("act", "message"),
    [
        (lambda: walking().with_edge(0, 5, "start", 0.1), "no band 5 of foot 0 to move to 0.1 s"),
        (lambda: walking().without(1, 1), "no band 1 of foot 1 to move to 0.0 s"),
        (lambda: walking().with_split(0, 0.1), "no band at 0.100 s; split one where it is"),
    ],
)
def test_what_is_not_there_is_refused(act: object, message: str) -> None:
    assert callable(act)
    with pytest.raises(ArgumentError) as caught:
        act()
    assert str(caught.value) == message
