"""The cues of a scenario given at their very times, and every frame kept."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from footfall.adaptation import AnyGround
from footfall.engine import Character, Impossible, Waiting
from footfall.engine.recording import Recorder, Recording
from footfall.scenario.cue_sheet import Scenario
from footfall.scenario.entries import Cue
from footfall.scenario.moving_ground import MovingGround

__all__ = ["Play", "StartCue", "with_muting"]

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

    impossible: bool = False
    """Whether it could never have started beside those that ran then."""

    muted: float = 0.0
    """How long it went on without its legs after it started [s]."""

    def to_json(self) -> dict[str, object]:
        """Return the fields by name for a report."""
        return {
            "action": self.action,
            "commanded": round(self.commanded, 6),
            "actual": None if self.actual is None else round(self.actual, 6),
            "reason": self.reason,
            "impossible": self.impossible,
            "muted": round(self.muted, 6),
        }


class Play:
    """A character, its cues, and what has become of them."""

    def __init__(self, character: Character, scenario: Scenario, ground: float) -> None:
        self.character = character
        self.ground = MovingGround(ground)
        self.lifts: list[float] = []
        self.grounds: list[AnyGround] = []
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
            # A cue moves the ground from the next frame on, as it does where a hand gives it.
            if frame > 0 and self.ground.advance(1.0 / fps, self.character.root):
                self._exchange_ground()
            while cues and cues[0].at <= time + _SAME:
                cue = cues.pop(0)
                self._advance(cue.at)
                self._command(cue)
            self._advance(time)
            self.lifts.append(self.ground.height)
            self.grounds.append(self.character.crowd.ground)
            if frame == 0:
                self.character.advance(0.0)
            recorder.keep()
        recording = recorder.finish()
        return recording, with_muting(self.starts, recording)

    def _advance(self, time: float) -> None:
        if time - self.clock > _SAME:
            self.character.advance(time - self.clock)
            self.clock = time
        for action in [name for name in self.waiting if not self.character.is_waiting(name)]:
            index = self.waiting.pop(action)
            self.starts[index] = replace(self.starts[index], actual=self.clock)

    def _exchange_ground(self) -> None:
        self.character.crowd.exchange_ground(self.ground.ground, rise=self.ground.rise)

    def _command(self, cue: Cue) -> None:
        if cue.kind == "stop":
            self.waiting.pop(cue.action, None)
            self.character.stop(cue.action)
        elif cue.kind == "ground":
            self.ground.ask(cue.ground, self.character.root)
        elif cue.kind == "speed":
            self.character.set_parameters(cue.action, speed=cue.parameter)
        elif cue.kind == "turn":
            self.character.set_parameters(cue.action, turn=cue.parameter)
        elif cue.kind == "layer" and cue.parameter > 0.0:
            self.character.start_layer(cue.action, weight=cue.parameter)
        elif cue.kind == "layer":
            self.character.stop_layer(cue.action)
        elif cue.kind == "priority":
            assert cue.priority is not None
            self.character.set_priority(cue.action, cue.priority)
        else:
            answer = self.character.start(cue.action)
            if isinstance(answer, Waiting):
                self.waiting[cue.action] = len(self.starts)
                impossible = isinstance(answer, Impossible)
                self.starts.append(StartCue(cue.action, cue.at, None, answer.reason, impossible))
            else:
                self.starts.append(StartCue(cue.action, cue.at, answer.at))


def with_muting(starts: Sequence[StartCue], recording: Recording) -> tuple[StartCue, ...]:
    """Return the starts with how long each went on without its legs, up to the next of it."""
    told: list[StartCue] = []
    for index, start in enumerate(starts):
        if start.actual is None:
            told.append(start)
            continue
        nexts = (one.actual for one in starts[index + 1 :] if one.action == start.action)
        end = next((moment for moment in nexts if moment is not None), math.inf)
        times = np.arange(recording.frames) / recording.fps
        its = (times >= start.actual - _SAME) & (times < end - _SAME)
        muted = recording.muted[its, recording.actions.index(start.action)]
        told.append(replace(start, muted=float(muted.sum()) / recording.fps))
    return tuple(told)
