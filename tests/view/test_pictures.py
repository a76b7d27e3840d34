"""Pictures compared with those kept in tests/golden/pictures.

After a wanted change: ``python -m tests.view.test_pictures`` writes them anew; look at them.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from tests import walking_figure
from tests.view import walking_pictures

from footfall.adaptation import Plane, Stairs, Terrain
from footfall.errors import ArgumentError
from footfall.view import ActionLane, LanePhase, Timeline, foot_traces_svg, strip_svg, timeline_svg
from footfall.view.palette import SLIP, SUPPORT_COLORS

GOLDEN = Path(__file__).parents[1] / "golden" / "pictures"
PICTURES: dict[str, Callable[[], str]] = {
    "timeline": lambda: timeline_svg(walking_pictures.timeline()),
    "foot_traces": lambda: foot_traces_svg(walking_pictures.takes()),
    "strip": lambda: strip_svg(
        walking_pictures.takes(40), walking_figure.skeleton().parents, seconds=0.2
    ),
}


@pytest.mark.parametrize("name", PICTURES)
def test_a_picture_is_what_it_was(name: str) -> None:
    assert PICTURES[name]() == (GOLDEN / f"{name}.svg").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", PICTURES)
def test_a_picture_is_well_formed(name: str) -> None:
    ElementTree.fromstring(PICTURES[name]())


def test_only_feet_that_slide_leave_red_streaks() -> None:
    without, sliding = (foot_traces_svg([take]) for take in reversed(walking_pictures.takes()))
    streaks = [svg.count(f'stroke="{SLIP}" stroke-width="5"') for svg in (without, sliding)]
    # The legend has one.
    assert streaks == [1, 4]


def test_a_streak_is_labeled_with_its_millimeters() -> None:
    svg = foot_traces_svg([("sliding", walking_pictures.trace(0.12))])
    labels = re.findall(rf'fill="{SLIP}" font-weight="700">(\d+)<', svg)
    # 12 % of 0.82 m/s for 0.66 s less 67 ms at both ends; the last stance is cut short.
    assert labels == ["51", "51", "41"]


def test_long_ways_are_broken_into_rows() -> None:
    rows = [
        foot_traces_svg([("walk", walking_pictures.trace(0.0, frames))]).count("<use ")
        for frames in (100, 900)
    ]
    assert rows == [1, 2]


def test_only_transitions_are_red_in_the_strip() -> None:
    svg = strip_svg(
        [("walk", walking_pictures.trace(0.0))], walking_figure.skeleton().parents, seconds=0.1
    )
    groups = re.findall(r'<g stroke-width="2.2"[^>]*>', svg)
    red = [SLIP in group for group in groups]
    assert red == [40 <= frame < 60 for frame in range(0, 100, 6)]


def test_the_strip_shows_the_ground_that_is_walked_on() -> None:
    stairs = Terrain((Plane(), Stairs((0.0, 0.0, 0.3), 2, rise=0.1, tread=0.4)))
    take = [("walk", walking_pictures.trace(0.0))]
    svg = strip_svg(take, walking_figure.skeleton().parents, ground=stairs)
    (outline,) = re.findall(r'<polyline points="([^"]*)" fill="none" class="softpen"', svg)
    heights = [float(point.split(",")[1]) for point in outline.split()]
    # The level, a tread and the landing: two rises of the same height, upward.
    often = [y for y in dict.fromkeys(heights) if heights.count(y) > 20]
    assert len(often) == 3
    assert often[0] - often[1] == pytest.approx(often[1] - often[2], abs=0.02)
    assert often[0] > often[1]


def test_figures_need_a_time_between_them() -> None:
    with pytest.raises(ArgumentError) as caught:
        strip_svg(walking_pictures.takes(), walking_figure.skeleton().parents, seconds=0.0)
    assert str(caught.value) == "figures every 0.0 s; the time between them must be > 0"


def test_held_phases_are_hatched_and_others_are_not() -> None:
    weights = np.ones(60)
    for stretch, hatched in ((1.0, 1), (1.7, 2)):
        lane = ActionLane("walk", (LanePhase("R", 0.0, 1.0, stretch),), weights)
        svg = timeline_svg(Timeline(60.0, "R" * 60, (lane,)))
        # The legend has one.
        assert svg.count('fill="url(#timeline-held)"') == hatched


@pytest.mark.parametrize(
    ("name", "told", "begins"),
    [
        ("walk", "walk", 132.0),
        ("a walk that turns round", "a walk that turns round", 222.0),
        ("16_15_walk_with_a_turn_to_the_left_and_a_stop", "16_15_walk_with_a_turn_to_th…", 300.0),
        ("歩く" * 20, "歩く" * 8 + "…", 300.0),
    ],
)
def test_lanes_begin_behind_the_longest_name(name: str, told: str, begins: float) -> None:
    lane = ActionLane(name, (LanePhase("R", 0.0, 1.0),), np.ones(60))
    svg = timeline_svg(Timeline(60.0, "R" * 60, (lane,)))
    assert f">{told}</text>" in svg
    assert float(re.findall(r'data-left="([\d.]+)"', svg)[0]) == pytest.approx(begins, abs=12.0)
    lines = [float(x) for x in re.findall(r'<line x1="([\d.]+)"[^>]*class="rule"', svg)]
    assert min(lines) == float(re.findall(r'data-left="([\d.]+)"', svg)[0])


def test_every_support_has_its_own_color() -> None:
    assert len(set(SUPPORT_COLORS.values())) == 4


def test_weights_must_be_one_a_frame() -> None:
    with pytest.raises(ArgumentError) as caught:
        Timeline(60.0, "RRR", (ActionLane("walk", (), np.ones(2)),))
    assert str(caught.value) == "the weights of 'walk' have shape (2,); 3 frames need (3,)"


def test_a_support_must_have_a_symbol() -> None:
    with pytest.raises(ArgumentError) as caught:
        Timeline(60.0, "RX", (ActionLane("walk", (LanePhase("Q", 0.0, 1.0),), np.ones(2)),))
    assert str(caught.value) == "no support is written ['Q', 'X']; there are R, L, D and -"


if __name__ == "__main__":
    GOLDEN.mkdir(parents=True, exist_ok=True)
    for picture, draw in PICTURES.items():
        (GOLDEN / f"{picture}.svg").write_text(draw(), encoding="utf-8")
