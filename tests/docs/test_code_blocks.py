"""Every code block of the documentation is run, page by page, in an empty folder."""

from __future__ import annotations

import re
import shlex
import subprocess
import textwrap
from pathlib import Path
from typing import Any

import pytest

from footfall.cli import main
from footfall.scenario.cue_sheet import parse_scenario

ROOT = Path(__file__).parents[2]
PAGES = sorted([*(ROOT / "docs").rglob("*.md"), ROOT / "README.md"])
FENCE = re.compile(r"^( *)```(\w*)\n(.*?)^\1```$", re.MULTILINE | re.DOTALL)

SHOWN = {"text", ""}
"""Languages of blocks that are shown, not run: the output of a command, a synopsis."""


def blocks(page: Path) -> list[tuple[str, str]]:
    """Return the language and the text of each block of a page, in order."""
    text = page.read_text(encoding="utf-8")
    return [(match[2], textwrap.dedent(match[3])) for match in FENCE.finditer(text)]


def run_command(line: str) -> None:
    words = shlex.split(line, comments=True)
    if words[:1] == ["footfall"]:
        assert main(words[1:]) in (None, 0), line
    elif words[:1] == ["make"]:
        # What a target does is tested elsewhere; that there is one is tested here.
        subprocess.run(["make", "-n", *words[1:]], cwd=ROOT, check=True, capture_output=True)
    else:
        raise AssertionError(f"nobody runs {line!r}; write it as text, or teach this test")


BEGINNING = """
fps = 60
duration = 3.0

[[action]]
name = "walk"
motion = "sample:walk"

"""
"""What a piece of a cue sheet goes on from."""


def save_cue_sheet(text: str, names: list[str]) -> None:
    """Save a cue sheet under the first name that its page gives; read a piece of one at once."""
    if names:
        Path(names[0]).write_text(text, encoding="utf-8")
    else:
        parse_scenario(BEGINNING + text)


def test_every_block_is_of_a_language_that_is_run_or_shown() -> None:
    languages = {language for page in PAGES for language, _ in blocks(page)}
    assert languages <= {"python", "sh", "toml"} | SHOWN


@pytest.mark.full
@pytest.mark.parametrize(
    "page",
    [page for page in PAGES if {"python", "sh"} & {language for language, _ in blocks(page)}],
    ids=lambda page: str(page.relative_to(ROOT)),
)
def test_every_block_runs(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {"__name__": "__main__"}
    for number, (language, text) in enumerate(blocks(page)):
        if language == "python":
            exec(compile(text, f"{page.name}, block {number}", "exec"), names)
        elif language == "toml":
            save_cue_sheet(text, re.findall(r"`(\w+\.toml)`", page.read_text(encoding="utf-8")))
        elif language == "sh":
            for line in text.splitlines():
                run_command(line)


def test_every_picture_and_every_link_is_there() -> None:
    for page in PAGES:
        for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8")):
            assert (page.parent / target).exists(), f"{page.name}: {target}"


def test_every_page_is_on_the_map() -> None:
    map_text = (ROOT / "mkdocs.yml").read_text(encoding="utf-8")
    for page in PAGES[:-1] if PAGES[-1].name == "README.md" else PAGES:
        if page.parent.name != "gallery" and page != ROOT / "README.md":
            assert str(page.relative_to(ROOT / "docs")) in map_text
