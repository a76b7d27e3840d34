"""Five real clips labeled by eye: every boundary within two frames of 30 fps."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.detection.foot_events import foot_events

from footfall.detection import detect_supports
from footfall.io import load, load_supports

LABELS = sorted((Path(__file__).parent / "labels").glob("*.supports"))
FOLDER = Path(__file__).parents[3] / "shared" / "motions"

needs_clips = pytest.mark.skipif(not FOLDER.is_dir(), reason="no ../shared/motions")


@needs_clips
@pytest.mark.parametrize("path", LABELS, ids=lambda path: path.stem)
def test_every_boundary_is_where_it_was_seen(path: Path) -> None:
    name = path.read_text(encoding="utf-8").splitlines()[0].removeprefix("# ")
    clip = load(FOLDER / name).evolve(cyclic=False)
    expected, found = load_supports(path), detect_supports(clip)
    assert found.duration == pytest.approx(clip.duration)
    assert expected.duration == pytest.approx(clip.duration, abs=0.002)
    for foot in range(2):
        seen, events = foot_events(expected, foot), foot_events(found, foot)
        assert [kind for kind, _ in events] == [kind for kind, _ in seen]
        for (kind, time), (_, other) in zip(seen, events, strict=True):
            assert abs(other - time) <= 2.0 / 30.0, (kind, time, other)


def test_there_are_five() -> None:
    assert len(LABELS) == 5
