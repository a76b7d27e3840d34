"""The cue sheets of the demo: motions started and stopped at arbitrary moments, as in figure 17."""

from __future__ import annotations

from pathlib import Path

from footfall.errors import ArgumentError, FootfallError
from footfall.scenario.cue_sheet import ActionEntry, Cue, Scenario, parse_scenario
from footfall.scenario.motions import Motion, resolve_motion

__all__ = ["SAMPLE_CUES", "folder_scenario", "sample_scenario"]

SAMPLE_CUES = """\
fps = 60
duration = 12.0

[[action]]
name = "walk"
motion = "sample:walk"

[[action]]
name = "walk fast"
motion = "sample:walk-fast"

[[action]]
name = "run"
motion = "sample:run"
priority = 2.0
fade_in = 0.4
fade_out = 0.4

[[action]]
name = "side step"
motion = "sample:side-step"

[[action]]
name = "kick"
motion = "sample:kick"
priority = 3.0

[[action]]
name = "punch"
motion = "sample:punch"
priority = { trunk = 3.0, arms = 4.0 }

[[cue]]
at = 0.0
start = "walk"

[[cue]]
at = 1.73
start = "walk fast"

[[cue]]
at = 2.21
stop = "walk"

[[cue]]
at = 3.37
start = "run"

[[cue]]
at = 3.94
stop = "walk fast"

[[cue]]
at = 5.18
start = "walk"

[[cue]]
at = 5.63
stop = "run"

[[cue]]
at = 6.87
start = "punch"

[[cue]]
at = 7.91
stop = "punch"

[[cue]]
at = 8.12
start = "kick"

[[cue]]
at = 9.27
stop = "kick"

[[cue]]
at = 9.71
start = "side step"

[[cue]]
at = 10.66
stop = "side step"
"""
"""Of the samples."""

SUFFIXES = (".bvh", ".bvh.gz", ".npz")

MOST = 4
"""How many motions of a folder are shown."""

EVERY, OVERLAP = 3.07, 0.63
"""Seconds between two starts, and for how long the motion before goes on."""


def sample_scenario() -> Scenario:
    """Return the cue sheet of the samples."""
    return parse_scenario(SAMPLE_CUES, "demo.toml")


def folder_scenario(folder: Path) -> Scenario:
    """Return a cue sheet of the first motions of a folder that share a skeleton.

    Raises:
        ArgumentError: If there is none.
    """
    if not folder.is_dir():
        raise ArgumentError(f"--motions is {folder}; it must be a folder with motions")
    files = sorted(path for path in folder.rglob("*") if path.name.lower().endswith(SUFFIXES))
    path = folder / "demo.toml"
    entries: list[ActionEntry] = []
    first: Motion | None = None
    for file in files:
        name = file.name.split(".")[0]
        if len(entries) == MOST:
            break
        if any(entry.name == name for entry in entries):
            continue
        found = _entry(name, str(file.relative_to(folder)), path)
        if found is None:
            continue
        entry, motion = found
        if first is None or motion.clip.skeleton.same_family(first.clip.skeleton):
            entries.append(entry)
            first = first or motion
    if not entries:
        raise ArgumentError(
            f"{folder} holds no motion of a biped; put {', '.join(SUFFIXES)} files there"
        )
    return Scenario(path, tuple(entries), _cues(entries), duration=EVERY * len(entries))


def _entry(name: str, file: str, path: Path) -> tuple[ActionEntry, Motion] | None:
    """Return an action, repeated where its motion holds a cycle; None if it is unusable."""
    for cyclic in (True, False):
        entry = ActionEntry(name, file, cyclic=cyclic, clean=True)
        try:
            return entry, resolve_motion(entry, Scenario(path, (entry,), ()))
        except FootfallError:
            continue
    return None


def _cues(entries: list[ActionEntry]) -> tuple[Cue, ...]:
    cues: list[Cue] = []
    for index, entry in enumerate(entries):
        cues.append(Cue(EVERY * index, "start", entry.name))
        if index + 1 < len(entries):
            cues.append(Cue(EVERY * (index + 1) + OVERLAP, "stop", entry.name))
    return tuple(sorted(cues, key=lambda cue: cue.at))
