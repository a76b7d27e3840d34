"""The support editor (the paper's figure 5): one clip, its curves, its bands, what is undone."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict
from typing import Any, cast

import numpy as np

from footfall.detection import Contacts, Interval
from footfall.detection.contacts import track_contacts
from footfall.detection.phases import contact_supports
from footfall.detection.tracks import FootTracks, foot_tracks
from footfall.errors import FootfallError
from footfall.io import parse_supports, supports_text
from footfall.motion import Clip
from footfall.skeleton import find_anatomy
from footfall.studio.bands import Bands
from footfall.studio.work_folder import WorkFolder
from footfall.support import SupportSequence

__all__ = ["DRAFTS", "SupportEditor"]

DRAFTS = ".footfall-studio"
"""The folder, in the work folder, of work that was not saved yet."""

MOST_UNDONE = 200
"""How many edits can be undone."""


class SupportEditor:
    """The supports of one clip while they are corrected.

    Every edit is written to a draft at once, so that it survives a crash; saving writes the
    text annotation and forgets the draft.
    """

    def __init__(
        self, name: str, clip: Clip, supports: SupportSequence, file: str, folder: WorkFolder
    ) -> None:
        """Open a clip, with the work on it that was not saved if there is any.

        Args:
            name: Of the motion.
            clip: The motion.
            supports: As they are saved.
            file: Where they are saved, named from the folder.
            folder: Where that is.
        """
        self.name, self.clip, self.file, self._folder = name, clip, file, folder
        self._tracks: FootTracks = foot_tracks(clip, find_anatomy(clip.skeleton))
        self._times = np.arange(clip.frames) / clip.fps
        self.height: float | None = None
        self.speed: float | None = None
        self.opinion: Contacts = track_contacts(self._tracks, self._times)
        self.saved = Bands.of(supports, clip.duration)
        self.bands = self.saved
        self._undone: list[Bands] = []
        self._past: list[Bands] = []
        self._before_drag: Bands | None = None
        self.restored = self._restore()

    @property
    def draft(self) -> str:
        """Where unsaved work is kept, named from the folder."""
        return f"{DRAFTS}/{self.name.replace('/', '-')}.draft.json"

    @property
    def changed(self) -> bool:
        """Whether there is work that was not saved."""
        return self.bands.feet != self.saved.feet

    @property
    def sequence(self) -> SupportSequence:
        """The supports that the bands say."""
        return self.bands.sequence(self.opinion)

    @property
    def detected(self) -> SupportSequence:
        """What the detector says at the present thresholds."""
        return contact_supports(self.opinion)

    def drag(self, foot: int, band: int, side: str, time: float) -> None:
        """Move an edge while it is held; `release` makes it one edit that can be undone."""
        before = self.bands if self._before_drag is None else self._before_drag
        self.bands = before.with_edge(foot, band, side, time)
        self._before_drag = before

    def release(self) -> None:
        """End a drag."""
        before, self._before_drag = self._before_drag, None
        if before is not None and before.feet != self.bands.feet:
            self._remember(before)

    def edit(self, change: Callable[[Bands], Bands]) -> None:
        """Change the bands, in a way that can be undone."""
        before = self.bands
        self.bands = change(before)
        self._remember(before)

    def adopt(self) -> None:
        """Take over what the detector says."""
        detected = self.detected
        self.edit(lambda bands: Bands.of(detected, bands.duration))

    def undo(self) -> None:
        """Take back the last edit."""
        if self._past:
            self._undone.append(self.bands)
            self.bands = self._past.pop()
            self._keep_draft()

    def redo(self) -> None:
        """Do again what was undone."""
        if self._undone:
            self._past.append(self.bands)
            self.bands = self._undone.pop()
            self._keep_draft()

    @property
    def can_undo(self) -> bool:
        """Whether there is an edit to take back."""
        return bool(self._past)

    @property
    def can_redo(self) -> bool:
        """Whether there is one to do again."""
        return bool(self._undone)

    def set_thresholds(self, height: float | None, speed: float | None) -> None:
        """Let the detector look again: greatest height [m] and speed [m/s]; None: its own.

        Raises:
            ArgumentError: If a limit is out of its range.
        """
        self.opinion = track_contacts(self._tracks, self._times, height=height, speed=speed)
        self.height, self.speed = height, speed

    def save(self) -> SupportSequence:
        """Write the annotation, and return the supports as a reader of it has them.

        Raises:
            FileFormatError: If it cannot be written.
        """
        text = supports_text(self.sequence)
        self._folder.write(self.file, text.encode())
        written = parse_supports(text, self.file)
        self.saved = self.bands = Bands.of(written, self.clip.duration)
        self._forget_draft()
        return written

    def discard(self) -> None:
        """Go back to what is saved."""
        if self.changed:
            self.edit(lambda _: self.saved)
        self._forget_draft()

    def _remember(self, before: Bands) -> None:
        self._past = [*self._past[-MOST_UNDONE:], before]
        self._undone.clear()
        self._keep_draft()

    def _keep_draft(self) -> None:
        if not self.changed:
            self._forget_draft()
            return
        rows = [[asdict(one) for one in foot] for foot in self.bands.feet]
        content = {"duration": self.bands.duration, "feet": rows}
        place = self._folder.place(self.draft)
        place.parent.mkdir(exist_ok=True)
        self._folder.write(self.draft, json.dumps(content).encode())

    def _forget_draft(self) -> None:
        self._folder.place(self.draft).unlink(missing_ok=True)

    def _restore(self) -> bool:
        """Take up unsaved work, and return whether there was any that fits the clip."""
        try:
            text = self._folder.place(self.draft).read_text(encoding="utf-8")
            content = cast(dict[str, Any], json.loads(text))
            feet = [tuple(Interval(**one) for one in row) for row in content["feet"]]
            fits = abs(float(content["duration"]) - self.clip.duration) < 1e-6
            bands = Bands((feet[0], feet[1]), self.clip.duration, self.clip.cyclic)
            bands.sequence(self.opinion)
        except (OSError, ValueError, TypeError, KeyError, IndexError, FootfallError):
            return False
        if not fits or bands.feet == self.saved.feet:
            return False
        self._past, self.bands = [self.saved], bands
        return True
