"""Cyclic gaits performed.

Feet are laid out first, the pelvis travels over them on harmonics (or, where no foot is down, on
the parabola of free fall), and its mean height is the greatest at which no leg is straighter
than `LONGEST`.
"""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np

from footfall.arrays import Floats, Positions, Seconds
from footfall.geometry import rotate
from footfall.motion import Clip
from footfall.samples.bends import along_arc, headings_at
from footfall.samples.body import SHANK, THIGH
from footfall.samples.curves import GRAVITY, ballistic_speeds, quintic
from footfall.samples.footsteps import FootPath, Stance, Swing, foot_path
from footfall.samples.gait import FreeLeg, Gait, LegCycle, UpperBody
from footfall.samples.performance import Performance, hip_offsets, trunk_rotations
from footfall.support import Support, SupportPhase, SupportSequence, merge_equal_neighbors

__all__ = ["LONGEST", "perform"]

LONGEST = 0.985
"""Greatest extension of a leg, as a share of its length: beyond it a knee would snap."""


def perform(gait: Gait, name: str, fps: float) -> tuple[Clip, SupportSequence]:
    """Return a gait's clip and its exact supports.

    The cycle is made to last a whole number of frames, by less than half a frame.
    """
    frames = max(round(gait.duration * fps), 2)
    gait = replace(gait, duration=frames / fps)
    times = np.arange(frames + 1) / fps
    phases = gait.start + np.linspace(0.0, 1.0, frames + 1)
    supports = _supports(gait)
    if gait.backward:
        phases = phases[::-1]
        supports = SupportSequence(supports.phases[::-1], cyclic=True)
    clip = _performance(gait, phases).clip(times, fps, name=name, cyclic=True)
    return clip, supports


def _events(gait: Gait) -> list[float]:
    """Return the phases at which supports change, from `start` on, and the end of the cycle."""
    edges = [
        (phase - gait.start) % 1.0
        for leg in (gait.left, gait.right)
        if isinstance(leg, LegCycle)
        for phase in (leg.strike, leg.strike + leg.duty)
    ]
    inner = sorted(edge for edge in edges if 1e-9 < edge < 1.0 - 1e-9)
    return [gait.start, *(gait.start + edge for edge in inner), gait.start + 1.0]


def _carries(leg: LegCycle | FreeLeg, phase: float) -> bool:
    return isinstance(leg, LegCycle) and (phase - leg.strike) % 1.0 < leg.duty


def _supports(gait: Gait) -> SupportSequence:
    events = _events(gait)
    phases: list[SupportPhase] = []
    for begin, end in pairwise(events):
        middle = 0.5 * (begin + end)
        support = Support.from_feet(_carries(gait.left, middle), _carries(gait.right, middle))
        phases.append(SupportPhase(support, (end - begin) * gait.duration))
    return SupportSequence(merge_equal_neighbors(phases), cyclic=True)


def _performance(gait: Gait, phases: Floats) -> Performance:
    pelvis = gait.pelvis
    angles = np.radians(
        np.stack([part.at(phases) for part in (pelvis.heading, pelvis.lean, pelvis.tilt)], axis=-1)
    )
    positions = np.stack(
        [
            gait.travel[0] * phases + pelvis.sway.at(phases),
            np.zeros_like(phases),
            gait.travel[1] * phases + pelvis.surge.at(phases),
        ],
        axis=-1,
    )
    headings = headings_at(gait, positions[:, 2])
    angles[:, 0] += headings
    positions = along_arc(gait, positions)
    heights = _heights(gait, phases)
    feet = tuple(
        _stepping(gait, leg, phases, sign) if isinstance(leg, LegCycle) else None
        for leg, sign in ((gait.left, 1.0), (gait.right, -1.0))
    )
    reach = [_highest(positions, angles, foot, index) for index, foot in enumerate(feet) if foot]
    positions[:, 1] = heights + min(float((limit - heights).min()) for limit in reach)
    left, right = (
        foot if foot is not None else _hanging(leg, phases, positions, sign)
        for foot, leg, sign in zip(feet, (gait.left, gait.right), (1.0, -1.0), strict=True)
    )
    chest, head, arms = _upper_body(gait.upper, phases)
    chest[:, 0] += headings
    head[:, 0] += headings
    return Performance(positions, angles, chest, head, arms, (left, right))


