from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.arrays import Floats
from footfall.report import skating_ratio, weighted_skate


def formula(places: Floats, heights: Floats, limit: float) -> float:
    """Evaluate (1000 / T) Σ d (2 − 2^(h / H)) over h < H as it is written."""
    total = 0.0
    for frame in range(len(places) - 1):
        height = heights[frame]
        if height < limit:
            step = np.hypot(*(places[frame + 1] - places[frame]))
            total += step * (2.0 - 2.0 ** (height / limit))
    return 1000.0 / len(places) * total


@settings(deadline=None, max_examples=30)
@given(st.integers(1, 30), st.integers(0, 2**32 - 1))
def test_the_weighted_skate_is_its_formula(frames: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    ankles, toes = random.normal(size=(2, frames, 2, 2))
    ankle_heights, toe_heights = random.uniform(-0.05, 0.15, size=(2, frames, 2))
    expected = [formula(ankles[:, foot], ankle_heights[:, foot], 0.08) for foot in range(2)]
    expected += [formula(toes[:, foot], toe_heights[:, foot], 0.04) for foot in range(2)]
    found = weighted_skate(ankles, ankle_heights, toes, toe_heights)
    assert found == pytest.approx(np.mean(expected))


def test_joints_over_their_heights_do_not_count() -> None:
    way = np.random.default_rng(1).normal(size=(10, 2, 2))
    high = np.full((10, 2), 0.08)
    assert weighted_skate(way, high, way, high / 2) == 0.0


def toes_at(speeds: list[float]) -> Floats:
    """Return both toes, the left one moving this fast [m/s] from frame to frame at 20 fps."""
    places = np.zeros((len(speeds) + 1, 2, 2))
    places[1:, 0, 1] = np.cumsum(speeds) / 20.0
    return places


def ratio(speeds: list[float], height: float = 0.0) -> float | None:
    return skating_ratio(toes_at(speeds), np.full((len(speeds) + 1, 2), height), 20.0)


def test_a_toe_that_skates_fast_enough_skates_in_every_frame() -> None:
    assert ratio([1.0] * 10) == 1.0


def test_a_toe_at_the_limit_of_speed_or_height_does_not_skate() -> None:
    assert ratio([0.4999] * 10) == 0.0
    assert ratio([1.0] * 10, height=0.05) == 0.0


def test_a_single_fast_frame_does_not_skate() -> None:
    assert ratio([0.0] * 5 + [2.0] + [0.0] * 5) == 0.0


def test_two_very_fast_frames_do() -> None:
    assert ratio([0.0] * 4 + [2.0, 2.0] + [0.0] * 4) == pytest.approx(0.2)


def test_a_toe_must_be_low_in_both_of_two_frames() -> None:
    heights = np.zeros((11, 2))
    heights[5] = 0.1
    assert skating_ratio(toes_at([1.0] * 10), heights, 20.0) == pytest.approx(0.8)


def test_a_frame_counts_once_however_many_feet_skate() -> None:
    both = toes_at([1.0] * 10)
    both[:, 1] = both[:, 0]
    assert skating_ratio(both, np.zeros((11, 2)), 20.0) == 1.0


def test_a_single_frame_has_no_ratio() -> None:
    assert ratio([]) is None
