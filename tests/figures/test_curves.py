"""Figures 2, 3, 5 and 10 to 12: what their curves and bands do."""

from __future__ import annotations

import numpy as np
import pytest
from tests.figures.drawn import SVG, attributes, cast, drawn, numbers, picture, points, words

from footfall.figures.activation import FADE_IN, FADE_OUT, START, STOP, Moments
from footfall.figures.axes import Axes
from footfall.figures.spline import Rebuilt
from footfall.figures.warp_example import WarpExample
from footfall.timing import end_slope_paper
from footfall.view.palette import FOOT_COLORS, SUPPORT_COLORS
from footfall.view.svg import Picture


def test_figure_2_marks_where_the_weight_leaves_and_reaches_0_and_1() -> None:
    t1, t2, t3, t4 = numbers(drawn(2).facts[0])[1::2]
    assert (t1, t3) == (START, STOP)
    assert FADE_IN <= t2 - t1 <= 2 * FADE_IN + 0.02
    assert FADE_OUT <= t4 - t3 <= 2 * FADE_OUT + 0.02
    curve = next(
        points(line)
        for line in picture(2).iter(f"{SVG}polyline")
        if line.attrib.get("stroke-width") == "4"
    )
    marks = [(float(c["cx"]), float(c["cy"])) for c in attributes(2, "circle")]
    low, high = marks[0][1], marks[1][1]
    assert [y for _, y in marks] == [low, high, high, low]
    for x, y in curve:
        if x < marks[0][0] or x > marks[3][0]:
            assert y == pytest.approx(low, abs=0.5)
        if marks[1][0] < x < marks[2][0]:
            assert y == pytest.approx(high, abs=0.5)
    assert {"t₁", "t₂", "t₃", "t₄"} <= set(words(2))


def test_a_weight_that_never_comes_has_no_t2_and_no_t4() -> None:
    times = np.linspace(0.0, 3.0, 31)
    moments = Moments(times, np.full(31, 0.5), 1.0, 2.0)
    assert (moments.t2, moments.t4) == (float("inf"), float("inf"))
    moments = Moments(times, np.interp(times, [1.0, 1.5, 2.0, 2.5], [0.0, 1.0, 1.0, 0.0]), 1.0, 2.0)
    assert (moments.t2, moments.t4) == (pytest.approx(1.5), pytest.approx(2.5))


def test_figure_3_shows_a_cycle_and_a_half_and_each_foot_strikes_and_leaves() -> None:
    texts = words(3)
    assert [text for text in texts if text in ("RS", "LS", "DS", "Ø")] == [
        "RS", "DS", "LS", "DS", "RS", "DS",
    ]  # fmt: skip
    assert texts.count("strike") == 3
    assert texts.count("off") >= 2
    assert len(attributes(3, "g", stroke_width="2.2")) == 14
    within = numbers(drawn(3).facts[1])[0]
    assert within <= 20.0


def test_figure_5_has_both_curves_of_both_feet_their_limits_and_their_contacts() -> None:
    for color in FOOT_COLORS:
        curves = attributes(5, "polyline", stroke=color)
        assert len(curves) == 2
    assert words(5).count("limit") == 2
    # The shot: two stretches on the right foot, three on the left one.
    contacts = [len(attributes(5, "rect", fill=color, height="32")) for color in FOOT_COLORS]
    assert contacts == [3, 2]


def test_figure_10_has_a_corner_at_each_knot() -> None:
    example = WarpExample.of(cast())
    curve = attributes(10, "polyline", stroke=SUPPORT_COLORS["L"])[0]
    assert len(curve["points"].split()) == len(example.clock_times) == 9
    assert np.abs(np.diff(example.rates)).min() > 0.05
    assert len(attributes(10, "circle", fill=SUPPORT_COLORS["L"])) == 9


def test_figure_12_never_goes_back_and_never_jumps() -> None:
    for fact in drawn(12).facts:
        least, _, back = numbers(fact)[:3]
        assert least >= 0.0
        assert back == 0.0
    printed, ours = (numbers(fact)[:2] for fact in drawn(12).facts)
    assert printed[0] == 0.0
    assert ours[0] > 0.2
    assert ours[1] < printed[1]


def test_figure_11_bounds_a_mirrored_slope_that_is_below_zero() -> None:
    element = Rebuilt.of(cast())
    assert element.rate > 2.0 * element.mean
    assert element.mirrored < 0.0
    assert element.end_rate == end_slope_paper(element.mean, element.rate) == 0.0
    times = np.linspace(element.now, element.new_end, 200)
    values = element.at(times)
    assert values[0] == pytest.approx(element.clip_now)
    assert values[-1] == pytest.approx(element.own)
    assert np.diff(values).min() >= 0.0
    assert [letter for letter in words(11) if letter in "ABCDEF" and letter] == list("ABCDEF")


def test_a_curve_keeps_the_points_where_it_bends() -> None:
    axes = Axes(0.0, 0.0, 100.0, 100.0, (0.0, 1.0), (0.0, 1.0))
    sheet = Picture("test", "test", 100.0, 100.0)
    x = np.linspace(0.0, 1.0, 101)
    axes.curve(sheet, x, np.abs(x - 0.5))
    assert 'points="0,50 50,100 100,50"' in sheet.to_svg()
    bent = Picture("test", "test", 100.0, 100.0)
    axes.curve(bent, x, x**2)
    assert 8 < bent.to_svg().count(",") < 101
