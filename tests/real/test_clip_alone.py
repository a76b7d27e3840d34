"""Every real clip played alone: it comes out as it went in, and footprints never make it slide.

`pytest -s tests/real/test_clip_alone.py` prints the figures.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.real.test_supports import FOLDER, opened, records

from footfall.motion import Clip
from footfall.report import Track, clip_trace, measure_spans, performance_trace
from footfall.scenario.cue_sheet import ActionEntry, Cue, Scenario
from footfall.scenario.performance import Performance, perform

pytestmark = pytest.mark.skipif(not FOLDER.exists(), reason="no ../shared/motions")

FILES = [record["file"] for record in records()] or ["none"]
LONGEST = 6.0


def played(file: str, clip: Clip, *, footprints: bool, clean: bool = False) -> Performance:
    """Return a clip played once at its own rate; of a long one its beginning."""
    sheet = Scenario(
        FOLDER / "alone.toml",
        (ActionEntry("it", file, clean=clean, cyclic=False),),
        (Cue(0.0, "start", "it"),),
        fps=clip.fps,
        duration=min(clip.duration, LONGEST),
    )
    return perform(sheet, footprints=footprints)


def inner_slips(track: Track) -> list[float]:
    return [each.inner_slip for each in measure_spans(track) if each.inner_slip is not None]


@pytest.mark.parametrize("file", FILES)
def test_without_footprints_it_comes_out_as_it_went_in(file: str) -> None:
    clip, _ = opened(file)
    performance = played(file, clip, footprints=False)
    recording = performance.recording
    _, positions = clip.world_poses()
    # The last frame is where the action begins to leave.
    shown = recording.world_positions[:-1]
    farthest = np.abs(shown - positions[: len(shown)]).max()
    assert farthest < 1e-3
    supports = performance.motions[0].supports
    own = [int(supports.support_at(frame / clip.fps)) for frame in range(len(shown))]
    boundaries = {round(bound * clip.fps) for bound in supports.boundaries}
    differing = set(np.flatnonzero(recording.supports[:-1] != own).tolist())
    assert differing <= boundaries


@pytest.mark.parametrize("file", FILES)
def test_with_footprints_it_slides_no_more_than_its_clip(file: str) -> None:
    clip, _ = opened(file)
    performance = played(file, clip, footprints=True, clean=True)
    supports = performance.motions[0].supports
    own = inner_slips(Track.from_trace(clip_trace(clip, performance.anatomy, supports)))
    held = inner_slips(Track.from_trace(performance_trace(performance)))
    if own and held:
        assert np.median(held) <= np.median(own)
        assert np.percentile(held, 95.0) <= np.percentile(own, 95.0)


def test_the_folder_is_there_whole() -> None:
    print(f"\n{len(FILES)} clips, 0 skipped")
    assert len(FILES) == 49
    assert Path(FOLDER, FILES[0]).exists()
