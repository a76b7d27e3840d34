from __future__ import annotations

import math
from itertools import pairwise, product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.errors import SupportSequenceError
from footfall.support import Support, SupportPhase, SupportSequence, merge_equal_neighbors

PLAYABLE = (Support.RIGHT, Support.LEFT, Support.DOUBLE, Support.FLIGHT)
milliseconds = st.integers(1, 100_000).map(lambda count: count / 1000.0)


@st.composite
def sequences(draw: st.DrawFn) -> SupportSequence:
    phases = draw(st.lists(st.builds(SupportPhase, st.sampled_from(PLAYABLE), milliseconds)))
    kept = merge_equal_neighbors(phases) or (SupportPhase(Support.DOUBLE, 0.5),)
    closes = len(kept) == 1 or kept[0].support is not kept[-1].support
    # Sums of milliseconds are not whole in binary; what is written is.
    rounded = tuple(SupportPhase(p.support, round(p.duration, 3)) for p in kept)
    return SupportSequence(rounded, draw(st.booleans()) and closes)


def phase(symbol: str, duration: float = 1.0) -> SupportPhase:
    return SupportPhase(Support.from_symbol(symbol), duration)


def letters(sequence: SupportSequence, count: int) -> str:
    return " ".join(sequence.at(k).support.symbol for k in range(count))


@settings(deadline=None)
@given(sequences())
def test_what_is_written_reads_back_the_same(sequence: SupportSequence) -> None:
    assert SupportSequence.parse(str(sequence)) == sequence


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("R.38 D.12 L.38 D.12*", "R.38 D.12 L.38 D.12*"),
        ("R L", "R1 L1"),
        ("  R0.250   -10.\tL2 * ", "R.25 -10 L2*"),
        ("D", "D1"),
        ("D*", "D1*"),
        ("R.0004 L.0005 R.0000012346", "R.0004 L.001 R.000001235"),
        ("R1234.5678 L.9999", "R1234.568 L1"),
    ],
)
def test_the_text_form(text: str, written: str) -> None:
    assert str(SupportSequence.parse(text)) == written


@settings(deadline=None)
@given(st.floats(1e-12, 1e6))
def test_a_duration_however_short_is_written_to_a_thousandth_or_a_millisecond(
    duration: float,
) -> None:
    (written,) = SupportSequence.parse(str(SupportSequence((phase("D", duration),)))).phases
    assert abs(written.duration - duration) <= 0.0005 * (1.0 + 1e-9) + 1e-9 * duration
    if duration < 0.0005:
        assert written.duration == pytest.approx(duration, rel=1e-2)


def test_the_star_can_be_overruled() -> None:
    assert SupportSequence.parse("R L*", cyclic=False) == SupportSequence.parse("R L")
    assert SupportSequence.parse("R L", cyclic=True) == SupportSequence.parse("R L*")


def test_a_cycle_goes_round_and_a_clamped_sequence_stays_on_its_last_phase() -> None:
    assert letters(SupportSequence.parse("R D L D*"), 10) == "R D L D R D L D R D"
    assert letters(SupportSequence.parse("D L - D L"), 8) == "D L - D L L L L"


@settings(deadline=None)
@given(sequences())
def test_boundaries_are_the_sums_of_the_durations(sequence: SupportSequence) -> None:
    bounds = sequence.boundaries
    assert len(bounds) == len(sequence.phases) + 1
    assert bounds[0] == sequence.start == 0.0
    assert bounds[-1] == pytest.approx(sequence.duration, rel=1e-12)
    for (begin, end), one in zip(pairwise(bounds), sequence.phases, strict=True):
        assert end - begin == pytest.approx(one.duration, rel=1e-9)


@settings(deadline=None)
@given(sequences(), st.floats(0.001, 0.999))
def test_each_clip_time_falls_in_the_phase_it_is_in(
    sequence: SupportSequence, share: float
) -> None:
    for index, (begin, end) in enumerate(pairwise(sequence.boundaries)):
        inside = begin + share * (end - begin)
        assert sequence.index_at(inside) == index
        assert sequence.support_at(inside) is sequence.phases[index].support
        if sequence.cyclic:
            for turns in (-2, -1, 1, 2):
                # Far from the boundaries by more than the rounding of a few turns.
                middle = 0.5 * (begin + end) + turns * sequence.duration
                assert sequence.index_at(middle) == index


def test_a_boundary_belongs_to_the_phase_that_begins_there() -> None:
    sequence = SupportSequence.parse("R.5 D.25 L.5")
    assert [sequence.index_at(t) for t in (0.0, 0.5, 0.75)] == [0, 1, 2]
    assert sequence.index_at(math.nextafter(0.5, 0.0)) == 0


def test_past_its_ends_a_clamped_sequence_stays_on_its_outer_phases() -> None:
    sequence = SupportSequence.parse("R.5 D.25 L.5")
    assert [sequence.index_at(t) for t in (-3.0, 1.25, 99.0)] == [0, 2, 2]


def test_a_cycle_cut_in_the_middle_of_a_phase_begins_before_its_first_frame() -> None:
    sequence = SupportSequence(
        SupportSequence.parse("R.5 D.25 L.5 D.25").phases, cyclic=True, start=-0.25
    )
    assert sequence.boundaries == (-0.25, 0.25, 0.5, 1.0, 1.25)
    times = (-0.25, 0.0, 0.2, 0.25, 0.5, 1.0, 1.24, 1.25, 1.5, 1.75, -0.26, -1.75)
    symbols = [sequence.support_at(t).symbol for t in times]
    assert symbols == ["R", "R", "R", "D", "L", "D", "D", "R", "R", "D", "D", "R"]


