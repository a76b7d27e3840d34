"""Soles that stay where they are planted."""

from __future__ import annotations

import numpy as np
import pytest

from footfall.arrays import Flags, Positions
from footfall.geometry import from_yaw, rotate
from footfall.motion.sole_planting import (
    BELT,
    MOST_AIR,
    MOST_DEPTH,
    FootPaths,
    cyclic_offsets,
    planted_offsets,
)

FPS = 60.0
FRAMES = 90
STANCE = slice(20, 60)


def carries() -> Flags:
    flags = np.zeros(FRAMES, dtype=np.bool_)
    flags[STANCE] = True
    return flags


def standing(length: float) -> Positions:
    """Return heel and toe of a foot that stands at the origin, shape (frames, 2, 3)."""
    points = np.zeros((FRAMES, 2, 3))
    points[:, 1, 2] = length
    return points


def pivoting(length: float) -> Positions:
    """Return a foot that turns by a radian about its toe while it stands."""
    angles = np.zeros(FRAMES)
    angles[STANCE] = np.linspace(0.0, 1.0, 40)
    angles[60:] = 1.0
    toe = np.array([0.0, 0.0, 0.2])
    heel = toe - rotate(from_yaw(angles), np.array([0.0, 0.0, length]))
    return np.stack([heel, np.broadcast_to(toe, heel.shape)], axis=1)


def test_a_foot_that_stands_still_stays_where_it_is() -> None:
    paths = FootPaths(standing(0.2), standing(0.2), carries())
    np.testing.assert_allclose(planted_offsets(paths, FPS), 0.0, atol=1e-12)


def test_a_foot_that_never_carries_stays_where_it_is() -> None:
    paths = FootPaths(standing(0.2), pivoting(0.1), np.zeros(FRAMES, dtype=np.bool_))
    assert not planted_offsets(paths, FPS).any()


def test_a_longer_foot_pivots_about_its_own_toe() -> None:
    leading, own = pivoting(0.2), pivoting(0.2)
    # As if the middle of the sole had been put where the leader's is.
    own[:, 1] += 0.2 * (own[:, 1] - own[:, 0])
    moved = own + planted_offsets(FootPaths(leading, own, carries()), FPS)[:, np.newaxis]
    inner = moved[25:55, 1, [0, 2]]
    assert np.linalg.norm(own[25:55, 1] - own[25, 1], axis=-1).max() > 0.02
    assert np.linalg.norm(inner - inner[0], axis=-1).max() < 1e-3


def test_feet_on_a_belt_go_with_it() -> None:
    moving = standing(0.2)
    moving[..., 2] -= (2.0 * BELT / FPS * np.arange(FRAMES))[:, np.newaxis]
    paths = FootPaths(moving, moving, carries())
    np.testing.assert_allclose(planted_offsets(paths, FPS), 0.0, atol=1e-9)


@pytest.mark.parametrize("air", [0.03, 0.012, -0.02])
def test_air_under_a_foot_that_carries_is_pressed_out(air: float) -> None:
    own = standing(0.2)
    own[20:30, :, 1] += air
    own[:20, :, 1] += 0.1
    own[60:, :, 1] += 0.1
    moved = own + planted_offsets(FootPaths(own, own, carries()), FPS)[:, np.newaxis]
    low = moved[STANCE, :, 1].min(axis=1)
    assert low.max() <= MOST_AIR + 1e-9
    assert low.min() >= -MOST_DEPTH - abs(min(air, 0.0)) * 0.0 - 0.02
    assert np.abs(np.diff(moved[60:, 0, 1])).max() < 0.03


def test_a_cycle_ends_as_it_begins() -> None:
    yaw, shift = 0.4, np.array([0.1, 0.0, 1.2])
    own = pivoting(0.25)
    own[-1] = rotate(from_yaw(yaw), own[0]) + shift
    leading = pivoting(0.2)
    leading[-1] = rotate(from_yaw(yaw), leading[0]) + shift
    flags = carries()
    flags[-1] = flags[0]
    offsets = cyclic_offsets(FootPaths(leading, own, flags), FPS, yaw, shift)
    np.testing.assert_allclose(offsets[-1], rotate(from_yaw(yaw), offsets[0]), atol=1e-9)
    flags[:] = True
    offsets = cyclic_offsets(FootPaths(leading, own, flags), FPS, yaw, shift)
    np.testing.assert_allclose(offsets[-1], rotate(from_yaw(yaw), offsets[0]), atol=1e-9)
