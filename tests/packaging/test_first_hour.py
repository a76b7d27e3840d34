"""A newcomer's way, from an empty folder, by the README alone: in under ten minutes."""

from __future__ import annotations

import shlex
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from tests.docs.test_code_blocks import FENCE
from tests.packaging.test_distributions import ROOT, bare_environment, install, run_in
from tests.studio.browser import ARGUMENTS, CHROMIUM, LONGEST_WAIT, until
from tests.studio.test_browser import look_at, resting_edge

from footfall.io import load, load_supports

LONGEST = 600.0
"""All of it [s]."""

pytestmark = pytest.mark.full


def own_clip_blocks() -> list[tuple[str, str]]:
    """Return the language and the text of each block under "Your own clip"."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    section = text.split("## Your own clip")[1].split("\n## ")[0]
    return [(match[2], match[3]) for match in FENCE.finditer(section)]


def follow(block: tuple[str, str], home: Path, folder: Path) -> None:
    """Do what a block says: type its commands, or save it as the cue sheet."""
    language, text = block
    if language == "toml":
        (folder / "cues.toml").write_text(text, encoding="utf-8")
        return
    for line in text.splitlines():
        words = shlex.split(line, comments=True)
        assert words[0] == "footfall", f"a newcomer without anything else cannot type {line!r}"
        run_in(folder, home / "bin" / "footfall", *words[1:])


def correct_in_the_studio(home: Path, folder: Path) -> None:
    """Drag the end of a stance in the browser, and save."""
    sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    command = [home / "bin" / "footfall", "studio", "own.bvh", "--no-browser"]
    with subprocess.Popen(
        command, cwd=folder, env=bare_environment(folder), stdout=subprocess.PIPE, text=True
    ) as studio:
        assert studio.stdout is not None
        url = studio.stdout.readline().removeprefix("studio: ").strip()
        try:
            with sync_api.sync_playwright() as driver:
                browser = driver.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
                page = browser.new_page(viewport={"width": 1280, "height": 800})
                page.goto(url)
                page.wait_for_selector(".card", timeout=1000 * LONGEST_WAIT)
                look_at(page, "supports")
                until(lambda: page.evaluate("Boolean(studio.known.edit)"), "the editor")
                x, y = resting_edge(page, 0, 0, 1)
                page.mouse.move(x, y)
                page.mouse.down()
                page.mouse.move(x - 40, y, steps=6)
                page.mouse.up()
                until(lambda: page.evaluate("studio.known.edit.changed"), "the edit")
                page.click("[data-do=save]")
                until(lambda: not page.evaluate("studio.known.edit.changed"), "the saved state")
                browser.close()
        finally:
            studio.send_signal(signal.SIGINT)
            assert studio.communicate(timeout=LONGEST_WAIT)[0].endswith("closed\n")


@pytest.mark.skipif(CHROMIUM is None, reason="no chromium here")
def test_from_nothing_to_an_exported_blend(built: Path, tmp_path: Path) -> None:
    begin = time.monotonic()
    marks: list[tuple[str, float]] = []

    def mark(what: str) -> None:
        marks.append((what, time.monotonic() - begin))

    folder = tmp_path / "empty"
    folder.mkdir()
    (wheel,) = built.glob("*.whl")
    home = install(f"{wheel}[studio]", sys.executable, tmp_path / "home")
    mark("installed")
    run_in(folder, home / "bin" / "footfall", "demo")
    assert (folder / "demo" / "index.html").stat().st_size > 0
    mark("demo")
    first, cues, last = own_clip_blocks()
    follow(first, home, folder)
    detected = load_supports(folder / "own.supports")
    mark("supports found")
    correct_in_the_studio(home, folder)
    assert load_supports(folder / "own.supports") != detected
    mark("supports corrected")
    follow(cues, home, folder)
    follow(last, home, folder)
    mark("exported")
    assert load(folder / "blended.glb").duration == pytest.approx(4.0, abs=0.1)
    print(", ".join(f"{what} {seconds:.0f} s" for what, seconds in marks))
    assert marks[-1][1] < LONGEST, marks
