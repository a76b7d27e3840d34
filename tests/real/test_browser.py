"""A browser plays what we write: three.js in a headless Chromium has the joints where we do."""

from __future__ import annotations

import functools
import http.server
import shutil
import threading
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.studio.browser import ARGUMENTS, CHROMIUM

from footfall.io import load, load_skinned, save, save_skinned
from footfall.motion import Clip
from footfall.samples import sample

NODE = Path(__file__).parents[1] / "node"
GLTF = Path(__file__).parents[3] / "shared" / "motions" / "gltf"

pytestmark = [
    pytest.mark.full,
    pytest.mark.skipif(CHROMIUM is None, reason="no chromium here"),
    pytest.mark.skipif(
        not (NODE / "node_modules" / "three").exists(),
        reason="run `npm install` in tests/node first",
    ),
]


class QuietHandler(http.server.SimpleHTTPRequestHandler):
    def log_message(self, format: str, *args: object) -> None:  # noqa: A002
        """Say nothing."""


@contextmanager
def served(folder: Path) -> Generator[str]:
    handler = functools.partial(QuietHandler, directory=str(folder))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}"
        server.shutdown()


@contextmanager
def player(path: Path) -> Generator[Any]:
    """Yield a page that has loaded a file."""
    sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    shutil.copy(NODE / "playback.html", path.parent)
    (path.parent / "node_modules").symlink_to(NODE / "node_modules")
    errors: list[str] = []

    def failed(error: object) -> None:
        errors.append(str(error))

    with served(path.parent) as address, sync_api.sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        page = browser.new_page(viewport={"width": 320, "height": 320})
        page.on("pageerror", failed)
        page.goto(f"{address}/playback.html?file={path.name}")
        page.wait_for_function("window.animations")
        yield page
        browser.close()
    assert errors == []


def check(page: Any, clips: list[Clip], picture: Path) -> None:
    """Compare every joint in a few frames of each animation, and look whether it is drawn."""
    told = page.evaluate("window.animations")
    assert [name for name, _ in told] == [clip.name for clip in clips]
    worst = 0.0
    for number, clip in enumerate(clips):
        assert told[number][1] == pytest.approx(clip.duration, abs=1e-5)
        positions = clip.world_poses()[1]
        for frame in np.linspace(0, clip.frames - 1, 5).astype(int).tolist():
            seen = page.evaluate("([a, t]) => window.play(a, t)", [number, frame / clip.fps])
            # What stands there is drawn: not nothing, and not all of the picture.
            assert 0.01 < seen["drawn"] < 0.6
            there = np.array([seen["places"][name] for name in clip.skeleton.names])
            worst = max(worst, float(np.linalg.norm(there - positions[frame], axis=-1).max()))
        page.screenshot(path=picture.with_stem(f"{picture.stem}_{number}"))
    print(f"{picture.stem}: {1000.0 * worst:.4f} mm")
    assert worst < 1e-4


def test_a_mannequin_walks_in_a_browser(tmp_path: Path) -> None:
    clip, _ = sample("walk")
    save(clip, tmp_path / "walk.glb")
    with player(tmp_path / "walk.glb") as page:
        check(page, [clip], tmp_path / "walk.png")


@pytest.mark.skipif(not GLTF.exists(), reason="no ../shared/motions")
def test_a_character_of_the_field_plays_two_animations_in_a_browser(tmp_path: Path) -> None:
    walk, run = (load(GLTF / f"viverse_{name}.glb") for name in ("walk", "run"))
    forward = np.linspace(0.0, 1.5, walk.frames)[:, np.newaxis] * [0.0, 0.0, 1.0]
    travelling = walk.evolve(pelvis_positions=walk.pelvis_positions + forward, cyclic=False)
    body = load_skinned(GLTF / "viverse_mannequin.glb")
    save_skinned(body, [travelling, run], tmp_path / "skin.glb")
    with player(tmp_path / "skin.glb") as page:
        check(page, [travelling, run], tmp_path / "skin.png")
