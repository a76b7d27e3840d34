"""Figures 13 to 18: what the engine did while they were drawn."""

from __future__ import annotations

import math

import numpy as np
from tests.figures.drawn import attributes, cast, drawn, numbers, words

from footfall.engine import Impossible, Started
from footfall.figures.changing_ground import walk_on_hills
from footfall.figures.comparison import comparison_performances
from footfall.figures.delays import ROWS, delays_performances
from footfall.figures.path_walk import OTHER_SIDE, ROLES, follow_curve, walk_and_turn
from footfall.figures.walk_to_hop import answers
from footfall.figures.way import Way, draw_slides
from footfall.report import measure, performance_trace
from footfall.support import Support
from footfall.view.palette import SLIP
from footfall.view.svg import Picture


def test_figure_13_starts_every_shot_and_never_runs_into_a_conflict() -> None:
    facts = drawn(13).facts
    assert len(facts) == 4
    assert all("started at once" in fact or "started after" in fact for fact in facts)
    assert "Err" not in words(13)
    assert words(13).count("shot") == words(13).count("run") == words(13).count("result") == 4


def test_figure_14_shows_the_sequence_and_that_a_hop_alone_finds_no_room() -> None:
    texts = words(14)
    first = texts.index("RS")
    assert texts[first : first + 10] == ["RS", "DS", "LS", "DS", "RS", "Ø", "RS", "Ø", "RS", "DS"]
    hop, coupled = answers(cast())
    assert isinstance(hop, Impossible)
    assert isinstance(coupled, Started) or coupled.until is not None
    assert set(drawn(14).facts[1:]) <= set(texts)


def test_figure_15_keeps_to_the_line_while_the_body_turns_round() -> None:
    walked = walk_and_turn(cast())
    assert np.ptp(walked.headings) > math.radians(170.0)
    assert np.percentile(np.abs(walked.away), 95) < 0.12
    assert np.abs(walked.away).max() < 0.2
    assert np.ptp(walked.roots[:, 1]) > 5.0
    slip = walked.report.slip.overall
    assert slip.p95 is not None
    assert slip.p95 < 5.0
    for role in ROLES:
        assert role in words(15)


def test_figure_15_goes_round_a_curve_facing_one_way() -> None:
    walked = follow_curve(cast())
    assert np.percentile(np.abs(walked.away), 95) < 0.12
    assert np.abs(walked.away).max() < 0.3
    assert np.abs(np.degrees(walked.headings)).max() < 15.0
    slip = walked.report.slip.overall
    assert slip.p95 is not None
    assert slip.p95 < 5.0
    names = list(walked.recording.actions)
    greatest = {name: float(walked.recording.shares[:, names.index(name)].max()) for name in names}
    assert set(greatest) == {*ROLES, OTHER_SIDE}
    assert min(greatest.values()) > 0.8


def test_figure_16_keeps_feet_on_hills_that_stand_still_or_change() -> None:
    for moving in (False, True):
        report = walk_on_hills(cast(), moving=moving).report
        for spread, bound in (
            (report.drift.overall, 5.0),
            (report.penetration.overall, 5.0),
            (report.floating.overall, 10.0),
        ):
            assert spread.p95 is not None
            assert spread.p95 <= bound
    still, changing = (walk_on_hills(cast(), moving=moving).hills for moving in (False, True))
    assert (still.at(0.0).heights == still.at(3.0).heights).all()
    assert np.abs(changing.at(0.0).heights - changing.at(3.0).heights).max() > 0.05


def test_figure_17_stresses_three_slides_without_synchronization_and_none_with_it() -> None:
    without, synchronized = (
        measure(performance_trace(one)).slip.transitions for one in comparison_performances(cast())
    )
    assert without.maximum is not None
    assert synchronized.maximum is not None
    assert without.maximum > 100.0
    assert synchronized.maximum < 5.0
    # One more in the legend.
    assert len(attributes(17, "ellipse", stroke=SLIP)) == 3 + 1
    assert numbers(drawn(17).facts[1])[-1] == round(synchronized.maximum)
    assert all(
        Support(int(value)) is not Support.CONFLICT
        for value in comparison_performances(cast())[1].supports
    )


def test_no_more_slides_are_stressed_than_asked_for_and_the_worst_comes_first() -> None:
    trace = performance_trace(comparison_performances(cast())[0])
    way = Way.of([trace])
    for most in (0, 1, 2):
        sheet = Picture("test", "test", 1200.0, 300.0)
        stressed = draw_slides(sheet, way, trace, 250.0, most)
        assert len(stressed) == sheet.to_svg().count("<ellipse") == most
        slips = [plant.slip for plant in stressed]
        assert slips == sorted(slips, reverse=True)


def test_figure_18_shows_what_waits_by_the_papers_rule() -> None:
    without, paper, ours = delays_performances(cast())
    assert [start.action for start in paper.starts] == ["walk", "kick", "fast walk", "jump"]
    waited = [start for start in paper.starts if start.actual != start.commanded]
    assert waited
    for start in waited:
        assert start.actual is not None
        told = f"{start.action} +{start.actual - start.commanded:.2f} s"
        assert told in words(18)
    assert all(start.actual == start.commanded for start in (*without.starts, *ours.starts))
    assert [row for row in ROWS if row in words(18)] == list(ROWS)
    # The third row is skinned: limbs in groups, as many as figures.
    assert len(attributes(18, "g", stroke_linejoin="round")) > 10
