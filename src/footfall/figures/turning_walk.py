"""A character that is kept on a straight line while it turns: the motion of figure 15."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from footfall.arrays import Floats
from footfall.detection import clean
from footfall.engine import Character, Recorder
from footfall.engine.recording import Recording
from footfall.figures.cast import Cast
from footfall.geometry import from_yaw, multiply, rotate
from footfall.motion import extract_root_path, with_soles
from footfall.report import MethodReport, Trace, measure, recording_trace
from footfall.scenario.motions import Motion
from footfall.skeleton import find_anatomy

__all__ = ["ROLES", "TurningWalk", "turned", "walk_and_turn"]

ROLES = ("walk", "side step", "back walk")
FPS = 60.0
TURNING = math.radians(-20.0)
"""How fast the character turns [rad/s]: to its right, so that it comes to go to its left."""

BEFORE, AFTER = 1.2, 2.0
"""How long it walks straight on before it begins to turn, and back once it has turned [s]."""

REACH = 0.9
"""How far ahead on the line it aims [m]."""

STARTS, ENDS = 0.06, 0.03
"""Share from which a motion is started, and below which it is stopped."""


@dataclass(frozen=True, eq=False)
class TurningWalk:
    """What the character did, as it is measured."""

    recording: Recording
    trace: Trace
    report: MethodReport

    headings: Floats
    """Where its root faced [rad], 0 along the line, shape (frames,)."""

    roots: Floats
    """Where it was, across and along the line [m], shape (frames, 2)."""


def turned(motion: Motion, rate: float) -> Motion:
    """Return a motion whose body turns evenly on its way, its planted feet pinned.

    Args:
        motion: The motion.
        rate: How fast it turns then [rad/s], whatever it did before.
    """
    clip = motion.clip
    own = extract_root_path(clip, find_anatomy(clip.skeleton)).displacement[2] / clip.duration
    if abs(rate - own) < 1e-6:
        return motion
    yaws: Floats = (rate - own) * np.arange(clip.frames, dtype=np.float64) / clip.fps
    halfway: Floats = 0.5 * (yaws[1:] + yaws[:-1])
    steps = np.diff(clip.pelvis_positions, axis=0)
    bent = rotate(from_yaw(halfway), steps)
    positions = clip.pelvis_positions[0] + np.concatenate([np.zeros((1, 3)), bent.cumsum(axis=0)])
    rotations = np.array(clip.local_rotations)
    rotations[:, 0] = multiply(from_yaw(yaws), rotations[:, 0])
    told = f"turned by {math.degrees(rate):g} degrees per second"
    curved = clip.evolve(pelvis_positions=positions, local_rotations=rotations, because=told)
    return Motion(clean(curved, motion.supports), motion.supports)


@lru_cache(maxsize=2)
def walk_and_turn(cast: Cast) -> TurningWalk:
    """Let a character go straight on while it turns by half a turn.

    Its walk, side step and back walk are mixed so that it goes where it should, whatever it faces;
    priorities are set anew in each frame.
    """
    walk = cast.motion("walk").clip
    hero = Character(walk.skeleton)
    velocities = np.array([_velocity(turned(cast.motion(role), 0.0)) for role in ROLES])
    for role in ROLES:
        for name, rate in ((role, 0.0), (f"{role}, turning", TURNING)):
            shown = turned(cast.motion(role), rate)
            hero.add(name, shown.clip, shown.supports, fade_in=0.4, fade_out=0.4)
    recorder = Recorder(hero, FPS)
    hero.start("walk")
    hero.advance(0.0)
    rows: list[tuple[float, float, float]] = []
    lasting = BEFORE + AFTER + math.pi / abs(TURNING)
    for frame in range(int(lasting * FPS) + 1):
        if frame > 0:
            hero.advance(1.0 / FPS)
        root: Any = hero.crowd.characters["root"][0]
        x, z, heading = (float(value) for value in root)
        rows.append((x, z, heading))
        turning = frame / FPS >= BEFORE and heading > -math.pi + 0.06
        aim = math.atan2(-x, REACH) - heading
        _steer(hero, _shares(velocities, aim), turning=turning)
        recorder.keep()
    recording = recorder.finish()
    anatomy = with_soles(find_anatomy(walk.skeleton), *walk.world_poses())
    trace = recording_trace(recording, anatomy)
    track = np.array(rows)
    return TurningWalk(recording, trace, measure(trace), track[:, 2], track[:, :2])


def _velocity(motion: Motion) -> tuple[float, float]:
    """Return how fast a motion goes to its left and ahead [m/s]."""
    path = extract_root_path(motion.clip, find_anatomy(motion.clip.skeleton))
    x, z, _ = path.displacement
    return x / motion.clip.duration, z / motion.clip.duration


def _shares(velocities: Floats, aim: float) -> Floats:
    """Return the shares of the parts whose mean goes towards a direction [rad], 0 ahead.

    Of the side step and one of the walks, whichever pair gets there faster; where none does, of
    the one that comes nearest.
    """
    wanted = np.array([math.sin(aim), math.cos(aim)])
    best: Floats | None = None
    for straight in (0, 2):
        pair = velocities[[straight, 1]].T
        if abs(float(np.linalg.det(pair))) < 1e-6:
            continue
        parts = np.linalg.solve(pair, wanted)
        if parts.min() >= 0.0 and (best is None or parts.sum() < best.sum()):
            best = np.zeros(len(ROLES))
            best[[straight, 1]] = parts
    if best is None:
        speeds = np.linalg.norm(velocities, axis=1)
        best = np.zeros(len(ROLES))
        best[int((velocities @ wanted / np.maximum(speeds, 1e-9)).argmax())] = 1.0
    return best / best.sum()


def _steer(hero: Character, shares: Floats, *, turning: bool) -> None:
    """Start, stop and weigh the parts, those that turn or those that do not."""
    for role, share in zip(ROLES, shares.tolist(), strict=True):
        wanted, other = (f"{role}, turning", role) if turning else (role, f"{role}, turning")
        if hero.is_active(other):
            hero.stop(other)
        if share >= STARTS and not hero.is_active(wanted):
            hero.start(wanted)
        if share < ENDS and hero.is_active(wanted):
            hero.stop(wanted)
        elif hero.is_active(wanted):
            hero.set_priority(wanted, share, fade=0.0)
