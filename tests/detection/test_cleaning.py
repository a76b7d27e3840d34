from __future__ import annotations

import numpy as np
import pytest
from tests.detection.carried_slip import inner_slips, sharpest

from footfall.detection import clean, clean_and_tell
from footfall.detection.tracks import PlanarStep, points_of_pose
from footfall.motion import Clip
from footfall.samples import sample
from footfall.skeleton import find_anatomy
from footfall.support import SupportSequence


def skating(name: str, fps: int, share: float) -> tuple[Clip, SupportSequence]:
    """Return a sample that travels further than its feet step."""
    clip, supports = sample(name, fps=fps)
    travel = (clip.pelvis_positions[-1] - clip.pelvis_positions[0]) * np.array([1.0, 0.0, 1.0])
    ramp = np.linspace(0.0, share, clip.frames)[:, np.newaxis]
    return clip.evolve(pelvis_positions=clip.pelvis_positions + ramp * travel), supports


WALKS = pytest.mark.parametrize("name", ["walk", "walk-slow", "side-step", "walk-to-hop"])


@WALKS
@pytest.mark.parametrize("fps", [30, 60])
def test_planted_feet_stay_where_they_are(name: str, fps: int) -> None:
    clip, supports = skating(name, fps, 0.06)
    anatomy = find_anatomy(clip.skeleton)
    before = inner_slips(clip, supports, anatomy)
    after = inner_slips(clean(clip, supports), supports, anatomy)
    assert max(before) > 0.015
    assert np.median(after) < 0.25 * np.median(before)
    assert max(after) < 0.008


@WALKS
def test_nothing_pops(name: str) -> None:
    clip, supports = skating(name, 60, 0.06)
    assert sharpest(clean(clip, supports)) < 1.2 * sharpest(clip)


@WALKS
def test_feet_keep_their_turn_and_the_body_above_the_legs_its_pose(name: str) -> None:
    clip, supports = skating(name, 60, 0.06)
    anatomy = find_anatomy(clip.skeleton)
    cleaned = clean_and_tell(clip, supports, anatomy)
    old, _ = clip.world_poses()
    new, positions = cleaned.clip.world_poses()
    legs = {joint for leg in anatomy.legs for joint in (leg.hip, leg.knee)}
    others = [joint for joint in range(clip.skeleton.count) if joint not in legs]
    same = np.abs(np.einsum("tji,tji->tj", old[:, others], new[:, others]))
    np.testing.assert_allclose(same, 1.0, atol=1e-6)
    _, source = clip.world_poses()
    for foot, leg in enumerate(anatomy.legs):
        moved = positions[:, leg.ankle] - source[:, leg.ankle]
        # Beyond reach a leg is softened, by a little.
        assert np.abs(moved - cleaned.foot_offsets[:, foot]).max() < 0.002


def test_a_cycle_stays_one() -> None:
    clip, supports = skating("walk", 60, 0.06)
    cleaned = clean(clip, supports)
    assert cleaned.cyclic
    np.testing.assert_array_equal(cleaned.local_rotations[-1, 1:], cleaned.local_rotations[0, 1:])
    _, positions = cleaned.world_poses()
    np.testing.assert_allclose(PlanarStep.of(cleaned).apply(positions[0]), positions[-1], atol=1e-9)
    # Nothing jumps where it starts over, either.
    last = np.linalg.norm(positions[-1] - positions[-2], axis=-1)
    first = np.linalg.norm(positions[1] - positions[0], axis=-1)
    assert np.abs(last - first).max() < 0.02


@pytest.mark.parametrize("name", ["idle", "punch", "jump"])
def test_a_planted_foot_rests_on_a_level_where_the_floor_drifts(name: str) -> None:
    clip, supports = sample(name, fps=60)
    anatomy = find_anatomy(clip.skeleton)
    waves = np.zeros((clip.frames, 3))
    waves[:, 1] = 0.01 * np.sin(np.linspace(0.0, 2.0 * np.pi, clip.frames))
    uneven = clip.evolve(pelvis_positions=clip.pelvis_positions + waves)
    times = np.arange(clip.frames) / 60.0
    down = np.array([min(supports.support_at(t + d).left for d in (-0.1, 0, 0.1)) for t in times])

    def unevenness(of: Clip) -> float:
        toes = points_of_pose(*of.world_poses(), anatomy)[down, 0, 1, 1]
        return float(np.ptp(toes))

    assert unevenness(uneven) > 0.008
    assert unevenness(clean(uneven, supports)) < 0.35 * unevenness(uneven)


@pytest.mark.parametrize("name", ["idle", "punch", "jump"])
def test_what_stands_still_is_hardly_moved(name: str) -> None:
    clip, supports = sample(name, fps=60)
    told = clean_and_tell(clip, supports)
    assert np.abs(told.foot_offsets).max() < 0.006
    assert np.abs(told.pelvis_offsets).max() < 0.006


def test_a_walk_is_moved_by_no_more_than_its_ankles_roll() -> None:
    clip, supports = sample("walk", fps=60)
    told = clean_and_tell(clip, supports)
    assert np.linalg.norm(told.foot_offsets, axis=-1).max() < 0.02
    assert np.abs(told.pelvis_offsets).max() < 0.005


def test_what_was_done_is_told() -> None:
    clip, supports = skating("walk", 60, 0.06)
    told = clean_and_tell(clip, supports)
    moved = np.linalg.norm(told.foot_offsets, axis=-1)
    assert told.clip.provenance == (*clip.provenance, str(told))
    assert str(told).startswith(
        f"planted feet pinned: feet moved by up to {1000.0 * moved.max():.0f} mm"
    )
    assert clean(clip, supports).provenance == told.clip.provenance


def test_a_clip_in_place_is_pinned_to_its_belt() -> None:
    clip, supports = sample("walk", fps=60)
    travel = (clip.pelvis_positions[-1] - clip.pelvis_positions[0]) * np.array([1.0, 0.0, 1.0])
    ramp = np.linspace(0.0, 1.0, clip.frames)[:, np.newaxis]
    still = clip.evolve(pelvis_positions=clip.pelvis_positions - ramp * travel)
    told = clean_and_tell(still, supports)
    assert np.abs(told.foot_offsets).max() < 0.03
    _, positions = told.clip.world_poses()
    np.testing.assert_allclose(positions[-1, 0], positions[0, 0], atol=1e-9)


def test_flight_without_any_support_changes_nothing() -> None:
    clip, _ = sample("idle", fps=30)
    told = clean_and_tell(clip, SupportSequence.parse(f"-{clip.duration:.6f}*"))
    np.testing.assert_array_equal(told.foot_offsets, 0.0)
    np.testing.assert_allclose(told.clip.local_rotations, clip.local_rotations, atol=1e-12)
