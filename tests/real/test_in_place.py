"""A walk captured in place travels as far as the one it was: its supports take it along."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.detection.test_contacts import in_place

from footfall.detection import detect_supports
from footfall.engine import Character
from footfall.io import load, save
from footfall.motion import Clip
from footfall.samples import sample


def travelled(clip: Clip, seconds: float = 4.0) -> tuple[float, float]:
    """Return how fast a character goes [m/s], and how far the low foot slides a frame [m]."""
    hero = Character(clip.skeleton)
    hero.add("walk", clip, detect_supports(clip))
    hero.start("walk")
    frames = [hero.advance(1 / 60).world_positions.copy() for _ in range(round(seconds * 60))]
    path = np.array(frames)[:, 0, [0, 2]]
    lowest = np.array(frames)[..., 1].argmin(axis=1)
    slides = [
        float(np.linalg.norm((frames[at + 1] - frames[at])[lowest[at], [0, 2]]))
        for at in range(len(frames) - 1)
        if lowest[at] == lowest[at + 1]
    ]
    return float(np.linalg.norm(path[-1] - path[60])) / (seconds - 1.0), float(np.median(slides))


@pytest.mark.full
@pytest.mark.parametrize("name", ["walk", "run"])
def test_a_gltf_clip_in_place_goes_as_fast_as_the_motion_it_was(tmp_path: Path, name: str) -> None:
    clip, _ = sample(name, fps=60)
    save(in_place(clip), tmp_path / "still.glb")
    still = load(tmp_path / "still.glb")
    assert np.ptp(still.pelvis_positions[:, [0, 2]], axis=0).max() < 0.2
    speed, slide = travelled(clip)
    speed_in_place, slide_in_place = travelled(still)
    print(f"{name}: {speed:.2f} m/s, from in place {speed_in_place:.2f} m/s; "
          f"slides {1000.0 * slide:.2f} and {1000.0 * slide_in_place:.2f} mm a frame")  # fmt: skip
    assert speed_in_place == pytest.approx(speed, rel=0.1)
    assert slide_in_place < slide + 0.001
