from __future__ import annotations

from pathlib import Path

import pytest

from footfall.cli import fetching, main
from footfall.datasets import PublicClip, public_clips

Captured = pytest.CaptureFixture[str]


def test_the_list_shows_each_with_its_license(capsys: Captured) -> None:
    assert main(["samples", "list"]) == 0
    lines = capsys.readouterr().out.splitlines()
    for line, clip in zip(lines, public_clips(), strict=True):
        assert line.startswith(clip.name)
        assert clip.license in line
        assert clip.source in line


@pytest.mark.parametrize("names", [[], ["walk"]])
def test_what_is_fetched_is_told_with_its_license(
    names: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Captured
) -> None:
    def fetched(clip: PublicClip, folder: Path | None) -> Path:
        assert folder == tmp_path
        return tmp_path / clip.file

    monkeypatch.setattr(fetching, "fetch_clip", fetched)
    assert main(["samples", "fetch", *names, "--folder", str(tmp_path)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == (len(names) or len(public_clips()))
    assert f"{tmp_path / 'walk.bvh'}  (Apache-2.0, github.com/snumrl/ys2010)" in lines


def test_an_unknown_name_is_told_in_one_line(capsys: Captured) -> None:
    assert main(["samples", "fetch", "moonwalk"]) == 2
    assert capsys.readouterr().err.startswith(
        "footfall: no public clip named 'moonwalk'; there are: "
    )
