"""The fixed rules say what they say."""

from __future__ import annotations

import numpy as np
import pytest

from footfall.baselines import (
    FIXED_RULES,
    displacement_contacts,
    height_and_speed_contacts,
    speed_contacts,
)
from footfall.motion import Clip
from footfall.samples import sample


def gliding(speed: float, height: float = 0.0) -> Clip:
    """Return a standing body that glides [m/s], the second half of the time lifted [m]."""
    clip, _ = sample("idle", fps=50)
    frames = np.arange(100)
    positions = np.repeat(clip.pelvis_positions[:1], 100, axis=0)
    positions[:, 2] += frames * speed / 50.0
    positions[50:, 1] += height
    rotations = np.repeat(clip.local_rotations[:1], 100, axis=0)
    return Clip(clip.skeleton, positions, rotations, 50.0)


@pytest.mark.parametrize(("speed", "down"), [(0.149, True), (0.151, False)])
def test_slow_is_down(speed: float, down: bool) -> None:
    assert (speed_contacts(gliding(speed)) == down).all()


@pytest.mark.parametrize(("speed", "down"), [(0.099, True), (0.101, False)])
def test_slow_and_low_is_down(speed: float, down: bool) -> None:
    flags = height_and_speed_contacts(gliding(speed, 0.2))
    assert (flags[:50] == down).all()
    assert not flags[50:].any()


@pytest.mark.parametrize(("step", "down"), [(0.0447, True), (0.0448, False)])
def test_a_small_step_is_down_whatever_time_it_takes(step: float, down: bool) -> None:
    assert (displacement_contacts(gliding(step * 50.0)) == down).all()


@pytest.mark.parametrize("rule", FIXED_RULES)
def test_every_rule_answers_for_each_frame_and_foot(rule: str) -> None:
    clip, _ = sample("walk")
    flags = FIXED_RULES[rule](clip)
    assert flags.shape == (clip.frames, 2)
    assert flags.dtype == np.bool_
