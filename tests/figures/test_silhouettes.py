from __future__ import annotations

import re

from tests.figures.drawn import cast

from footfall.figures.silhouettes import Silhouettes
from footfall.figures.way import Way, apart, every
from footfall.report import clip_trace
from footfall.skeleton import find_anatomy
from footfall.view.svg import Picture


def outlines(frame: int) -> list[tuple[str, list[tuple[float, float]]]]:
    walk = cast().motion("walk")
    trace = clip_trace(walk.clip, find_anatomy(walk.clip.skeleton), walk.supports, 2)
    way = Way.of([trace], tallest=200.0)
    picture = Picture("test", "test", 1200.0, 300.0)
    Silhouettes(trace, walk.clip.skeleton, way, 250.0).draw(picture, frame)
    found = re.findall(r'<polygon points="([^"]+)" fill="([^"]+)"', picture.to_svg())
    return [
        (fill, [tuple(map(float, pair.split(","))) for pair in points.split()])  # type: ignore[misc]
        for points, fill in found
    ]


def test_every_limb_is_an_outline_and_feet_touch_the_ground() -> None:
    drawn = outlines(10)
    assert len(drawn) > 15
    lowest = max(y for _, outline in drawn for _, y in outline)
    highest = min(y for _, outline in drawn for _, y in outline)
    assert 249.0 < lowest < 256.0
    # The skull reaches above its joint.
    assert 30.0 < highest < 50.0
    assert {"#3b8fd0", "#e6912a"} <= {fill for fill, _ in drawn}


def test_the_far_side_lies_behind() -> None:
    fills = [fill for fill, _ in outlines(10)]
    # Seen from the right: the left arm and leg come first.
    assert fills.index("#8cb0cc") < fills.index("#deb082")
    assert fills[-1] != "#8cb0cc"


def test_figures_are_apart_by_place_or_by_time() -> None:
    walk = cast().motion("walk")
    trace = clip_trace(walk.clip, find_anatomy(walk.clip.skeleton), walk.supports, 3)
    way = Way.of([trace])
    frames = apart(way, trace, 0.4, 10.0)
    along = way.stage.along(trace.positions[:, 0])[frames]
    assert all(0.39 < step < 0.46 for step in along[1:] - along[:-1])
    assert apart(way, trace, 100.0, 0.5) == every(0.5, trace.frames)
