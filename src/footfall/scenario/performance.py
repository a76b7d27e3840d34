"""Play a cue sheet: every cue at its very time, every frame kept."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby

import numpy as np

from footfall.adaptation import Plane
from footfall.arrays import Supports
from footfall.engine import Character, MotionLibrary, Waiting
from footfall.engine.recording import Recorder, Recording
from footfall.errors import FootfallError, ScenarioError
from footfall.motion import extract_root_path, with_soles
from footfall.scenario.cue_sheet import Cue, Scenario
from footfall.scenario.motions import Motion, body_of, resolve_motion
from footfall.skeleton import Anatomy, find_anatomy
from footfall.support import Support, SupportPhase, SupportSequence
from footfall.sync.tables import Planner

__all__ = ["Performance", "StartCue", "load_motions", "perform", "played_supports", "support_text"]

_SAME = 1e-9
"""Two times this near are the same [s]."""


@dataclass(frozen=True, slots=True)
class StartCue:
    """A start command and what became of it."""

    action: str
    """What was to start."""

    commanded: float
    """When [s]."""

    actual: float | None
    """When it did, to the next frame if it waited [s]; None if never."""

    reason: str = ""
    """Why it waited; empty if it did not."""

    def to_json(self) -> dict[str, object]:
        """Return the fields by name for a report."""
        return {
            "action": self.action,
            "commanded": round(self.commanded, 6),
            "actual": None if self.actual is None else round(self.actual, 6),
            "reason": self.reason,
        }


@dataclass(frozen=True, eq=False)
class Performance:
    """A cue sheet as it was played."""

    scenario: Scenario
    """The cue sheet."""

    recording: Recording
    """Every frame."""

    supports: Supports
    """What was commanded to carry the body, values of `Support`, shape (frames,); without
    synchronization what the heaviest motion stands on."""

    starts: tuple[StartCue, ...]
    """What became of each start command, in order of time."""

    motions: tuple[Motion, ...]
    """The motion of each action, in the order of the recording."""

    anatomy: Anatomy
    """Of the body that performed, its heels on the soles."""

    ground: float
    """Height of the ground [m]."""


def load_motions(scenario: Scenario) -> tuple[Motion, ...]:
    """Return the motion of each action; errors as of `resolve_motion`."""
    first = resolve_motion(scenario.actions[0], scenario)
    others = (resolve_motion(entry, scenario, first) for entry in scenario.actions[1:])
    return (first, *others)


def perform(
    scenario: Scenario,
    *,
    synchronized: bool = True,
    footprints: bool = True,
    planner: Planner | None = None,
    motions: tuple[Motion, ...] | None = None,
) -> Performance:
    """Play a cue sheet.

    The character begins where the first motion that is started begins, on that motion's floor:
    one motion alone comes out as it went in.

    Args:
        scenario: The cue sheet.
        synchronized: Whether supports are synchronized at all.
        footprints: Whether planted feet are held where they came down.
        planner: Instead of the scenario's.
        motions: As `load_motions` returns them, so as not to load them again.

    Raises:
        ScenarioError: If a motion cannot be used, or too many actions run together.
    """
    motions = load_motions(scenario) if motions is None else motions
    first = next((cue.action for cue in scenario.cues if cue.kind == "start"), None)
    names = [entry.name for entry in scenario.actions]
    leading = 0 if first is None else names.index(first)
    skeleton = body_of(scenario) or motions[0].clip.skeleton
    try:
        ground = _floor(motions[leading])
        character = Character(
            skeleton,
            ground=Plane(ground),
            planner=planner or scenario.planner,
            synchronized=synchronized,
            footprints=footprints,
        )
        _add_actions(character, scenario, motions)
        _place(character, motions[leading])
        recording, starts = _Stage(character, scenario).play()
    except FootfallError as error:
        raise ScenarioError(f"{scenario.path}: {error}") from error
    supports = recording.supports if synchronized else _heaviest(recording, motions)
    anatomy = with_soles(find_anatomy(skeleton), *motions[0].clip.world_poses())
    return Performance(scenario, recording, supports, starts, motions, anatomy, ground)


def support_text(supports: Supports) -> str:
    """Return one of R L D - a frame; flight where nothing was commanded that can be done."""
    return "".join(Support(int(value)).symbol for value in supports).replace("Err", "-")


def played_supports(performance: Performance) -> SupportSequence:
    """Return what carried the body, as a sequence that is played once and lasts as the clip."""
    text, fps = support_text(performance.supports), performance.recording.fps
    phases: list[SupportPhase] = []
    # The last frame is an instant: a clip of n frames lasts n - 1 of them.
    for symbol, group in groupby(text[:-1] or text):
        seconds = len(list(group)) / fps
        phases.append(SupportPhase(Support.from_symbol(symbol), seconds))
    return SupportSequence(tuple(phases))


def _floor(motion: Motion) -> float:
    """Return how high the feet of a motion rest [m]."""
    library = MotionLibrary()
    library.add("floor", motion.clip, motion.supports)
    return float(library.actions[0].packed.floor)


def _heaviest(recording: Recording, motions: tuple[Motion, ...]) -> Supports:
    """Return what the motion of the greatest share stands on; both feet where none plays."""
    supports = np.full(recording.frames, int(Support.DOUBLE), dtype=np.int64)
    heaviest: list[int] = recording.shares.argmax(axis=1).tolist()
    for frame, action in enumerate(heaviest):
        time = float(recording.clip_times[frame, action])
        if recording.shares[frame, action] > 0.0 and np.isfinite(time):
            supports[frame] = int(motions[action].supports.support_at(time))
    return supports


def _add_actions(character: Character, scenario: Scenario, motions: tuple[Motion, ...]) -> None:
    for entry, motion in zip(scenario.actions, motions, strict=True):
        character.add(
            entry.name,
            motion.clip,
            motion.supports,
            priority=entry.priority,
            fade_in=entry.fade_in,
            fade_out=entry.fade_out,
        )


def _place(character: Character, motion: Motion) -> None:
    path = extract_root_path(motion.clip, find_anatomy(motion.clip.skeleton))
    (x, z), heading = path.positions[0], path.headings[0]
    character.place(float(x), float(z), float(heading))


class _Stage:
    """A character, its cues, and what has become of them."""

    def __init__(self, character: Character, scenario: Scenario) -> None:
        self.character = character
        self.scenario = scenario
        self.clock = 0.0
        self.starts: list[StartCue] = []
        self.waiting: dict[str, int] = {}

    def play(self) -> tuple[Recording, tuple[StartCue, ...]]:
        """Play every cue and frame."""
        fps = self.scenario.fps
        recorder = Recorder(self.character, fps)
        cues = list(self.scenario.cues)
        for frame in range(int(self.scenario.duration * fps + 1e-6) + 1):
            time = frame / fps
            while cues and cues[0].at <= time + _SAME:
                cue = cues.pop(0)
                self._advance(cue.at)
                self._command(cue)
            self._advance(time)
            if frame == 0:
                self.character.advance(0.0)
            recorder.keep()
        return recorder.finish(), tuple(self.starts)

    def _advance(self, time: float) -> None:
        if time - self.clock > _SAME:
            self.character.advance(time - self.clock)
            self.clock = time
        for action in [name for name in self.waiting if not self.character.is_waiting(name)]:
            index = self.waiting.pop(action)
            start = self.starts[index]
            self.starts[index] = StartCue(action, start.commanded, self.clock, start.reason)

    def _command(self, cue: Cue) -> None:
        if cue.kind == "stop":
            self.waiting.pop(cue.action, None)
            self.character.stop(cue.action)
        elif cue.kind == "priority":
            assert cue.priority is not None
            self.character.set_priority(cue.action, cue.priority)
        else:
            answer = self.character.start(cue.action)
            if isinstance(answer, Waiting):
                self.waiting[cue.action] = len(self.starts)
                self.starts.append(StartCue(cue.action, cue.at, None, answer.reason))
            else:
                self.starts.append(StartCue(cue.action, cue.at, answer.at))
