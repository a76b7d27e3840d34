from __future__ import annotations

import time

import numpy as np
import pytest

from footfall.detection import detect_contacts, detect_supports, planted_intervals
from footfall.errors import ArgumentError
from footfall.geometry import from_yaw, multiply, rotate
from footfall.motion import Clip
from footfall.samples import sample


def moved(clip: Clip, yaw: float, shift: tuple[float, float, float]) -> Clip:
    turn = from_yaw(yaw)
    local = np.array(clip.local_rotations)
    local[:, 0] = multiply(turn, local[:, 0])
    positions = rotate(turn, clip.pelvis_positions) + np.array(shift)
    return clip.evolve(pelvis_positions=positions, local_rotations=local)


def in_place(clip: Clip) -> Clip:
    """Return the clip as a treadmill would have it: without its mean travel."""
    travel = (clip.pelvis_positions[-1] - clip.pelvis_positions[0]) * np.array([1.0, 0.0, 1.0])
    share = np.linspace(0.0, 1.0, clip.frames)[:, np.newaxis]
    return clip.evolve(pelvis_positions=clip.pelvis_positions - share * travel)


@pytest.mark.parametrize("name", ["walk", "run", "kick"])
def test_where_the_body_stands_and_which_way_it_faces_do_not_matter(name: str) -> None:
    clip, _ = sample(name, fps=60)
    one, other = detect_supports(clip), detect_supports(moved(clip, 2.0, (30.0, 1.3, -12.0)))
    assert [p.support for p in one.phases] == [p.support for p in other.phases]
    np.testing.assert_allclose(one.boundaries, other.boundaries, atol=1e-6)


@pytest.mark.parametrize(("name", "speed"), [("walk", 1.3), ("walk-backward", -0.7), ("run", 3.0)])
def test_a_clip_captured_in_place_runs_on_a_belt(name: str, speed: float) -> None:
    clip, _ = sample(name, fps=60)
    still = in_place(clip)
    belt = detect_contacts(still).belt_velocity
    travel = (clip.pelvis_positions[-1] - clip.pelvis_positions[0]) / clip.duration
    assert np.sign(-belt[1]) == np.sign(speed)
    assert belt == pytest.approx((-travel[0], -travel[2]), abs=0.15 * abs(travel[2]))
    assert detect_contacts(clip).belt_velocity == (0.0, 0.0)
    one, other = detect_supports(clip), detect_supports(still)
    assert [p.support for p in one.phases] == [p.support for p in other.phases]
    np.testing.assert_allclose(one.boundaries, other.boundaries, atol=0.035)


def test_a_floor_that_drifts_by_five_centimeters_is_followed() -> None:
    clip, _ = sample("shot", fps=60)
    sink = np.zeros((clip.frames, 3))
    sink[:, 1] = np.linspace(0.0, -0.05, clip.frames)
    drifting = clip.evolve(pelvis_positions=clip.pelvis_positions + sink)
    one, other = detect_supports(clip), detect_supports(drifting)
    assert [p.support for p in one.phases] == [p.support for p in other.phases]
    np.testing.assert_allclose(one.boundaries, other.boundaries, atol=0.04)


def test_the_cycle_may_be_cut_anywhere() -> None:
    clip, supports = sample("walk", fps=60)
    period = clip.frames - 1
    whole = detect_supports(clip)
    for cut in range(1, period, 7):
        rows = np.arange(cut, cut + clip.frames)
        turns, rows = np.divmod(rows, period)
        travel = clip.pelvis_positions[-1] - clip.pelvis_positions[0]
        rolled = clip.evolve(
            pelvis_positions=clip.pelvis_positions[rows] + turns[:, np.newaxis] * travel,
            local_rotations=clip.local_rotations[rows],
        )
        found = detect_supports(rolled)
        assert found.duration == pytest.approx(supports.duration)
        later = sorted((b + cut / 60.0) % whole.duration for b in found.boundaries[:-1])
        first = sorted(b % whole.duration for b in whole.boundaries[:-1])
        np.testing.assert_allclose(later, first, atol=1e-6)


def test_the_papers_two_thresholds_decide_where_they_are_given() -> None:
    clip, _ = sample("walk", fps=60)
    strict = detect_contacts(clip, height=0.02, speed=0.05)
    assert (strict.height_limits == 0.02).all()
    assert (strict.speed_limits == 0.05).all()
    loose = detect_contacts(clip, height=0.05, speed=1.5)
    assert (loose.flags | ~strict.flags).all()
    assert loose.flags.sum() > strict.flags.sum()


def test_everything_is_told_that_was_concluded() -> None:
    clip, supports = sample("walk", fps=60)
    contacts = detect_contacts(clip)
    assert contacts.flags.shape == contacts.heights.shape == contacts.speeds.shape
    assert contacts.flags.shape == (clip.frames, 2)
    assert contacts.ground.shape == (clip.frames, 2, 2)
    assert contacts.heights[contacts.flags].max() < 0.06
    for foot in contacts.intervals:
        assert len(foot) == 1
        assert 0.3 < foot[0].start_confidence <= 1.0
        assert 0.3 < foot[0].end_confidence <= 1.0
    times = np.arange(clip.frames) / 60.0
    true = [[s.left, s.right] for s in map(supports.support_at, times)]
    assert (contacts.flags == np.array(true)).mean() > 0.97


def test_planted_intervals_leave_out_the_edges_that_move() -> None:
    clip, _ = sample("run", fps=120)
    contacts = detect_contacts(clip)
    for foot, planted in enumerate(planted_intervals(clip)):
        assert planted[0].start > contacts.intervals[foot][0].start + 0.01
        assert planted[0].end < contacts.intervals[foot][0].end


@pytest.mark.parametrize("name", ["walk", "run", "kick", "walk-to-hop"])
def test_planted_intervals_lie_within_the_contacts_and_are_still(name: str) -> None:
    clip, _ = sample(name, fps=120)
    contacts = detect_contacts(clip)
    for foot, planted in enumerate(planted_intervals(clip)):
        assert len(planted) == len(contacts.intervals[foot])
        for inner, outer in zip(planted, contacts.intervals[foot], strict=True):
            assert outer.start <= inner.start < inner.end <= outer.end
            assert inner.duration > 0.4 * outer.duration


def test_limits_out_of_range_are_refused() -> None:
    clip, _ = sample("idle", fps=30)
    with pytest.raises(ArgumentError) as raised:
        detect_contacts(clip, height=0.0)
    assert str(raised.value) == "height is 0.0; a limit must be finite and > 0"
    with pytest.raises(ArgumentError) as raised:
        detect_contacts(clip, speed=float("nan"))
    assert str(raised.value) == "speed is nan; a limit must be finite and > 0"
    with pytest.raises(ArgumentError) as raised:
        detect_contacts(clip, min_duration=-1.0)
    assert str(raised.value) == "min_duration is -1.0 s; it must be finite and >= 0"


def test_six_seconds_at_sixty_frames_take_well_under_fifty_milliseconds() -> None:
    clip, _ = sample("walk-to-hop", fps=120)
    clip = clip.evolve(fps=60.0)
    detect_supports(clip)
    seconds: list[float] = []
    for _ in range(5):
        start = time.perf_counter()
        detect_supports(clip)
        seconds.append(time.perf_counter() - start)
    assert clip.duration > 4.0
    assert min(seconds) < 0.05
