"""One session, shared by all tabs: what they see, what they may say, and time.

A lock is held while a message is obeyed and while a frame passes, so that any number of tabs may
speak at once; long work is done beside, and takes the lock only to hand over what it has found.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from footfall.errors import ArgumentError
from footfall.io import SkinnedBody
from footfall.scenario.cue_sheet import Cue, Scenario
from footfall.studio.bodies import Body, Wardrobe
from footfall.studio.crowd_stage import CrowdStage
from footfall.studio.editor import SupportEditor
from footfall.studio.jobs import Job, Jobs
from footfall.studio.motion_list import LoadedMotion, MotionList
from footfall.studio.stage import Stage
from footfall.studio.work_folder import WorkFolder

__all__ = ["SPEEDS", "VIEWS", "Session", "Tell"]

VIEWS = ("stage", "supports", "crowd")

SPEEDS = (1.0, 0.5, 0.25, 0.1)
"""How fast time may pass."""

Tell = Callable[[dict[str, Any]], None]


class Session:
    """Motions, a stage, an editor, a crowd; and which of them is looked at."""

    def __init__(self, folder: WorkFolder, tell: Tell) -> None:
        """Begin with nothing.

        Args:
            folder: Where files are written.
            tell: Called with what all tabs are to know.
        """
        self.folder = folder
        self.tell = tell
        self.lock = threading.RLock()
        self.motions = MotionList(folder)
        self.stage = Stage(self.motions)
        self.editor: SupportEditor | None = None
        self.crowd: CrowdStage | None = None
        self.crowd_size = 300
        self.jobs = Jobs(self._jobs_changed, lambda text: self.notice(text, "error"))
        self.view = "stage"
        self.paused = False
        self.speed = 1.0
        self.ghost = False
        self.tilt = (0.0, 0.0)
        """How the ground was asked to rise ahead of the character and to its left [1]."""
        self.body = "own"
        self.wardrobe = Wardrobe()
        self.skin: SkinnedBody | None = None
        """Of the body that performs; None: it is drawn as a mannequin."""
        self.clip_time = 0.0
        self.clip_plays = True
        self.body_count = 0
        """Counted up whenever another body is to be drawn."""
        self.crowd_count = 0
        """Counted up whenever another crowd is to be drawn."""
        self.script: list[Cue] = []
        """Cues of a scenario that is being replayed, in order of time."""
        self.camera: Callable[[int, int], Any] | None = None
        """Draws what the latest tab sees."""
        self.page_writer: Callable[[Scenario], str] | None = None
        """Returns a page that plays a scenario without a network."""

    def notice(self, text: str, level: str = "info") -> None:
        """Tell all tabs one line."""
        self.tell({"kind": "notice", "level": level, "text": " ".join(text.split())})

    def select(self, name: str) -> None:
        """Open a motion in the editor.

        Raises:
            ArgumentError: If there is none of this name.
        """
        loaded = self.motions.find(name)
        if loaded is None:
            raise ArgumentError(f"no motion {name!r} to edit")
        if loaded.motion.others:
            raise ArgumentError(f"{name!r} is a gait of several motions; edit those")
        motion = loaded.motion
        file = self.motions.supports_file(loaded.entry)
        self.editor = SupportEditor(name, motion.clip, motion.supports, file, self.folder)
        self.clip_time, self.clip_plays = 0.0, True
        self.body_count += 1
        if self.editor.restored:
            self.notice(f"{name}: unsaved work is back")

    def save_supports(self) -> None:
        """Save what the editor has, and let the stage perform it."""
        editor = self.editor
        assert editor is not None
        editor.save()
        self.motions.keep(self.motions.reload(editor.name, supports=editor.file))
        self.notice(f"saved {editor.file}")
        self.motions_changed()

    def put_on(self, body: Body) -> None:
        """Let another body perform, whose motions have been fitted; the take begins anew."""
        self.body, self.skin = body.name, body.skin
        self.motions.body = body.skeleton
        self.crowd = None
        self.restart()

    def remove(self, name: str) -> None:
        """Forget a motion."""
        self.motions.remove(name)
        self.motions_changed()

    def picture(self, width: int, height: int) -> Any:
        """Return what the latest tab sees, shape (height, width, 3).

        Raises:
            RuntimeError: If there is none.
        """
        if self.camera is None:
            raise RuntimeError("no 3D scene is open")
        return self.camera(width, height)

    def restart(self) -> None:
        """Begin a new take."""
        self.script = []
        self.stage.restart()
        self.body_count += 1

    def show(self, view: str) -> None:
        """Look at something else.

        Raises:
            ArgumentError: If there is no such view.
        """
        if view not in VIEWS:
            raise ArgumentError(f"no view {view!r}; there are: {', '.join(VIEWS)}")
        self.view = view
        single = [one.name for one in self.motions.motions if not one.motion.others]
        if view == "supports" and self.editor is None and single:
            self.select(single[0])
        if view == "crowd" and self.crowd is None:
            self.gather()
        self.body_count += 1

    def gather(self) -> None:
        """Let a new crowd stand on the field, beside the live session."""
        if not self.motions.family:
            return

        def work(job: Job) -> None:
            with self.lock:
                performed = self.motions.performed
                whole = [(self.motions.whole(one), clip) for one, clip in performed]
            entries = [one.entry for one, _ in performed]
            motions = tuple(replace(motion, clip=clip) for motion, clip in whole)
            crowd = CrowdStage(entries, motions, self.crowd_size)
            job.report(1.0)
            with self.lock:
                self.crowd = crowd
                self.crowd_count += 1
                for group in range(5):
                    crowd.start(crowd.names[0], group)
            self.tell(self.crowd_json())

        self.jobs.begin(f"gathering {self.crowd_size} characters", work)

    def crowd_json(self) -> dict[str, Any]:
        """Return who is in the crowd."""
        names = [] if self.crowd is None else list(self.crowd.names)
        return {"kind": "crowd", "size": self.crowd_size, "actions": names}

    def close(self) -> None:
        """End all work."""
        self.jobs.close()

    def take_in(self, loaded: LoadedMotion) -> None:
        """Let a motion be performed; who walks goes on walking if it is a new one."""
        known = self.motions.find(loaded.name) is not None
        self.motions.keep(loaded)
        if self.stage.begun and not known and loaded in self.motions.family:
            # The library only grows.
            self.stage.add(loaded)
            self.tell({"kind": "changed"})
            return
        self.motions_changed()

    def motions_changed(self) -> None:
        """Begin anew with the motions as they are now."""
        self.stage.restart()
        self.script = []
        self.crowd = None
        self.body_count += 1
        if self.view == "crowd":
            self.gather()
        if self.editor is not None:
            self._reopen_editor(self.editor)
        self.tell({"kind": "changed"})

    def _reopen_editor(self, editor: SupportEditor) -> None:
        loaded = self.motions.find(editor.name)
        if loaded is None:
            self.editor = None
        elif loaded.motion.clip is not editor.clip:
            self.select(editor.name)

    def jobs_json(self) -> dict[str, Any]:
        """Return the long work that is not over."""
        jobs = [
            {
                "number": job.number,
                "title": job.title,
                "share": round(job.share, 3),
                "detail": job.detail,
                "canceled": job.canceled,
            }
            for job in self.jobs.present
        ]
        return {"kind": "jobs", "jobs": jobs}

    def _jobs_changed(self) -> None:
        self.tell(self.jobs_json())
