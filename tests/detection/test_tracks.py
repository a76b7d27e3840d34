from __future__ import annotations

import numpy as np
import pytest

from footfall.detection.tracks import PlanarStep, foot_tracks
from footfall.motion import Clip
from footfall.samples import sample
from footfall.skeleton import find_anatomy


def test_a_step_back_undoes_a_step_on() -> None:
    step = PlanarStep(0.7, 1.0, -2.0)
    points = np.random.default_rng(0).normal(size=(5, 3))
    there = step.apply(points, 3)
    np.testing.assert_allclose(step.apply(there, -3), points, atol=1e-12)
    np.testing.assert_allclose(there[:, 1], points[:, 1])


def test_the_step_of_a_cycle_takes_its_first_pose_to_its_last() -> None:
    clip, _ = sample("walk", fps=30)
    _, positions = clip.world_poses()
    np.testing.assert_allclose(PlanarStep.of(clip).apply(positions[0]), positions[-1], atol=1e-6)


@pytest.mark.parametrize(("fps", "rate"), [(24, 120.0), (30, 120.0), (60, 120.0), (120, 120.0)])
def test_tracks_have_about_the_same_rate_whatever_the_clips(fps: int, rate: float) -> None:
    clip, _ = sample("walk", fps=fps)
    tracks = foot_tracks(clip, find_anatomy(clip.skeleton))
    assert tracks.rate == rate
    assert len(tracks.positions) == (clip.frames - 1) * round(rate / fps)


def test_the_rate_hardly_changes_a_track() -> None:
    fine, _ = sample("kick", fps=120)
    coarse: Clip = fine.evolve(
        pelvis_positions=fine.pelvis_positions[::4],
        local_rotations=fine.local_rotations[::4],
        fps=30.0,
    )
    anatomy = find_anatomy(fine.skeleton)
    one, other = foot_tracks(fine, anatomy), foot_tracks(coarse, anatomy)
    count = len(other.positions)
    assert np.abs(one.positions[:count] - other.positions).max() < 0.02


def test_velocities_are_those_of_the_positions() -> None:
    clip, _ = sample("run", fps=60)
    tracks = foot_tracks(clip, find_anatomy(clip.skeleton))
    central = 0.5 * tracks.rate * (tracks.positions[2:] - tracks.positions[:-2])
    np.testing.assert_allclose(tracks.velocities[1:-1], central, atol=1e-9)
    # The first sample's neighbor to the left is the last one, a cycle back.
    ahead = PlanarStep.of(clip).apply(tracks.positions[0])
    wrapped = 0.5 * tracks.rate * (ahead - tracks.positions[-2])
    np.testing.assert_allclose(tracks.velocities[-1], wrapped, atol=1e-6)
