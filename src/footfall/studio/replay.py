"""A saved scenario opened again: its motions are loaded, and its cues given at their times."""

from __future__ import annotations

from typing import TYPE_CHECKING

from footfall.errors import ScenarioError
from footfall.scenario.cue_sheet import Cue, Scenario, load_scenario
from footfall.scenario.ground_change import GroundChange
from footfall.scenario.motions import Motion, body_of, resolve_motion
from footfall.studio.card import by_part
from footfall.studio.jobs import Job
from footfall.studio.motion_list import LoadedMotion
from footfall.studio.stage import Stage

if TYPE_CHECKING:
    from footfall.studio.session import Session

__all__ = ["due_cues", "frame_cues", "obey_cue", "open_scenario"]


BEFORE_START = ("ground", "speed", "turn")
"""Cues that have an effect before anything was started."""


def open_scenario(session: Session, name: str) -> None:
    """Open a scenario of the folder, and let it be played on the stage.

    Raises:
        FileFormatError: If it lies elsewhere, or cannot be read.
        ScenarioError: If it is none.
    """
    path = session.folder.readable(name)
    scenario = load_scenario(path)
    if path.parent != session.folder.root:
        raise ScenarioError(
            f"{path}: the studio opens scenarios beside it; start it in {path.parent}"
        )
    if scenario.layers:
        raise ScenarioError(
            f"{path}: has the layer {scenario.layers[0].name!r}; the studio lays none, "
            "footfall blend does"
        )

    def work(job: Job) -> None:
        motions: list[Motion] = []
        for number, entry in enumerate(scenario.actions):
            job.report(number / len(scenario.actions), entry.name)
            motions.append(resolve_motion(entry, scenario))
        body = body_of(scenario)
        with session.lock:
            session.motions.motions = [
                LoadedMotion(entry, motion)
                for entry, motion in zip(scenario.actions, motions, strict=True)
            ]
            session.motions.body, session.skin = body, None
            session.stage.cards = []
            session.stage.asked = GroundChange()
            session.motions_changed()
            session.body = "own" if body is None else "of the scenario"
            session.script = frame_cues(scenario)
            session.view, session.paused = "stage", False
        session.notice(f"playing {path.name}")
        session.tell({"kind": "changed"})

    session.jobs.begin(f"opening {path.name}", work)


def frame_cues(scenario: Scenario) -> list[Cue]:
    """Return the cues of a scenario, those without effect before the first start left out."""
    cues = list(scenario.cues)
    first = next((i for i, cue in enumerate(cues) if cue.kind == "start"), len(cues))
    return [cue for i, cue in enumerate(cues) if i >= first or cue.kind in BEFORE_START]


def due_cues(script: list[Cue], clock: float, begun: bool) -> list[Cue]:
    """Take the cues off a script that are due at a clock time [s]; the first begins the take."""
    due: list[Cue] = []
    while script and (script[0].at <= clock + 1e-9 or not begun):
        begun = begun or script[0].kind == "start"
        due.append(script.pop(0))
    return due


def obey_cue(stage: Stage, cue: Cue) -> None:
    """Give a cue to the stage."""
    if cue.kind == "ground":
        stage.ask(cue.ground)
        return
    card = stage.card(cue.action)
    if card is None:
        return
    if cue.kind == "start":
        stage.start(card)
    elif cue.kind == "stop":
        stage.stop(card)
    elif cue.kind in ("speed", "turn"):
        asked = stage.gait(card)
        asked[cue.kind] = cue.parameter
        stage.steer(card, **asked)
    elif cue.priority is not None:
        stage.set_priority(card, by_part(cue.priority))
