"""Figure 3: the feet's events under the figure, and above them the supports they make."""

from __future__ import annotations

import numpy as np
import pytest
from tests.detection.foot_events import foot_events
from tests.paper.requirements import requirement

import footfall as ff
from footfall.detection import detect_contacts

FRAME = 1.0 / 60.0


@requirement(49, "Definition of support phases of a locomotion.")
def test_a_locomotion_is_right_double_left_double() -> None:
    clip, made = ff.sample("walk")
    found = ff.detect_supports(clip)
    symbols = "".join(phase.support.symbol for phase in found.phases)
    assert symbols in "RDLD" * 2
    assert len(symbols) == 4
    assert found.cyclic
    own = {(p.support.symbol, round(p.duration / FRAME)) for p in made.phases}
    seen = {(p.support.symbol, round(p.duration / FRAME)) for p in found.phases}
    for symbol, frames in own:
        assert any(s == symbol and abs(f - frames) <= 3 for s, f in seen)


@requirement(56, "The feet events are under the figure and our representation is above.")
@pytest.mark.parametrize("name", ["walk", "walk-slow", "walk-fast", "walk-backward"])
def test_strikes_and_take_offs_of_each_foot_bound_the_supports(name: str) -> None:
    clip, _ = ff.sample(name)
    found = ff.detect_supports(clip)
    events = sorted(
        time % clip.duration for foot in range(2) for _, time in foot_events(found, foot)
    )
    bounds = sorted(time % clip.duration for time in found.boundaries[:-1])
    np.testing.assert_allclose(events, bounds, rtol=0, atol=1e-9)
    # One strike and one take-off a foot: nothing flickers.
    assert len(events) == 4
    contacts = detect_contacts(clip)
    assert [len(intervals) for intervals in contacts.intervals] == [1, 1]
