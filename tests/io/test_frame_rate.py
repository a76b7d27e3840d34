from __future__ import annotations

from decimal import Decimal

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.errors import ArgumentError
from footfall.io.frame_rate import conclude_rate, frame_time_text


@pytest.mark.parametrize(
    ("text", "rate"),
    [
        ("0.0333333", 30.0),
        ("0.033333", 30.0),
        ("0.033", 30.0),
        ("3.33333e-02", 30.0),
        ("0.03336670", 29.97),
        ("0.0417083750417", 23.976),
        ("0.041667", 24.0),
        ("0.008333", 120.0),
        ("0.00833333", 120.0),
        ("0.0166667", 60.0),
        ("0.010000", 100.0),
        ("0.008", 125.0),
        ("0.04", 25.0),
        ("0.002", 500.0),
        ("1.0", 1.0),
        ("0.03", 1 / 0.03),
        ("0.0334", 29.97),
        ("0.0331", 1 / 0.0331),
    ],
)
def test_a_rounded_frame_time_means_the_usual_rate(text: str, rate: float) -> None:
    assert conclude_rate(Decimal(text), None).value == pytest.approx(rate, rel=1e-15)


def test_another_rounding_of_one_number_is_another_rate() -> None:
    rates = [conclude_rate(Decimal(text), None).value for text in ("0.0333", "0.03330")]
    assert rates == pytest.approx([30.0, 1 / 0.0333], rel=1e-15)


@settings(deadline=None)
@given(st.floats(1e-5, 1e5))
def test_a_written_rate_is_read_back_exactly(fps: float) -> None:
    assert conclude_rate(Decimal(frame_time_text(fps)), None).value == fps


@pytest.mark.parametrize(
    ("text", "fps", "reason"),
    [
        ("0.04", None, "25 frames per second: the file's frame time is 0.04 s"),
        (
            "0.0333333",
            None,
            "30 frames per second: the file's frame time of 0.0333333 s is 1/30 s rounded",
        ),
        ("1.0", 30.0, "30 frames per second, as asked for; the file says 1.0 s"),
        (
            "1.0",
            None,
            "1 frames per second: the file's frame time is 1 s; THIS IS IMPLAUSIBLE and the true "
            "rate cannot be known from the file: pass fps= if you know it",
        ),
    ],
)
def test_the_reason_says_where_the_rate_is_from(text: str, fps: float | None, reason: str) -> None:
    assert conclude_rate(Decimal(text), fps).reason == reason


@pytest.mark.parametrize("fps", [0.0, -30.0, float("inf"), float("nan")])
def test_an_impossible_rate_is_refused(fps: float) -> None:
    with pytest.raises(ArgumentError) as caught:
        conclude_rate(Decimal("0.04"), fps)
    assert str(caught.value) == f"fps={fps} is impossible; it must be > 0"
