"""The motions of the figures as files that play: GLB, and pages for the paper's two videos."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from footfall.engine.recording import Recording
from footfall.figures.cast import Cast
from footfall.figures.changing_ground import FPS, walk_on_hills
from footfall.figures.comparison import comparison_performances
from footfall.figures.delays import delays_performances
from footfall.figures.ground_scene import with_ground
from footfall.figures.path_walk import walk_and_turn
from footfall.figures.performing import Cues, perform_cues
from footfall.io import save_gltf, write_atomically
from footfall.report import measure, performance_trace
from footfall.scenario.performance import Performance, support_text
from footfall.view import DemoPage, performance_timeline, write_demo_page

__all__ = ["ANIMATIONS", "write_animations"]

ANIMATIONS = {
    "figure_15_linear_path.glb": "the character of figure 15",
    "figure_16_changing_ground.glb": "the cues of figure 16 on a ground that changes",
    "figure_17_comparison_without.glb": "figure 17, first row",
    "figure_17_comparison_with.glb": "figure 17, second row",
    "figure_18_delays_without.glb": "figure 18, first row",
    "figure_18_delays_paper.glb": "figure 18, second row",
    "figure_18_delays_with.glb": "figure 18, third row",
    "synchronization.glb": "the result of the page of this name",
    "synchronization.html": "the paper's video: two motions, and their synchronized blend",
    "hopping.glb": "the result of the page of this name",
    "hopping.html": "the paper's video: a walk synchronized with hops on the right foot",
}
"""Every file that is written, and what it shows."""

VIDEOS: dict[str, tuple[tuple[str, str], Cues, str]] = {
    "synchronization": (
        ("walk", "run"),
        ((0.0, "start", "walk"), (1.31, "start", "run")),
        "The original motions, and the result of their synchronization and their blending: from "
        "1.3 s on walk and run are mixed, their supports agree, and planted feet hold.",
    ),
    "hopping": (
        ("walk", "right hop"),
        (
            (0.0, "start", "walk"),
            (1.9, "start", "right hop"),
            (4.6, "stop", "right hop"),
            (6.1, "start", "right hop"),
        ),
        "A walk synchronized automatically with hops on the right foot, which start and stop at "
        "arbitrary moments.",
    ),
}
"""The two parts, the cues, and what the page says."""

SECONDS = 8.0
"""How long the videos last."""


def write_animations(folder: Path, cast: Cast) -> None:
    """Write all of `ANIMATIONS` into a folder.

    Raises:
        FileFormatError: If one cannot be written.
    """
    _save(walk_and_turn(cast).recording, folder / "figure_15_linear_path.glb")
    _save_with_ground(folder / "figure_16_changing_ground.glb", cast)
    for stem, takes, performances in (
        ("figure_17_comparison", ("without", "with"), comparison_performances(cast)),
        ("figure_18_delays", ("without", "paper", "with"), delays_performances(cast)),
    ):
        for take, performance in zip(takes, performances, strict=True):
            _save_performance(performance, folder / f"{stem}_{take}.glb")
    for name in VIDEOS:
        _write_video(folder, name, cast)


def _save(recording: Recording, path: Path) -> None:
    save_gltf(recording.to_clip(path.stem), path, supports=recording.support_text)


def _save_performance(performance: Performance, path: Path) -> None:
    clip = performance.recording.to_clip(path.stem)
    save_gltf(clip, path, supports=support_text(performance.supports))


def _save_with_ground(path: Path, cast: Cast) -> None:
    walked = walk_on_hills(cast, moving=True)
    _save(walked.recording, path)
    times = np.arange(walked.recording.frames) / FPS
    weights = np.array([walked.hills.weights(float(time)) for time in times])
    scene = with_ground(path.read_bytes(), walked.hills.patterns, weights, times, walked.hills.grid)
    write_atomically(path, scene)


def _write_video(folder: Path, name: str, cast: Cast) -> None:
    """Write a page with the original motions and their blend, and the blend as GLB."""
    roles, cues, told = VIDEOS[name]
    alone = [perform_cues(cast, ((0.0, "start", role),), SECONDS) for role in roles]
    blended = perform_cues(cast, cues, SECONDS)
    faded = perform_cues(cast, cues, SECONDS, synchronized=False, footprints=False)
    _save_performance(blended, folder / f"{name}.glb")
    takes = tuple(
        (title, performance_trace(performance))
        for title, performance in zip(
            (*(f"The original {role}" for role in roles), "Synchronized and blended"),
            (*alone, blended),
            strict=True,
        )
    )
    page = DemoPage(
        title=name.capitalize(),
        introduction=told,
        takes=takes,
        skeleton=blended.recording.skeleton,
        timeline=performance_timeline(blended),
        reports={
            "cross-fade": measure(performance_trace(faded)),
            "footfall": measure(takes[-1][1]),
        },
    )
    write_demo_page(folder / f"{name}.html", page)