def test_just_before_zero_a_cycle_is_in_its_last_phase() -> None:
    assert SupportSequence.parse("R.3 L.7*").index_at(-1e-20) == 1


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "a sequence needs at least one phase, such as R.38"),
        (" * ", "a sequence needs at least one phase, such as R.38"),
        (
            "R.38 X L",
            "'X' in 'R.38 X L' is no support phase; write R, L, D or -, with its seconds if "
            "wanted, such as R.38, and * at the very end for a cycle",
        ),
        (
            "R* L",
            "'R*' in 'R* L' is no support phase; write R, L, D or -, with its seconds if "
            "wanted, such as R.38, and * at the very end for a cycle",
        ),
        ("R0 L", "phase 0 lasts 0.0 s; it must last longer than zero"),
        ("R D L L", "phases 2 and 3 are both LEFT; merge them into one"),
        ("R D R*", "phases 2 and 0, neighbors in the cycle, are both RIGHT; merge them into one"),
    ],
)
def test_texts_that_are_no_sequence_are_refused(text: str, message: str) -> None:
    with pytest.raises(SupportSequenceError) as caught:
        SupportSequence.parse(text)
    assert str(caught.value) == message


@pytest.mark.parametrize("token", ["R1e3", "R-1", "r", "Err", "R.", "R1.2.3", "RL", "--", "R inf"])
def test_no_other_token_is_a_phase(token: str) -> None:
    with pytest.raises(SupportSequenceError, match="is no support phase"):
        SupportSequence.parse(token)


@pytest.mark.parametrize("duration", [0.0, -1.0, math.nan, math.inf])
def test_a_phase_must_last(duration: float) -> None:
    with pytest.raises(SupportSequenceError) as caught:
        SupportSequence((phase("R"), phase("L", duration)))
    assert str(caught.value) == f"phase 1 lasts {duration} s; it must last longer than zero"


def test_a_conflict_is_no_phase() -> None:
    with pytest.raises(SupportSequenceError) as caught:
        SupportSequence((phase("R"), SupportPhase(Support.CONFLICT)))
    assert str(caught.value) == "phase 1 is CONFLICT, which no clip can be"


@pytest.mark.parametrize(
    ("start", "cyclic", "message"),
    [
        (
            0.1,
            True,
            "phase 0 starts at 0.1 s; it must start at or before the first frame and still last "
            "there, so within (-0.5, 0]",
        ),
        (
            -0.5,
            True,
            "phase 0 starts at -0.5 s; it must start at or before the first frame and still last "
            "there, so within (-0.5, 0]",
        ),
        (
            math.nan,
            True,
            "phase 0 starts at nan s; it must start at or before the first frame and still last "
            "there, so within (-0.5, 0]",
        ),
        (
            -0.25,
            False,
            "phase 0 starts at -0.25 s, before the first frame; only a cyclic sequence may",
        ),
    ],
)
def test_the_first_phase_must_be_under_way_at_the_first_frame(
    start: float, cyclic: bool, message: str
) -> None:
    with pytest.raises(SupportSequenceError) as caught:
        SupportSequence((phase("R", 0.5), phase("L", 0.75)), cyclic=cyclic, start=start)
    assert str(caught.value) == message


@pytest.mark.parametrize("count", range(1, 5))
def test_exactly_the_strict_sequences_are_accepted(count: int) -> None:
    for supports in product(PLAYABLE, repeat=count):
        phases = tuple(SupportPhase(support) for support in supports)
        strict = all(a is not b for a, b in pairwise(supports))
        closes = count == 1 or supports[0] is not supports[-1]
        for cyclic, allowed in ((False, strict), (True, strict and closes)):
            if allowed:
                assert SupportSequence(phases, cyclic).phases == phases
            else:
                with pytest.raises(SupportSequenceError, match="merge them into one"):
                    SupportSequence(phases, cyclic)


def test_equal_neighbors_are_joined_and_their_durations_added() -> None:
    phases = [phase("R", 0.25), phase("R", 0.5), phase("L"), phase("R"), phase("R"), phase("R")]
    assert merge_equal_neighbors(phases) == (phase("R", 0.75), phase("L"), phase("R", 3.0))
    assert merge_equal_neighbors([]) == ()


@settings(deadline=None)
@given(st.lists(st.builds(SupportPhase, st.sampled_from(PLAYABLE), milliseconds)))
def test_joining_neighbors_keeps_the_whole_duration(phases: list[SupportPhase]) -> None:
    merged = merge_equal_neighbors(phases)
    assert math.fsum(p.duration for p in merged) == pytest.approx(
        math.fsum(p.duration for p in phases), rel=1e-12
    )
    assert all(a.support is not b.support for a, b in pairwise(merged))


@settings(deadline=None)
@given(sequences(), st.lists(st.floats(-200.0, 200.0), max_size=20))
def test_many_times_at_once_are_answered_as_one_by_one(
    sequence: SupportSequence, times: list[float]
) -> None:
    times = [*times, *sequence.boundaries]
    found = sequence.supports_at(np.array(times)).tolist()
    assert found == [int(sequence.support_at(time)) for time in times]
