"""Bodies that are to perform another's motion: from their files, and in their skins."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from footfall.cli.inputs import about, read_motion
from footfall.cli.outputs import check_beside, save_motion
from footfall.detection import frame_symbols
from footfall.errors import FileFormatError
from footfall.io import (
    SkinnedBody,
    gltf_animations,
    load_skinned,
    save_skinned,
    save_supports,
    split_choice,
)
from footfall.motion import Clip
from footfall.motion.retargeting import map_clip, performer_anatomy, retarget
from footfall.report.track import carrying
from footfall.scenario.motions import supports_path
from footfall.skeleton import Anatomy, Skeleton
from footfall.skeleton.correspondence import Correction
from footfall.support import SupportSequence

__all__ = ["Performance", "Performer", "performed", "read_performer", "save_performance"]

CHARACTERS = (".glb", ".gltf")
"""Suffixes of the files that may hold a skin."""


@dataclass(frozen=True, eq=False)
class Performer:
    """A body that is to perform a motion."""

    name: str
    """What messages call it."""

    skeleton: Skeleton
    """Its body."""

    clip: Clip | None
    """A motion of its own, which shows its hinges and soles; None: it has none."""

    skin: SkinnedBody | None
    """Its skin; None: it has none."""


@dataclass(frozen=True, eq=False)
class Performance:
    """A motion as another body performs it."""

    clip: Clip
    """The motion."""

    performer: Performer
    """Who performs it."""

    anatomy: Anatomy
    """The performer's, as it was found for this motion."""

    reasons: tuple[str, ...]
    """What drives its joints, one sentence for each conclusion."""


def read_performer(name: str) -> Performer:
    """Return the body that a file holds, with its skin where it has one.

    Args:
        name: A motion file, a glTF file of a character with motions or without, or
            ``sample:NAME``.

    Raises:
        FootfallError: If there is none, or it cannot be read.
    """
    skin = _skin(name)
    if skin is None:
        clip, _ = read_motion(name)
        return Performer(name, clip.skeleton, clip, None)
    path, choice = split_choice(name)
    animations = gltf_animations(path)
    if not animations:
        return Performer(name, skin.skeleton, None, skin)
    shown, _ = read_motion(name if choice is not None or len(animations) == 1 else f"{name}#0")
    alike = skin.skeleton.same_family(shown.skeleton)
    return Performer(
        name, skin.skeleton, shown.ordered_like(skin.skeleton) if alike else None, skin
    )


def _skin(name: str) -> SkinnedBody | None:
    """Return the character in a glTF file; None where there is no skin in it."""
    path, _ = split_choice(name)
    if path.suffix.lower() not in CHARACTERS:
        return None
    try:
        return load_skinned(path)
    except FileFormatError:
        # Why the file is none will be told by the reader of motions, or it has joints alone.
        return None


def performed(
    clip: Clip,
    supports: SupportSequence,
    performer: Performer,
    corrections: Mapping[str, Correction | None] | None = None,
) -> Performance:
    """Return a motion as a performer does it.

    Args:
        clip: The motion.
        supports: What carries its body.
        performer: Who is to perform it.
        corrections: Joints that are driven otherwise than is found.

    Raises:
        FootfallError: If there is no map between the two bodies; the message names the performer.
    """
    with about(performer.name):
        body_map = map_clip(clip, performer.skeleton, performer.clip, corrections)
        carries = carrying(supports.supports_at(np.arange(clip.frames) / clip.fps))
        result = retarget(clip, performer.skeleton, body_map, carries)
        anatomy = performer_anatomy(clip, body_map)
    return Performance(result, performer, anatomy, tuple(body_map.reasons))


def save_performance(
    performance: Performance, path: Path, supports: SupportSequence | None
) -> None:
    """Write a performance, in the performer's skin where the file can hold it.

    Args:
        performance: The motion and its performer.
        path: The file.
        supports: What carries the body; None: nothing is written beside it.

    Raises:
        FileFormatError: If a file cannot be written.
    """
    clip, skin = performance.clip, performance.performer.skin
    symbols = None if supports is None else frame_symbols(supports, clip.fps, clip.frames)
    if skin is None or path.suffix.lower() != ".glb":
        save_motion(clip, path, supports, symbols)
        return
    check_beside(path, supports)
    save_skinned(skin, [clip], path, supports=None if symbols is None else [symbols])
    if supports is not None:
        save_supports(supports, supports_path(path))
