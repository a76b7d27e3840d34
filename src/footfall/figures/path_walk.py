"""A character that follows a straight and a curved path whatever it faces: that of figure 15."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from footfall.arrays import Floats
from footfall.detection import clean
from footfall.engine import Character, Recorder
from footfall.engine.recording import Recording
from footfall.figures.cast import Cast
from footfall.geometry import from_yaw, multiply, rotate
from footfall.motion import extract_root_path, mirror, with_soles
from footfall.report import MethodReport, Trace, measure, recording_trace
from footfall.scenario.motions import Motion
from footfall.skeleton import find_anatomy
from footfall.support import SupportSequence

__all__ = ["OTHER_SIDE", "ROLES", "PathWalk", "follow_curve", "walk_and_turn"]

ROLES = ("walk", "side step", "back walk")

OTHER_SIDE = "side step, mirrored"
"""What a curved path takes besides."""

FPS = 60.0
LINE = ((0.0, 0.0), (0.0, 1.2), (0.0, 5.5), (0.0, 7.5))
FACINGS = (0.0, 0.0, -math.pi, -math.pi)
"""Where it faces at each of the points: it turns to its right, so that it comes to go to its left,
and goes back at last [rad]."""

LONGEST = 60.0
"""How long a walk may last [s]."""


@dataclass(frozen=True, eq=False)
class PathWalk:
    """What the character did, as it is measured."""

    recording: Recording
    trace: Trace
    report: MethodReport

    path: Floats
    """The points that it was sent along, x and z [m], shape (points, 2)."""

    headings: Floats
    """Where its root faced [rad], 0 along +z, shape (frames,)."""

    roots: Floats
    """Where it was, x and z [m], shape (frames, 2)."""

    away: Floats
    """How far its root was off the path, to the left [m], shape (frames,)."""


@lru_cache(maxsize=2)
def walk_and_turn(cast: Cast) -> PathWalk:
    """Let a character go straight on while it turns by half a turn."""
    hero = _hero(cast)
    return _followed(hero, np.array(LINE), facing=np.array(FACINGS))


@lru_cache(maxsize=2)
def follow_curve(cast: Cast) -> PathWalk:
    """Let a character go round most of a circle, always facing the same way."""
    angles = np.linspace(0.0, math.radians(300.0), 61)
    path = 1.6 * np.column_stack([np.cos(angles) - 1.0, np.sin(angles)])
    return _followed(_hero(cast, both_sides=True), path, heading=np.zeros(len(path)))


def _hero(cast: Cast, *, both_sides: bool = False) -> Character:
    hero = Character(cast.motion("walk").clip.skeleton)
    parts = {role: _straight(cast.motion(role)) for role in ROLES}
    if both_sides:
        parts[OTHER_SIDE] = _mirrored(parts["side step"])
    for name, part in parts.items():
        hero.add(name, part.clip, part.supports, fade_in=0.4, fade_out=0.4)
    return hero


def _followed(
    hero: Character, path: Floats, *, facing: Floats | None = None, heading: Floats | None = None
) -> PathWalk:
    follower = hero.follow(path, facing=facing, heading=heading)
    recorder = Recorder(hero, FPS)
    hero.advance(0.0)
    rows: list[tuple[float, float, float, float]] = []
    while not follower.done and len(rows) < LONGEST * FPS:
        recorder.keep()
        rows.append((*hero.root, follower.away))
        hero.advance(1.0 / FPS)
    recording = recorder.finish()
    walk = hero.library.actions[0].clip
    anatomy = with_soles(find_anatomy(walk.skeleton), *walk.world_poses())
    trace = recording_trace(recording, anatomy)
    track = np.array(rows)
    return PathWalk(recording, trace, measure(trace), path, track[:, 2], track[:, :2], track[:, 3])


def _straight(motion: Motion) -> Motion:
    """Return a motion that goes straight on, its planted feet pinned, if it turns on its way."""
    clip = motion.clip
    turn = extract_root_path(clip, find_anatomy(clip.skeleton)).displacement[2]
    if abs(turn) < 1e-3:
        return motion
    yaws: Floats = -turn * np.arange(clip.frames, dtype=np.float64) / (clip.frames - 1)
    halfway: Floats = 0.5 * (yaws[1:] + yaws[:-1])
    bent = rotate(from_yaw(halfway), np.diff(clip.pelvis_positions, axis=0))
    positions = clip.pelvis_positions[0] + np.concatenate([np.zeros((1, 3)), bent.cumsum(axis=0)])
    rotations = np.array(clip.local_rotations)
    rotations[:, 0] = multiply(from_yaw(yaws), rotations[:, 0])
    straight = clip.evolve(
        pelvis_positions=positions, local_rotations=rotations, because="made to go straight on"
    )
    return Motion(clean(straight, motion.supports), motion.supports)


def _mirrored(motion: Motion) -> Motion:
    swapped = str(motion.supports).translate(str.maketrans("LR", "RL"))
    clip = mirror(motion.clip, find_anatomy(motion.clip.skeleton))
    return Motion(clip, SupportSequence.parse(swapped))
