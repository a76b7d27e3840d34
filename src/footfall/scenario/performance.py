"""Play a cue sheet: every cue at its very time, every frame kept."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby

import numpy as np

from footfall.adaptation import AnyGround
from footfall.arrays import Floats, Supports, frozen
from footfall.baselines import Pacing
from footfall.engine.recording import Recording
from footfall.errors import FootfallError, ScenarioError
from footfall.motion import with_soles
from footfall.scenario.cue_sheet import Scenario
from footfall.scenario.motions import Motion, resolve_motion
from footfall.scenario.playing import Play, StartCue
from footfall.scenario.preparation import prepare_character
from footfall.skeleton import Anatomy, find_anatomy
from footfall.support import Support, SupportPhase, SupportSequence
from footfall.sync.tables import Planner

__all__ = [
    "Performance",
    "StartCue",
    "load_motions",
    "perform",
    "played_supports",
    "support_text",
]


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
    """Height of the ground at first [m]."""

    lifts: Floats
    """How far it has risen since, tilting apart, shape (frames,) [m]."""

    grounds: tuple[AnyGround, ...]
    """What the character stood on in each frame."""


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
    pacing: Pacing | None = None,
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
        pacing: What keeps the clips in step instead, without synchronization or footprints.
        motions: As `load_motions` returns them, so as not to load them again.

    Raises:
        ScenarioError: If a motion cannot be used, or too many actions run together.
    """
    motions = load_motions(scenario) if motions is None else motions
    try:
        character, ground = prepare_character(
            scenario,
            motions,
            _leading(scenario),
            planner=planner,
            synchronized=synchronized,
            footprints=footprints,
            pacing=pacing,
        )
        stage = Play(character, scenario, ground)
        recording, starts = stage.play()
    except FootfallError as error:
        raise ScenarioError(f"{scenario.path}: {error}") from error
    planned = synchronized and pacing is None
    supports = recording.supports if planned else _heaviest(recording, motions)
    shown = character.library.actions[0].clip
    anatomy = with_soles(find_anatomy(character.skeleton), *shown.world_poses())
    return Performance(
        scenario=scenario,
        recording=recording,
        supports=supports,
        starts=starts,
        motions=motions,
        anatomy=anatomy,
        ground=ground,
        lifts=frozen(stage.lifts),
        grounds=tuple(stage.grounds),
    )


def _leading(scenario: Scenario) -> int:
    """Return the action that is started first, or else the first one."""
    first = next((cue.action for cue in scenario.cues if cue.kind == "start"), None)
    names = [entry.name for entry in scenario.actions]
    return 0 if first is None else names.index(first)


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


def _heaviest(recording: Recording, motions: tuple[Motion, ...]) -> Supports:
    """Return what the motion of the greatest share stands on; both feet where none plays."""
    supports = np.full(recording.frames, int(Support.DOUBLE), dtype=np.int64)
    heaviest: list[int] = recording.shares.argmax(axis=1).tolist()
    for frame, action in enumerate(heaviest):
        time = float(recording.clip_times[frame, action])
        if recording.shares[frame, action] > 0.0 and np.isfinite(time):
            supports[frame] = int(motions[action].supports.support_at(time))
    return supports
