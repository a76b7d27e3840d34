"""A real browser on a real studio, for tests; skipped with a reason where there is none."""

from __future__ import annotations

import shutil
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, cast

import pytest

from footfall.studio import open_studio

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")

ARGUMENTS = [
    "--headless=new",
    "--no-sandbox",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist",
    "--disable-dev-shm-usage",
    "--disable-background-networking",
]

LONGEST_WAIT = 60.0


@contextmanager
def studio_in_browser(
    folder: Path, *, width: int = 1280, height: int = 800, files: list[str] | None = None
) -> Generator[tuple[Any, Any]]:
    """Yield a studio and a page of the browser that shows it; any error of the page fails."""
    if CHROMIUM is None:
        pytest.skip("no chromium here; the Debian package of this name is needed")
    sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    errors: list[str] = []

    def failed(error: object) -> None:
        errors.append(str(error))

    with (
        open_studio(files or (), folder=folder, port=0) as studio,
        sync_api.sync_playwright() as driver,
    ):
        studio.session.jobs.wait()
        browser = driver.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        page = browser.new_page(viewport={"width": width, "height": height})
        page.on("pageerror", failed)
        page.goto(studio.url)
        page.wait_for_selector(".card", timeout=1000 * LONGEST_WAIT)
        try:
            yield studio, page
        finally:
            browser.close()
    assert errors == [], errors


def until(true: Callable[[], object], what: str) -> None:
    """Return once something holds; fail if it does not for long."""
    end = time.monotonic() + LONGEST_WAIT
    while not true():
        assert time.monotonic() < end, f"waited {LONGEST_WAIT:g} s for {what}"
        time.sleep(0.05)


def overflowing(page: Any) -> list[str]:
    """Return what on the page is cut off, or reaches beyond the window or its box."""
    return cast(list[str], page.evaluate(OVERFLOWING))


def overlapping(page: Any) -> list[str]:
    """Return pairs of controls that lie on each other."""
    return cast(list[str], page.evaluate(OVERLAPPING))


OVERFLOWING = """() => {
  const bad = [];
  const clips = (e) => getComputedStyle(e).overflowX !== "visible";
  const kinds = "button, summary, kbd, select, output, h1, h2, label, p, small";
  for (const e of document.querySelectorAll(kinds)) {
    const box = e.getBoundingClientRect();
    if (!box.width || !box.height || e.closest("details:not([open]) > div")) continue;
    const name = `${e.tagName} ${e.textContent.trim().slice(0, 30)}`;
    if (box.left < -1 || box.right > innerWidth + 1) bad.push(`${name} beyond the window`);
    if (e.tagName !== "SELECT" && e.clientWidth && !clips(e) && e.scrollWidth > e.clientWidth + 1) {
      bad.push(`${name} is cut`);
    }
    const outer = e.closest(".card, .box, .hud, header")?.getBoundingClientRect();
    if (outer && (box.right > outer.right + 1 || box.left < outer.left - 1)) {
      bad.push(`${name} beyond its box`);
    }
  }
  return bad;
}"""

OVERLAPPING = """() => {
  const kinds = "header button, header summary, header output, .hud, .card .row > *, .box button";
  const seen = [...document.querySelectorAll(kinds)].filter((e) => e.checkVisibility()
    && e.getBoundingClientRect().width && !e.closest("details > div") && !e.closest(".list"));
  const bad = [];
  seen.forEach((a, i) => seen.slice(i + 1).forEach((b) => {
    if (a.contains(b) || b.contains(a)) return;
    const [p, q] = [a.getBoundingClientRect(), b.getBoundingClientRect()];
    const wide = Math.min(p.right, q.right) - Math.max(p.left, q.left);
    const tall = Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top);
    const [one, other] = [a, b].map((e) => e.textContent.trim().slice(0, 20));
    if (wide > 1 && tall > 1) bad.push(`${one} on ${other}`);
  }));
  return bad;
}"""
