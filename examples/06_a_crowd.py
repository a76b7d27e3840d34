"""Sixty characters that share three gaits, advanced in one call.

The picture is their ways from above, each in its own color.
"""

import sys
from pathlib import Path

import numpy as np

import footfall as ff

COLORS = ("#2f6db5", "#e08a1e", "#3a9a5b", "#b5432f", "#7a56a8")


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

    lines = [_polyline(way, row) for row, way in enumerate(np.stack(ways, axis=1))]
    picture = (
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="-18 -18 36 36" width="900" '
        f'height="900"><rect x="-18" y="-18" width="36" height="36" fill="#fff"/>'
        f"{''.join(lines)}</svg>"
    )
    (folder / "06_a_crowd.svg").write_text(picture, encoding="utf-8")


def _polyline(way: np.ndarray, row: int) -> str:
    points = " ".join(f"{x:.2f},{z:.2f}" for x, z in way[::6])
    color = COLORS[row % len(COLORS)]
    return f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="0.06"/>'


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
