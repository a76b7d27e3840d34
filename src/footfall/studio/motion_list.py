"""The motions that were loaded, and the scenario that they make up together."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from footfall.errors import FootfallError, ScenarioError
from footfall.motion import Clip
from footfall.scenario.cue_sheet import ActionEntry, Scenario
from footfall.scenario.motions import SAMPLE, Motion, resolve_motion, supports_path
from footfall.skeleton import Skeleton
from footfall.studio.fitting import Fitting
from footfall.studio.work_folder import WorkFolder, check_size

__all__ = ["DEFAULT_SAMPLES", "LoadedMotion", "MotionList"]

DEFAULT_SAMPLES = ("walk", "walk-fast", "run", "side-step", "idle", "kick", "punch", "jump")
"""What is loaded where no file is named."""

PRIORITIES = {
    "sample:run": 2.0,
    "sample:kick": 3.0,
    "sample:jump": 3.0,
    "sample:punch": {"trunk": 3.0, "arms": 4.0},
}
"""What a sample starts with, where that is not 1."""

SHEET = "take.toml"
"""The name of the scenario that a session makes up, before it is saved under another."""


@dataclass(frozen=True, eq=False)
class LoadedMotion:
    """A motion as it is performed."""

    entry: ActionEntry
    """How it was asked for."""

    motion: Motion
    """What it is."""

    @property
    def name(self) -> str:
        """What its card is called."""
        return self.entry.name


class MotionList:
    """Motions in the order in which they were loaded."""

    def __init__(self, folder: WorkFolder, like: MotionList | None = None) -> None:
        """Begin without motions, or with those of another list, and with what it remembers."""
        self.folder = folder
        self.motions: list[LoadedMotion] = [] if like is None else list(like.motions)
        self.body: Skeleton | None = None
        """Who performs; None: the body of the first motion."""
        self._fitting = Fitting() if like is None else like._fitting

    def find(self, name: str) -> LoadedMotion | None:
        """Return a motion by its name, or None."""
        return next((motion for motion in self.motions if motion.name == name), None)

    @property
    def performed(self) -> list[tuple[LoadedMotion, Clip]]:
        """The motions that the body can perform, and as it performs them."""
        return self.fit_all(lambda _: None)

    def fit_all(self, begin: Callable[[LoadedMotion], None]) -> list[tuple[LoadedMotion, Clip]]:
        """Return `performed`, and say each motion before it is fitted."""
        found: list[tuple[LoadedMotion, Clip]] = []
        for one in self.motions:
            begin(one)
            made = self.fit(one, found[0][1] if found else None)
            if not isinstance(made, str):
                found.append((one, made))
        return found

    @property
    def family(self) -> list[LoadedMotion]:
        """The motions that the body can perform."""
        return [one for one, _ in self.performed]

    def fit(self, loaded: LoadedMotion, shown: Clip | None = None) -> Clip | str:
        """Return a motion as the body performs it, or why it cannot.

        What has been made is remembered: prepared beside the live session it costs nothing later.

        Args:
            loaded: The motion.
            shown: As the body performs the first motion, if this is not the first one.
        """
        begin = (loaded.entry.speed, loaded.entry.turn)
        return self._fitting.clip(loaded.motion, self._body(loaded), shown, begin)

    def _body(self, loaded: LoadedMotion) -> Skeleton:
        first = self.motions[0] if self.motions else loaded
        return self.body or first.motion.clip.skeleton

    def whole(self, loaded: LoadedMotion) -> Motion:
        """Return a motion of `performed`, the others of a gait as the body performs them."""
        if not loaded.motion.others:
            return loaded.motion
        first, shown = self.performed[0]
        fitted = [
            (
                other,
                self._fitting.clip(other, self._body(loaded), None if first is loaded else shown),
            )
            for other in loaded.motion.others
        ]
        others = [replace(other, clip=clip) for other, clip in fitted if not isinstance(clip, str)]
        return replace(loaded.motion, others=tuple(others))

    def prepare(self, loaded: LoadedMotion) -> None:
        """Fit a motion that is not in the list yet.

        Raises:
            ScenarioError: If the body cannot perform it.
        """
        performed = self.performed
        made = self.fit(loaded, performed[0][1] if performed else None)
        if isinstance(made, str):
            raise ScenarioError(f"{loaded.name} cannot be performed by this body: {made}")

    @property
    def skeletons(self) -> list[Skeleton]:
        """The bodies of the motions, each once."""
        found: list[Skeleton] = []
        for one in self.motions:
            skeleton = one.motion.clip.skeleton
            if not any(_same_body(skeleton, other) for other in found):
                found.append(skeleton)
        return found

    def sheet(self) -> Scenario:
        """Return the scenario of `family`, without a cue."""
        entries = tuple(one.entry for one in self.family)
        return Scenario(self.folder.root / SHEET, entries, (), duration=3600.0)

    def resolve(self, file: str | Path) -> LoadedMotion:
        """Load a motion, without putting it into the list.

        Args:
            file: ``sample:NAME``, or a file: from the folder, or anywhere.

        Raises:
            FootfallError: If it cannot be used.
        """
        return self.resolve_entry(self._entry(str(file)))

    def resolve_entry(self, entry: ActionEntry) -> LoadedMotion:
        """Load what an entry asks for, without putting it into the list.

        Raises:
            FootfallError: If it cannot be used.
        """
        try:
            motion = resolve_motion(entry, self.sheet())
        except FootfallError as error:
            message = str(error)
            prefix = f"{self.folder.root / SHEET}: action {entry.name!r}: "
            raise ScenarioError(message.removeprefix(prefix)) from error
        return LoadedMotion(entry, motion)

    def reload(self, name: str, **changes: object) -> LoadedMotion:
        """Load a motion again, with some fields of its entry changed, without keeping it.

        Raises:
            FootfallError: If it cannot be used so; then nothing has changed.
        """
        old = self.find(name)
        assert old is not None
        return self.resolve_entry(replace(old.entry, **changes))  # pyright: ignore[reportArgumentType]

    def remove(self, name: str) -> None:
        """Forget a motion."""
        self.motions = [one for one in self.motions if one.name != name]

    def supports_file(self, entry: ActionEntry) -> str:
        """Return where corrected supports of a motion stand, named from the folder."""
        if entry.motion.startswith(SAMPLE):
            return f"{entry.motion.removeprefix(SAMPLE)}.supports"
        return str(supports_path(Path(entry.motion)))

    def _entry(self, file: str) -> ActionEntry:
        if file.startswith(SAMPLE):
            name = file.removeprefix(SAMPLE)
            entry = ActionEntry(name, file, PRIORITIES.get(file, 1.0))
        else:
            path = Path(file)
            real = (self.folder.root / path).resolve()
            check_size(real)
            if real.is_relative_to(self.folder.root):
                path = real.relative_to(self.folder.root)
            entry = ActionEntry(self._free_name(path), str(path))
        # Corrections of a sample travel beside no file: they stand in the folder.
        corrected = self.supports_file(entry)
        if (self.folder.root / corrected).is_file():
            return replace(entry, supports=corrected)
        return entry

    def _free_name(self, path: Path) -> str:
        stem = path.name.split(".")[0] or path.name
        taken = {one.name: one.entry.motion for one in self.motions}
        name, count = stem, 1
        while name in taken and taken[name] != str(path):
            count += 1
            name = f"{stem} {count}"
        return name

    def keep(self, loaded: LoadedMotion) -> None:
        """Put a motion at the end, or in the place of one of the same name."""
        for index, one in enumerate(self.motions):
            if one.name == loaded.name:
                self.motions[index] = loaded
                return
        self.motions.append(loaded)


def _same_body(one: Skeleton, other: Skeleton) -> bool:
    same = one.same_family(other) and one.names == other.names
    return same and np.allclose(one.rest_offsets, other.rest_offsets)
