from __future__ import annotations

import numpy as np
import pytest
from tests import walking_figure

from footfall.errors import ArgumentError
from footfall.motion import crop, resample, sample

WALK = walking_figure.walk(frames=34, fps=30.0)
CYCLE = WALK.evolve(cyclic=True)


def test_a_crop_holds_the_frames_between_two_times() -> None:
    part = crop(WALK, 0.1, 0.5)
    np.testing.assert_array_equal(part.pelvis_positions, WALK.pelvis_positions[3:16])
    np.testing.assert_array_equal(part.local_rotations, WALK.local_rotations[3:16])
    assert part.provenance == ("cropped to frames 3 to 15 of 34 (0.100 to 0.500 s)",)


def test_a_crop_of_a_cycle_is_no_cycle() -> None:
    assert not crop(CYCLE, 0.0, 0.5).cyclic


def test_a_crop_of_everything_is_everything() -> None:
    assert crop(WALK, 0.0, WALK.duration).frames == WALK.frames


@pytest.mark.parametrize(
    ("start", "end", "message"),
    [
        (-0.1, 0.5, "clip 'walk': the crop's start is -0.1 s; it must be within 0..1.1 s"),
        (0.1, 1.2, "clip 'walk': the crop's end is 1.2 s; it must be within 0..1.1 s"),
        (
            0.5,
            0.1,
            "clip 'walk': the crop starts at 0.5 s and ends at 0.1 s; it must end after its start",
        ),
        (
            0.51,
            0.52,
            "clip 'walk': no frame lies within 0.51..0.52 s; frames are 0.0333333 s apart",
        ),
        (float("nan"), 1.0, "clip 'walk': the crop's start is nan s; it must be within 0..1.1 s"),
    ],
)
def test_a_crop_outside_the_clip_is_refused(start: float, end: float, message: str) -> None:
    with pytest.raises(ArgumentError) as refusal:
        crop(WALK, start, end)
    assert str(refusal.value) == message


@pytest.mark.parametrize("fps", [24.0, 30.0, 59.94, 60.0, 120.0])
def test_resampling_keeps_the_motion(fps: float) -> None:
    resampled = resample(WALK, fps)
    assert resampled.fps == fps
    assert 0.0 <= WALK.duration - resampled.duration < 1.0 / fps
    times = np.arange(resampled.frames) / fps
    positions, rotations = sample(WALK, times)
    np.testing.assert_allclose(resampled.pelvis_positions, positions, atol=1e-12)
    np.testing.assert_allclose(resampled.local_rotations, rotations, atol=1e-12)


@pytest.mark.parametrize("fps", [24.0, 59.94, 60.0, 100.0])
def test_a_resampled_cycle_keeps_its_ends(fps: float) -> None:
    resampled = resample(CYCLE, fps)
    assert resampled.cyclic
    assert abs(resampled.duration - CYCLE.duration) <= 0.5 / fps + 1e-12
    for end in (0, -1):
        np.testing.assert_allclose(
            resampled.pelvis_positions[end], CYCLE.pelvis_positions[end], atol=1e-12
        )
        np.testing.assert_allclose(
            resampled.local_rotations[end], CYCLE.local_rotations[end], atol=1e-12
        )


def test_there_and_back_is_the_same() -> None:
    back = resample(resample(WALK, 60.0), 30.0)
    np.testing.assert_allclose(back.pelvis_positions, WALK.pelvis_positions, atol=1e-12)
    np.testing.assert_allclose(back.local_rotations, WALK.local_rotations, atol=1e-9)


def test_it_says_what_was_done() -> None:
    assert resample(WALK, 60.0).provenance == ("resampled from 30 to 60 frames per second",)
    assert resample(CYCLE, 24.0).provenance == (
        "resampled from 30 to 24 frames per second, its cycle stretched by -1.52%",
    )


@pytest.mark.parametrize(
    ("fps", "message"),
    [
        (0.0, "clip 'walk': a rate of 0 frames per second; needs > 0"),
        (float("inf"), "clip 'walk': a rate of inf frames per second; needs > 0"),
        (
            0.4,
            "clip 'walk': a cycle of 1.1 s has no frame at 0.4 frames per second; at least "
            "0.909091 are needed",
        ),
    ],
)
def test_an_impossible_rate_is_refused(fps: float, message: str) -> None:
    with pytest.raises(ArgumentError) as refusal:
        resample(CYCLE, fps)
    assert str(refusal.value) == message
