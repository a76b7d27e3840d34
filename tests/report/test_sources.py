from __future__ import annotations

import math

import numpy as np
import pytest
from tests.report.bodies import ANATOMY, FOOT_LENGTH, HEEL, LEFT

from footfall.arrays import Positions
from footfall.geometry import from_yaw
from footfall.motion import Clip
from footfall.motion.soles import HEEL_SHARE
from footfall.report import SourceSlips, Track, clip_trace, mean_source_slips, measure_spans
from footfall.skeleton import Skeleton
from footfall.support import SupportSequence

OFFSETS = np.array(
    [
        [0.0, 0.0, 0.0],
        *([[0.1, 0.0, 0.0], [0.0, -0.4, 0.0], [0.0, -0.4, 0.0], [0.0, 0.0, 0.2]]),
        *([[-0.1, 0.0, 0.0], [0.0, -0.4, 0.0], [0.0, -0.4, 0.0], [0.0, 0.0, 0.2]]),
    ]
)
NAMES = ("Hips", "LHip", "LKnee", "LAnkle", "LToe", "RHip", "RKnee", "RAnkle", "RToe")
SKELETON = Skeleton(NAMES, np.array([-1, 0, 1, 2, 3, 0, 5, 6, 7]), OFFSETS)


def gliding(way: Positions, yaw: float = 0.0, *, cyclic: bool = False, fps: float = 60.0) -> Clip:
    """Return a stiff body whose pelvis is there in each frame, turning evenly to `yaw`."""
    frames = len(way)
    rotations = np.tile([1.0, 0.0, 0.0, 0.0], (frames, 9, 1))
    rotations[:, 0] = from_yaw(np.linspace(0.0, yaw, frames))
    return Clip(SKELETON, way + np.array([0.0, 0.8, 0.0]), rotations, fps, cyclic)


def straight(frames: int, speed: float, fps: float = 60.0) -> Positions:
    way = np.zeros((frames, 3))
    way[:, 2] = speed * np.arange(frames) / fps
    return way


def test_a_clip_has_the_slip_of_its_spans_in_their_frames_and_none_elsewhere() -> None:
    clip = gliding(straight(61, 0.3))
    slips = SourceSlips.of(clip, ANATOMY, SupportSequence.parse("L.5 -.5"))
    inside, outside = slips.at(np.array([0.0, 0.25, 0.49])), slips.at(np.array([0.51, 1.0, 9.0]))
    # 30 frames without 4 at each end: 21 steps of 5 mm.
    assert inside[:, LEFT] == pytest.approx(0.105)
    assert np.isnan(inside[:, 1]).all()
    assert np.isnan(outside).all()


def test_a_span_that_is_all_edges_slips_by_nothing() -> None:
    clip = gliding(straight(61, 0.3))
    slips = SourceSlips.of(clip, ANATOMY, SupportSequence.parse("L.1 -.9"))
    assert slips.at(np.array([0.05]))[0, LEFT] == 0.0


def test_a_span_across_the_end_of_a_cycle_is_whole() -> None:
    clip = gliding(straight(61, 0.3), cyclic=True)
    cut = SupportSequence(SupportSequence.parse("L.5 -.5*").phases, cyclic=True, start=-0.25)
    slips = SourceSlips.of(clip, ANATOMY, cut)
    assert slips.at(np.array([0.1, 0.9, 1.1, 7.95]))[:, LEFT] == pytest.approx(0.105)
    assert np.isnan(slips.at(np.array([0.3, 0.7, 5.5]))).all()


@pytest.mark.parametrize("yaw", [0.0, 0.4, -1.5, math.pi / 2])
def test_a_cycle_goes_on_where_it_ended_and_slides_alike_each_time(yaw: float) -> None:
    angles = np.linspace(0.0, yaw, 61)
    way = np.cumsum(np.stack([np.sin(angles), 0.0 * angles, np.cos(angles)], axis=-1), axis=0)
    clip = gliding(0.01 * way + 3.0, yaw, cyclic=True)
    trace = clip_trace(clip, ANATOMY, SupportSequence.parse("L.5 -.5*"), cycles=3)
    assert trace.frames == 181
    assert np.abs(np.diff(trace.positions, n=2, axis=0)).max() < 0.02
    assert np.abs(trace.rotations[[60, 120, 180], 0] @ from_yaw(yaw)) == pytest.approx(
        np.abs(np.cos([0.0, 0.5 * yaw, yaw]))
    )
    slips = [measure.inner_slip for measure in measure_spans(Track.from_trace(trace))]
    assert slips[1:3] == pytest.approx([slips[0], slips[0]])


def test_a_clip_as_a_trace_keeps_its_poses_and_its_supports() -> None:
    clip = gliding(straight(31, 0.5, fps=30.0), fps=30.0)
    trace = clip_trace(clip, ANATOMY, SupportSequence.parse("L.5 D.5"))
    assert trace.fps == 30.0
    assert (trace.positions == clip.world_poses()[1]).all()
    # The ankle is at z = 0.5 at the end, and the heel on the sole behind it.
    behind = HEEL_SHARE * FOOT_LENGTH
    assert Track.from_trace(trace).points[-1, LEFT, HEEL] == pytest.approx([0.1, 0.0, 0.5 - behind])


def slips_of(left: float) -> SourceSlips:
    by_frame = np.full((61, 2), np.nan)
    by_frame[:, LEFT] = left
    return SourceSlips(by_frame, 1.0, cyclic=False)


def test_the_mean_is_by_weight_over_the_sources_that_stand_there() -> None:
    sources = [slips_of(0.010), slips_of(0.030), slips_of(math.nan)]
    times = np.full((2, 3), 0.5)
    shares = np.array([[0.25, 0.25, 0.5], [0.0, 0.4, 0.6]])
    found = mean_source_slips(sources, times, shares)
    assert found[:, LEFT] == pytest.approx([0.020, 0.030])
    assert np.isnan(found[:, 1]).all()
