"""Every example runs, is short, and draws the picture that stands beside it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

FOLDER = Path(__file__).parents[2] / "examples"
PICTURES = FOLDER.parent / "docs" / "images" / "examples"
EXAMPLES = sorted(FOLDER.glob("[0-9][0-9]_*.py"))


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_is_short_and_has_its_picture(path: Path) -> None:
    assert len(path.read_text(encoding="utf-8").splitlines()) <= 60
    assert (PICTURES / f"{path.stem}.svg").exists()


def test_they_are_numbered_without_a_gap() -> None:
    assert len(EXAMPLES) >= 6
    assert [path.name[:2] for path in EXAMPLES] == [f"{n + 1:02}" for n in range(len(EXAMPLES))]


@pytest.mark.full
@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_runs_and_draws(path: Path, tmp_path: Path) -> None:
    subprocess.run([sys.executable, path, tmp_path], check=True, capture_output=True)
    (drawn,) = tmp_path.glob("*.svg")
    assert drawn.stem == path.stem
    assert drawn.read_text(encoding="utf-8").startswith("<svg")
