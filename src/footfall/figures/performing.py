"""Cues performed by a cast."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Literal

from footfall.figures.cast import Cast
from footfall.scenario.cue_sheet import ActionEntry, Cue, Scenario
from footfall.scenario.performance import Performance, perform
from footfall.sync.tables import Planner

__all__ = ["Cues", "perform_cues"]

Cues = tuple[tuple[float, Literal["start", "stop"], str], ...]
"""When [s], what, and which part."""


def perform_cues(
    cast: Cast,
    cues: Cues,
    duration: float,
    *,
    priorities: Mapping[str, float] | None = None,
    fades: Mapping[str, float] | None = None,
    planner: Planner = "footfall",
    synchronized: bool = True,
    footprints: bool = True,
) -> Performance:
    """Let a cast perform cues.

    Args:
        cast: Who plays.
        cues: In order of time.
        duration: How long [s].
        priorities: Of each part, 1 unless given.
        fades: How long each part's fades take [s], 0.3 unless given.
        planner: Who decides what plays together.
        synchronized: Whether supports are synchronized at all.
        footprints: Whether planted feet are held.
    """
    roles = list(dict.fromkeys(role for _, _, role in cues))
    actions = tuple(
        ActionEntry(
            role,
            role,
            priority=(priorities or {}).get(role, 1.0),
            fade_in=(fades or {}).get(role, 0.3),
            fade_out=(fades or {}).get(role, 0.3),
        )
        for role in roles
    )
    commands = tuple(Cue(at, kind, role) for at, kind, role in cues)
    scenario = Scenario(Path("figure.toml"), actions, commands, duration=duration, planner=planner)
    return perform(
        scenario,
        synchronized=synchronized,
        footprints=footprints,
        motions=tuple(cast.motion(role) for role in roles),
    )
