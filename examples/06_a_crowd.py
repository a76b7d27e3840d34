"""Sixty characters that share three gaits, advanced in one call.

The picture is their ways from above, colored by how fast they go; a black
dot is where one of them is at the end.
"""

import sys
from pathlib import Path

import numpy as np

import footfall as ff
from footfall.view.svg import Picture

PACES = (0.4, 1.58, 2.6, 99.0)
NAMES = ("stands", "walks", "walks fast", "runs")
COLORS, MIDDLE, EVERY = ("#9aa4b0", "#2f6db5", "#3a9a5b", "#d8741a"), 480.0, 8


def main(folder: Path) -> None:
    """Let them go, and write the picture."""
    library = ff.MotionLibrary()
    for name in ("walk", "walk-fast", "run"):
        library.add(name, *ff.sample(name))
    crowd = ff.Crowd(library, 60)
    dice = np.random.default_rng(7)
    for row in range(crowd.size):
        crowd.place(dice.uniform(-6.0, 6.0, 2), dice.uniform(-np.pi, np.pi), [row])

    ways: list[np.ndarray] = []
    for frame in range(480):
        if frame % 40 == 0:
            some = dice.permutation(crowd.size)[:25]
            crowd.start(int(dice.integers(3)), some)
            crowd.stop(int(dice.integers(3)), some)
        crowd.advance(1 / 60)
        ways.append(crowd.world_positions[:, 0, ::2].copy())

    picture = Picture("crowd", "Sixty characters from above", 2 * MIDDLE, 2 * MIDDLE)
    scale = (MIDDLE - 16) / np.abs(ways).max()
    for way in np.stack(ways, axis=1)[:, ::EVERY]:
        _draw(picture, scale * way, way)
    for row, (name, color) in enumerate(zip(NAMES, COLORS, strict=True)):
        picture.line(24, 30 + 24 * row, 60, 30 + 24 * row, stroke=color, stroke_width=4)
        picture.words(70, 35 + 24 * row, name, size=15)
    (folder / "06_a_crowd.svg").write_text(picture.to_svg(), encoding="utf-8")


def _draw(picture: Picture, drawn: np.ndarray, way: np.ndarray) -> None:
    places = [(MIDDLE + x, MIDDLE - z) for x, z in drawn.tolist()]
    speeds: list[float] = (np.linalg.norm(np.diff(way, axis=0), axis=1) * 60 / EVERY).tolist()
    for start, speed in enumerate(speeds):
        pace = int(np.searchsorted(PACES, speed))
        picture.path(places[start : start + 2], stroke=COLORS[pace], stroke_width=2.5)
    picture.add("circle", cx=places[0][0], cy=places[0][1], r=3, class_="ink", opacity=0.35)
    picture.add("circle", cx=places[-1][0], cy=places[-1][1], r=5, class_="ink")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
