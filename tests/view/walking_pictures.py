"""Two takes of the walking figure, one with feet that slide, and a schedule to draw."""

from __future__ import annotations

import numpy as np
from tests import walking_figure

from footfall.report import Trace
from footfall.skeleton import find_anatomy
from footfall.support import Support
from footfall.view import ActionLane, CueMark, LanePhase, Timeline


def trace(sliding: float, frames: int = 100) -> Trace:
    clip = walking_figure.walk(frames, sliding=sliding)
    rotations, positions = clip.world_poses()
    symbols = walking_figure.supports(frames)
    return Trace(
        positions,
        rotations,
        find_anatomy(clip.skeleton),
        clip.fps,
        np.array([Support.from_symbol(symbol) for symbol in symbols]),
        moving=np.arange(frames) // 20 == 2,
    )


def takes(frames: int = 100) -> tuple[tuple[str, Trace], ...]:
    return (("Plain cross-fade", trace(0.12, frames)), ("footfall", trace(0.0, frames)))


def timeline(frames: int = 100) -> Timeline:
    kick = np.interp(np.arange(frames), [40, 55, 80, 95], [0.0, 0.7, 0.7, 0.0])
    walk = (
        LanePhase("D", 0.0, 0.11),
        LanePhase("L", 0.11, 0.55),
        LanePhase("D", 0.55, 0.66),
        LanePhase("R", 0.66, 1.4, stretch=1.7),
        LanePhase("D", 1.4, frames / 60.0),
    )
    punch = (LanePhase("R", 0.66, 1.4), LanePhase("-", 1.4, 1.6))
    cues = (CueMark("start", 0.5, 0.66), CueMark("stop", 1.0, 1.33), CueMark("start", 1.5))
    return Timeline(
        60.0,
        walking_figure.supports(frames),
        (
            ActionLane("punch", punch, kick, cues),
            ActionLane("walk", walk, 1.0 - kick, (CueMark("start", 0.0, 0.0),)),
        ),
    )