def _upper_body(upper: UpperBody, phases: Floats) -> tuple[Floats, Floats, Floats]:
    chest = np.radians(np.stack([part.at(phases) for part in upper.chest], axis=-1))
    head = np.radians(np.stack([part.at(phases) for part in upper.head], axis=-1))
    left = np.stack([part.at(phases) for part in upper.left_arm], axis=-1)
    if upper.right_arm is None:
        right = np.stack([part.at(phases + 0.5) for part in upper.left_arm], axis=-1)
    else:
        right = np.stack([part.at(phases) for part in upper.right_arm], axis=-1)
    return chest, head, np.radians(np.stack([left, right], axis=1))


def _stepping(gait: Gait, leg: LegCycle, phases: Floats, sign: float) -> FootPath:
    """Return a stepping foot's path; cycles before and after are laid out too."""
    stance_seconds = leg.duty * gait.duration

    def stance(cycle: int) -> Stance:
        strike = leg.strike + cycle
        x, z = (go * strike + ball for go, ball in zip(gait.travel, leg.ball, strict=True))
        return Stance(
            strike * gait.duration,
            strike * gait.duration + stance_seconds,
            _bent(gait, x, z),
            heading=sign * math.radians(leg.toe_out) + float(headings_at(gait, np.array(z))),
            strike_pitch=math.radians(leg.strike_pitch),
            leave_pitch=math.radians(leg.leave_pitch),
            flat=leg.flat * stance_seconds,
            rise=leg.rise * stance_seconds,
        )

    pitch = tuple((share, math.radians(degrees)) for share, degrees in leg.pitch)
    times: Seconds = phases * gait.duration
    stances = [stance(cycle) for cycle in range(-2, 4)]
    swings = [Swing(leg.clearance, pitch, _waypoints(gait, leg, cycle)) for cycle in range(-2, 3)]
    return foot_path(times, stances, swings)


def _waypoints(gait: Gait, leg: LegCycle, cycle: int) -> tuple[tuple[float, float, float], ...]:
    """Return the places that a foot passes after the stance of a cycle, as of `Swing.path`."""
    found: list[tuple[float, float, float]] = []
    for share, way in leg.progress:
        gone = leg.strike + cycle + way
        x, z = (go * gone + ball for go, ball in zip(gait.travel, leg.ball, strict=True))
        found.append((share, *_bent(gait, x, z)))
    return tuple(found)


def _bent(gait: Gait, x: float, z: float) -> tuple[float, float]:
    place = along_arc(gait, np.array([x, 0.0, z]))
    return float(place[0]), float(place[2])


def _hanging(leg: LegCycle | FreeLeg, phases: Floats, pelvis: Positions, sign: float) -> FootPath:
    assert isinstance(leg, FreeLeg)
    offsets = np.stack(
        [np.full_like(phases, 0.1 * sign), leg.height.at(phases), leg.forward.at(phases)], axis=-1
    )
    pitch = np.radians(leg.pitch.at(phases))
    return FootPath(pelvis + offsets, np.stack([np.zeros_like(pitch), pitch, 0.0 * pitch], axis=-1))


def _highest(pelvis: Positions, angles: Floats, foot: FootPath, index: int) -> Floats:
    """Return the pelvis heights at which this leg is as straight as it may be, shape (times,)."""
    hips = pelvis + rotate(trunk_rotations(angles), hip_offsets()[index])
    apart = foot.ankles - hips
    ground = apart[:, 0] ** 2 + apart[:, 2] ** 2
    room = (LONGEST * (THIGH + SHANK)) ** 2 - ground
    return foot.ankles[:, 1] + np.sqrt(np.maximum(room, 0.0)) - (hips - pelvis)[:, 1]


def _heights(gait: Gait, phases: Floats) -> Floats:
    """Return the pelvis height up to a constant: harmonic, or bounces between parabolas."""
    supports = _supports(gait)
    if all(phase.support is not Support.FLIGHT for phase in supports.phases):
        return gait.pelvis.height.at(phases)
    knots: list[tuple[float, float, float, float]] = []
    for cycle in (-1, 0, 1, 2):
        bounds = np.array(supports.boundaries) + (gait.start + cycle) * gait.duration
        for phase, begin in zip(supports.phases, bounds, strict=False):
            if phase.support is Support.FLIGHT:
                up, down = ballistic_speeds(-gait.pelvis.drop, phase.duration)
                knots.append((float(begin), gait.pelvis.drop, up, -GRAVITY))
                knots.append((float(begin) + phase.duration, 0.0, down, -GRAVITY))
    return quintic(phases * gait.duration, knots)
