"""Who plays which part in the figures: the samples, or motions named after the parts."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from footfall.errors import ArgumentError, FootfallError, UnknownNameError
from footfall.motion import Clip
from footfall.motion.retargeting import map_clip, retarget
from footfall.samples import sample
from footfall.scenario.cue_sheet import ActionEntry, Scenario
from footfall.scenario.motions import Motion, resolve_motion
from footfall.sync.tables import check_registration

__all__ = ["ROLES", "Cast", "Role"]

SUFFIXES = (".bvh", ".bvh.gz", ".npz")
"""Files of a folder that are looked at."""


@dataclass(frozen=True, slots=True)
class Role:
    """A part that a motion can play."""

    sample: str
    """The sample that plays it where nothing else does."""

    words: tuple[str, ...]
    """Any of these in a file's name offers it for the part; each may be two words with a blank."""

    cyclic: bool = True
    """Whether it is played again and again."""


ROLES: Mapping[str, Role] = {
    "walk": Role("walk", ("walk",)),
    "fast walk": Role("walk-fast", ("walk fast", "fast walk")),
    "back walk": Role("walk-backward", ("walk backward", "backward", "back walk")),
    "run": Role("run", ("run",)),
    "side step": Role("side-step", ("side step", "sidestep left", "side step left")),
    "right hop": Role("hop-right", ("hop right", "right hop")),
    "left hop": Role("hop-left", ("hop left", "left hop")),
    "kick": Role("kick", ("kick", "fight", "boxing"), cyclic=False),
    "jump": Role("jump", ("jump",), cyclic=False),
    "shot": Role("shot", ("shot", "handball"), cyclic=False),
    "walk to hop": Role("walk-to-hop", ("walk to hop",), cyclic=False),
}
"""All parts by name."""


@dataclass(frozen=True, eq=False)
class Cast:
    """A motion for each part."""

    motions: Mapping[str, Motion]
    """By the name of the part."""

    origins: Mapping[str, str] = field(default_factory=dict[str, str])
    """The file that plays each part that no sample plays."""

    @classmethod
    def of_samples(cls) -> Cast:
        """Return the parts as the project's own samples play them."""
        return cls({name: _sampled(role) for name, role in ROLES.items()})

    @classmethod
    def of_folder(cls, folder: Path) -> Cast:
        """Return the parts as motions of a folder play them, and samples the others.

        A file plays a part if its name holds the words of the part (``walk_fast.bvh``, the fast
        walk); of several, the one whose name says the least else.

        Raises:
            ArgumentError: If it is no folder, or none of its files plays a part.
        """
        if not folder.is_dir():
            raise ArgumentError(f"--motions is {folder}; it must be a folder with motions")
        files = sorted(path for path in folder.rglob("*") if path.name.lower().endswith(SUFFIXES))
        motions: dict[str, Motion] = {}
        origins: dict[str, str] = {}
        for name, role in ROLES.items():
            # The walk is the first of all: everything is played on its body.
            body = motions["walk"].clip if motions else None
            motions[name] = _on_body(_sampled(role), body)
            for file in _candidates(files, role):
                motion = _usable(folder, file, role, body)
                if motion is not None:
                    motions[name], origins[name] = motion, str(file.relative_to(folder))
                    break
        if not origins:
            raise ArgumentError(
                f"{folder} holds no motion of a biped that plays a part; name "
                f"{', '.join(SUFFIXES)} files after the parts: {', '.join(ROLES)}"
            )
        return cls(motions, origins)

    def motion(self, role: str) -> Motion:
        """Return the motion of a part.

        Raises:
            UnknownNameError: If there is no such part.
        """
        if role not in self.motions:
            raise UnknownNameError("part", role, list(self.motions))
        return self.motions[role]


def _sampled(role: Role) -> Motion:
    return Motion(*sample(role.sample))


def _candidates(files: list[Path], role: Role) -> list[Path]:
    """Return the files that offer themselves, those whose names say least else first."""
    others = {words for other in ROLES.values() if other is not role for words in other.words}
    found: list[tuple[int, int, Path]] = []
    for file in files:
        name = " ".join(_words(file))
        ranks = [rank for rank, words in enumerate(role.words) if f" {words} " in f" {name} "]
        longest = max((len(role.words[rank]) for rank in ranks), default=0)
        clearer = any(len(words) > longest and f" {words} " in f" {name} " for words in others)
        if ranks and not clearer:
            found.append((len(name), ranks[0], file))
    return [file for _, _, file in sorted(found)]


def _words(file: Path) -> list[str]:
    """Return the words of a file's name, in lower case, without numbers."""
    stem = file.name.split(".")[0]
    return [word.lower() for word in re.findall(r"[A-Z]?[a-z]+|[A-Z]+", stem)]


def _usable(folder: Path, file: Path, role: Role, body: Clip | None) -> Motion | None:
    """Return a motion as it plays the part, on the body of a clip; None if it cannot."""
    entry = ActionEntry("part", str(file), cyclic=role.cyclic, clean=True)
    try:
        motion = resolve_motion(entry, Scenario(folder / "cast.toml", (entry,), ()))
        if len(motion.supports.phases) == 1:
            return None
        check_registration(motion.supports)
        return _on_body(motion, body)
    except FootfallError:
        return None


def _on_body(motion: Motion, body: Clip | None) -> Motion:
    """Return a motion as the body of a clip performs it."""
    if body is None:
        return motion
    if body.skeleton.same_family(motion.clip.skeleton):
        return Motion(motion.clip.ordered_like(body.skeleton), motion.supports)
    body_map = map_clip(motion.clip, body.skeleton, body)
    return Motion(retarget(motion.clip, body.skeleton, body_map), motion.supports)
