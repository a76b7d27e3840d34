"""The motions of a cue sheet: found, cut, mirrored, cleaned, and said what they stand on."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from footfall.detection import clean, detect_supports
from footfall.engine.action import LONGEST_DISAGREEMENT
from footfall.errors import FileFormatError, FootfallError, ScenarioError
from footfall.io import load, load_native_supports, load_supports, split_choice
from footfall.io.amass import is_amass
from footfall.motion import Clip, with_soles
from footfall.motion.cycle_closing import close_cycle, cut_cycle
from footfall.motion.editing import crop
from footfall.motion.mirroring import mirror
from footfall.samples import sample
from footfall.scenario.cue_sheet import Scenario
from footfall.scenario.entries import ActionEntry
from footfall.skeleton import Anatomy, Skeleton, find_anatomy
from footfall.support import Support, SupportPhase, SupportSequence

__all__ = [
    "SAMPLE",
    "Motion",
    "body_of",
    "edited_motion",
    "load_motion",
    "load_with_supports",
    "resolve_motion",
    "supports_beside",
    "supports_path",
]

SAMPLE = "sample:"
"""How the name of a sample begins."""

_MIRRORED = {Support.LEFT: Support.RIGHT, Support.RIGHT: Support.LEFT}


@dataclass(frozen=True, eq=False)
class Motion:
    """A clip with what it stands on."""

    clip: Clip
    """The motion."""

    supports: SupportSequence
    """What carries the body when."""

    others: tuple[Motion, ...] = ()
    """Where the action follows a speed and a turn: the motions of the others."""


def supports_path(path: Path) -> Path:
    """Return where the supports of a motion file stand: its name with ``.supports``.

    Those of one clip of several have its name too: ``walk.Walk_Loop.supports``.
    """
    path, choice = split_choice(path)
    name = path.name
    for suffix in (".gz", path.with_suffix("").suffix if name.endswith(".gz") else path.suffix):
        name = name.removesuffix(suffix) if suffix else name
    if choice is not None:
        name += "." + re.sub(r"[^\w.-]+", "_", choice)
    return path.with_name(f"{name}.supports")


def supports_beside(path: Path) -> SupportSequence | None:
    """Return the supports that travel with a file, beside it or in it; None where there are none.

    Raises:
        FileFormatError: If they cannot be read.
    """
    file, _ = split_choice(path)
    for place in (supports_path(path), file.with_name(f"{file.name}.supports")):
        if place.exists():
            return load_supports(place)
    stored = path.suffix == ".npz" and not is_amass(path)
    return load_native_supports(path) if stored else None


def load_motion(name: str, folder: Path, fps: float = 60.0) -> tuple[Clip, SupportSequence | None]:
    """Return a motion by its name in a scenario, and its known supports.

    Args:
        name: ``sample:NAME``, or a file.
        folder: Where the file is looked for.
        fps: The rate at which a sample is made.

    Raises:
        FootfallError: If there is no such motion or it cannot be read.
    """
    if name.startswith(SAMPLE):
        return sample(name.removeprefix(SAMPLE), fps=max(fps, 60.0))
    return load_with_supports(folder / name)


def load_with_supports(path: Path, **known: Any) -> tuple[Clip, SupportSequence | None]:
    """Return the motion of a file, and the supports that travel with it.

    Args:
        path: The file.
        known: What is known better than the file knows it, as `load` takes it.

    Raises:
        FileFormatError: If either cannot be read, or they last another time than the motion.
    """
    clip, supports = load(path, **known), supports_beside(path)
    if supports is not None and abs(supports.duration - clip.duration) > LONGEST_DISAGREEMENT:
        raise FileFormatError(
            f"lasts {clip.duration:.3f} s, the supports that travel with it {supports.duration:.3f}"
            f" s; they are another motion's: delete {supports_path(path).name}, or detect anew",
            path=path,
        )
    return clip, supports


def body_of(scenario: Scenario) -> Skeleton | None:
    """Return the skeleton that performs; None for the first action's.

    Raises:
        ScenarioError: If its motion cannot be read.
    """
    if scenario.body is None:
        return None
    try:
        return load_motion(scenario.body, scenario.path.parent)[0].skeleton
    except FootfallError as error:
        raise ScenarioError(f"{scenario.path}: body: {error}") from error


def resolve_motion(entry: ActionEntry, scenario: Scenario, like: Motion | None = None) -> Motion:
    """Return the motion of an action as it is performed.

    Supports are those that the action names; else those that travel with the motion, unless it
    is cut; else they are detected.

    Args:
        entry: Which action.
        scenario: Its cue sheet.
        like: The motion whose feet it is cleaned for, if they are of one family: feet that play
            together are held at the same points.

    Raises:
        ScenarioError: If the motion cannot be read or edited as asked.
    """
    try:
        first = edited_motion(entry, scenario, like)
        others = tuple(
            edited_motion(replace(entry, motion=name, others=()), scenario, like or first)
            for name in entry.others
        )
        return replace(first, others=others)
    except FootfallError as error:
        raise ScenarioError(f"{scenario.path}: action {entry.name!r}: {error}") from error


def edited_motion(entry: ActionEntry, scenario: Scenario, like: Motion | None = None) -> Motion:
    """Return the one motion of an action, cut and mirrored as it says.

    Args:
        entry: Which action.
        scenario: Its cue sheet.
        like: As of `resolve_motion`.

    Raises:
        FootfallError: If it cannot be read or edited as asked.
    """
    clip, known = load_motion(entry.motion, scenario.path.parent, scenario.fps)
    anatomy = find_anatomy(clip.skeleton)
    if entry.mirror:
        clip = mirror(clip, anatomy)
        known = None if known is None else _mirrored(known)
    if entry.crop is not None:
        clip, known = crop(clip, *entry.crop), None
    if known is not None and entry.cyclic is None and known.cyclic != clip.cyclic:
        clip = _played(clip, known.cyclic)
    elif entry.cyclic is not None and entry.cyclic != clip.cyclic:
        if entry.cyclic and not (known is not None and known.cyclic):
            cut = close_cycle if entry.crop is not None else cut_cycle
            clip, known = cut(clip, anatomy), None
        else:
            clip = _played(clip, entry.cyclic)
    if known is not None and known.cyclic != clip.cyclic:
        known = None
    if entry.supports is not None:
        known = _named_supports(scenario.path.parent / entry.supports)
        clip = clip if known.cyclic == clip.cyclic else _played(clip, known.cyclic)
    supports = detect_supports(clip, anatomy) if known is None else known
    if entry.clean:
        clip = clean(clip, supports, _feet(clip, anatomy, like))
    return Motion(clip, supports)


def _feet(clip: Clip, anatomy: Anatomy, like: Motion | None) -> Anatomy:
    """Return the anatomy with the soles of another motion of the same body."""
    if like is None or like.clip.skeleton.names != clip.skeleton.names:
        return anatomy
    return with_soles(anatomy, *like.clip.world_poses())


def _named_supports(path: Path) -> SupportSequence:
    if not path.exists():
        raise FileFormatError("there is no such file; check the name", path=path)
    return load_supports(path)


def _played(clip: Clip, cyclic: bool) -> Clip:
    """Return a clip that is played as told: again and again, or once."""
    anatomy = find_anatomy(clip.skeleton)
    if cyclic:
        return close_cycle(clip, anatomy)
    return clip.evolve(cyclic=False, because="played once, as asked")


def _mirrored(supports: SupportSequence) -> SupportSequence:
    phases = tuple(
        SupportPhase(_MIRRORED.get(phase.support, phase.support), phase.duration)
        for phase in supports.phases
    )
    return SupportSequence(phases, supports.cyclic, supports.start)
