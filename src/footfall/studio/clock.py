"""Time: what passes in each view between two pictures, sixty times a second."""

from __future__ import annotations

import threading
import time

import numpy as np

from footfall.adaptation import Plane
from footfall.arrays import Positions, Rotations
from footfall.errors import FootfallError
from footfall.skeleton import find_anatomy
from footfall.studio.crowd_stage import RATE
from footfall.studio.editor import SupportEditor
from footfall.studio.figure import between
from footfall.studio.performer import Performer
from footfall.studio.replay import due_cues, obey_cue
from footfall.studio.scene import StudioScene
from footfall.studio.session import Session
from footfall.studio.telling import tick_json

__all__ = ["StudioClock"]

FRAME = 1.0 / 60.0
"""Between two pictures [s]."""

MOST_BEHIND = 0.25
"""How much time is made up for where the machine could not keep step [s]."""

LEVEL = np.array([1.0, 0.0, 1.0])
"""Keeps x and z."""

FIELD = Plane()
"""What a crowd stands on."""

Pose = tuple[Positions, Rotations]


class StudioClock:
    """A thread in which time passes."""

    def __init__(self, session: Session, scene: StudioScene) -> None:
        """Prepare it; `start` lets time pass."""
        self._session, self._scene = session, scene
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run, name="studio-clock", daemon=True)
        self._owed = 0.0
        self._ticks = 0
        self._drawn_body = self._drawn_crowd = -1
        self._looked = "stage"
        self._before: dict[int, Pose] = {}
        self._clip_floor: tuple[SupportEditor, Plane] | None = None
        self._clip_poses: tuple[object, Positions, Rotations] | None = None
        self.late = 0
        """How many pictures came more than a frame too late."""

    def start(self) -> None:
        """Let time pass."""
        self._thread.start()

    def stop(self) -> None:
        """Let it stand still for good."""
        self._stop.set()
        self._thread.join(timeout=5.0)

    def _run(self) -> None:
        due = time.perf_counter()
        last = due
        while not self._stop.is_set():
            due += FRAME
            wait = due - time.perf_counter()
            if wait > 0.0:
                time.sleep(wait)
            elif wait < -FRAME:
                self.late += 1
                due = time.perf_counter()
            now = time.perf_counter()
            passed, last = min(now - last, MOST_BEHIND), now
            self._ticks += 1
            self.tick(passed)

    def tick(self, passed: float) -> None:
        """Let so much time pass [s], and show what has become of everything."""
        session = self._session
        with session.lock:
            if session.view != self._looked:
                self._looked = session.view
                self._scene.look(session.view)
            if session.view == "stage":
                self._stage(passed)
            elif session.view == "supports":
                self._supports(passed)
            else:
                self._crowd(passed)

    def _frames(self, passed: float, rate: float) -> int:
        """Return how many frames of `rate` pass in so much time; the rest is owed."""
        session = self._session
        if session.paused:
            return 0
        self._owed += passed * session.speed * rate
        # Real time and its pictures drift apart by less than a frame: then one each is smoothest.
        if session.speed == 1.0 and rate * FRAME == 1.0 and abs(self._owed - 1.0) < 0.6:
            self._owed = 0.9 * max(min(self._owed - 1.0, 0.5), -0.5)
            return 1
        whole = max(int(self._owed), 0)
        self._owed -= whole
        return min(whole, int(MOST_BEHIND * rate))

    def _stage(self, passed: float) -> None:
        session, scene = self._session, self._scene
        stage = session.stage
        performer, ghost = stage.performer, stage.ghost
        if performer is None or ghost is None:
            return
        self._draw_body(performer)
        for _ in range(self._frames(passed, stage.take.scenario.fps)):
            self._remember(performer, ghost)
            stage.advance()
            self._replay()
            if stage.begun:
                scene.print_feet(performer)
        if session.script and not stage.begun:
            self._replay()
        performer, ghost = stage.pair()
        with scene.atomic():
            planted = (performer.support.left, performer.support.right)
            scene.pose_body(*self._pose(performer), planted)
            if session.ghost:
                scene.pose_ghost(*self._pose(ghost))
            scene.follow(self._below(performer), passed)
            scene.show_ground(performer.ground, performer.clock)
            scene.show_only(ghost=session.ghost, prints=True, crowd=False)
        if self._ticks % 2 == 0:
            session.tell(tick_json(stage))

    def _replay(self) -> None:
        session = self._session
        stage = session.stage
        assert stage.performer is not None
        for cue in due_cues(session.script, stage.performer.clock, stage.begun):
            try:
                obey_cue(stage, cue)
            except FootfallError as error:
                session.notice(str(error))

    def _remember(self, *performers: Performer) -> None:
        self._before = {id(one): (one.positions.copy(), one.rotations.copy()) for one in performers}

    def _pose(self, performer: Performer) -> Pose:
        """Return a pose to show: in slow motion, one between the last two frames."""
        before = self._before.get(id(performer))
        share = min(max(self._owed, 0.0), 1.0)
        if before is None or self._session.speed == 1.0:
            return performer.positions, performer.rotations
        positions = between(before[0], performer.positions, share)
        return positions, between(before[1], performer.rotations, share)

    def _below(self, performer: Performer) -> Positions:
        """Return what is looked at: the ground where the body is, were there no steps in it."""
        place = performer.positions[0]
        floor = performer.floor + self._session.stage.ground.height
        return np.array([place[0], float(performer.heights(place)) - floor, place[2]])

    def _floor(self, editor: SupportEditor) -> Plane:
        """Return the ground of the clip that is edited, the same one as long as it is."""
        if self._clip_floor is None or self._clip_floor[0] is not editor:
            height = float(np.percentile(editor.opinion.ground, 5.0))
            self._clip_floor = (editor, Plane(height))
        return self._clip_floor[1]

    def _draw_body(self, performer: Performer) -> None:
        if self._drawn_body == self._session.body_count:
            return
        self._drawn_body = self._session.body_count
        self._before = {}
        self._owed = 0.0
        self._scene.show_body(performer.skeleton, performer.anatomy, self._session.skin)
        self._scene.follow(self._below(performer), 0.0, at_once=True)

    def _supports(self, passed: float) -> None:
        session, scene, editor = self._session, self._scene, self._session.editor
        if editor is None:
            return
        clip = editor.clip
        if self._clip_poses is None or self._clip_poses[0] is not clip:
            rotations, positions = clip.world_poses()
            self._clip_poses = (clip, positions, rotations)
        _, positions, rotations = self._clip_poses
        if self._drawn_body != session.body_count:
            self._drawn_body = session.body_count
            scene.show_body(clip.skeleton, find_anatomy(clip.skeleton))
            scene.follow(positions[0, 0] * LEVEL, 0.0, at_once=True)
        if session.clip_plays and not session.paused:
            session.clip_time += passed * session.speed
            if session.clip_time > clip.duration:
                session.clip_time %= max(clip.duration, 1e-6)
        place = min(session.clip_time * clip.fps, clip.frames - 1.0)
        frame = min(int(place), max(clip.frames - 2, 0))
        after = min(frame + 1, clip.frames - 1)
        share = place - frame
        support = editor.sequence.support_at(session.clip_time)
        pose = between(positions[frame], positions[after], share)
        with scene.atomic():
            scene.pose_body(
                pose,
                between(rotations[frame], rotations[after], share),
                (support.left, support.right),
            )
            scene.follow(pose[0] * LEVEL, passed)
            scene.show_ground(self._floor(editor), 0.0)
            scene.show_only(ghost=False, prints=False, crowd=False)
        if self._ticks % 2 == 0:
            session.tell({"kind": "clock", "time": round(session.clip_time, 4)})

    def _crowd(self, passed: float) -> None:
        session, scene, crowd = self._session, self._scene, self._session.crowd
        if crowd is None:
            return
        if self._drawn_crowd != session.crowd_count:
            self._drawn_crowd = session.crowd_count
            scene.show_crowd(crowd.skeleton, crowd.anatomy, crowd.size)
            scene.follow(np.zeros(3), 0.0, at_once=True)
        frames = self._frames(passed, RATE)
        for _ in range(frames):
            crowd.advance()
        if not frames and crowd.frame > 1:
            return
        shares = crowd.shares()
        with scene.atomic():
            scene.pose_crowd(crowd.positions, crowd.rotations, crowd.shifts())
            if crowd.frame % 6 < max(frames, 1) and scene.crowd is not None:
                scene.crowd.paint(crowd.colors(shares))
            scene.follow(np.zeros(3), passed)
            scene.show_ground(FIELD, 0.0)
            scene.show_only(ghost=False, prints=False, crowd=True)
        if crowd.frame % 3 < max(frames, 1):
            session.tell({"kind": "herd", "frame": crowd.frame, "shares": crowd.table(shares)})
