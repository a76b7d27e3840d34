from __future__ import annotations

from pathlib import Path

import pytest
from tests.datasets.archives import BROKEN, FILES, make_archive

from footfall.datasets import ClipAnnotation, annotate_clip
from footfall.datasets.clip_annotation import Limits
from footfall.detection import detect_supports
from footfall.errors import ArgumentError
from footfall.io import load, supports_text
from footfall.report import Group, clip_trace, measure
from footfall.skeleton import find_anatomy


@pytest.mark.parametrize("file", FILES)
def test_a_row_says_what_the_other_commands_say(tmp_path: Path, file: str) -> None:
    archive = make_archive(tmp_path / "archive")
    row = annotate_clip(str(archive), file, Limits())
    clip = load(archive / file)
    supports = detect_supports(clip)
    slip = measure(clip_trace(clip, find_anatomy(clip.skeleton), supports)).slip
    assert (row.error, row.frames, row.fps, row.cyclic) == (None, clip.frames, 60.0, clip.cyclic)
    assert (row.supports, row.labels) == (str(supports), supports_text(supports))
    assert (row.spans, row.slip_p95_mm) == (slip.overall.count, slip.overall.p95)
    assert (row.slip_median_mm, row.slip_max_mm) == (slip.overall.median, slip.overall.maximum)
    assert len(Group) == 3
    shares = (row.left_share, row.right_share, row.double_share, row.flight_share)
    assert sum(share or 0.0 for share in shares) == pytest.approx(1.0)
    facts = (archive / file).stat()
    assert (row.size, row.changed) == (facts.st_size, facts.st_mtime_ns)


def test_what_is_wrong_with_a_file_is_in_its_row(tmp_path: Path) -> None:
    archive = str(make_archive(tmp_path / "archive", broken=True))
    broken = annotate_clip(archive, BROKEN, Limits())
    assert broken.error is not None
    assert broken.error.startswith("line 2: ")
    assert (broken.frames, broken.labels) == (None, None)
    missing = annotate_clip(archive, "none.bvh", Limits())
    assert missing.error == "cannot be read: no such file or directory"


@pytest.mark.parametrize(
    ("error", "told"),
    [
        (MemoryError(), "needs more memory than there is"),
        (ZeroDivisionError("a\nb"), "ran into ZeroDivisionError: a b"),
    ],
)
def test_not_even_a_bug_stops_ten_thousand_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: Exception, told: str
) -> None:
    def fail(*_: object) -> None:
        raise error

    archive = make_archive(tmp_path / "archive")
    monkeypatch.setattr("footfall.datasets.clip_annotation.load_with_conclusions", fail)
    assert annotate_clip(str(archive), FILES[0], Limits()).error == told


def test_a_row_survives_the_manifest() -> None:
    row = ClipAnnotation("a.bvh", 1, 2, frames=3, slip_p95_mm=0.1 + 0.2)
    assert ClipAnnotation.from_row(row.to_row()) == row
    assert tuple(row.to_row()) == ClipAnnotation.columns()
    with pytest.raises(TypeError):
        ClipAnnotation.from_row({"file": "a.bvh"})


@pytest.mark.parametrize("limits", [{"height": -1.0}, {"speed": float("nan")}])
def test_an_impossible_limit_is_refused_before_any_work(limits: dict[str, float]) -> None:
    with pytest.raises(ArgumentError, match=r"a limit must be finite and > 0"):
        Limits(**limits)
