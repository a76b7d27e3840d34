"""Ten real clips labeled by eye: boundaries within two frames of 30 fps."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.detection.foot_events import Events, foot_events

from footfall.detection import detect_supports
from footfall.io import load, load_supports
from footfall.support import SupportSequence

LABELS = sorted((Path(__file__).parent / "labels").glob("*.supports"))
FOLDER = Path(__file__).parents[3] / "shared" / "motions"

NEAR = 2.0 / 30.0
"""A boundary found this near to where it was seen counts as found [s]."""

NOT_FOUND = {"cmu16_57_run_stop": 1, "cmu69_17_turn_in_place": 5, "pymo_figure8_walk": 1}
"""Boundaries that are found more than `NEAR` off: of clips that were labeled when detection was
done. The feet of the turn in place pivot: on the heel, on the ball, and 1 cm above the ground."""

needs_clips = pytest.mark.skipif(not FOLDER.is_dir(), reason="no ../shared/motions")


@needs_clips
@pytest.mark.parametrize("path", LABELS, ids=lambda path: path.stem)
def test_boundaries_are_where_they_were_seen(path: Path) -> None:
    name = path.read_text(encoding="utf-8").splitlines()[0].removeprefix("# ")
    clip = load(FOLDER / name).evolve(cyclic=False)
    expected, found = load_supports(path), detect_supports(clip)
    assert found.duration == pytest.approx(clip.duration)
    assert expected.duration == pytest.approx(clip.duration, abs=0.002)
    assert len(far_off(expected, found)) == NOT_FOUND.get(path.stem, 0)


def far_off(expected: SupportSequence, found: SupportSequence) -> Events:
    """Return the boundaries that are found too far from where they were seen.

    As many are found of each foot as were seen, and of the same kinds, in the same order.
    """
    off: Events = []
    for foot in range(2):
        seen, events = foot_events(expected, foot), foot_events(found, foot)
        assert [kind for kind, _ in events] == [kind for kind, _ in seen]
        off += [
            (kind, time)
            for (kind, time), (_, other) in zip(seen, events, strict=True)
            if abs(other - time) > NEAR
        ]
    return off


def test_there_are_ten() -> None:
    assert len(LABELS) == 10
