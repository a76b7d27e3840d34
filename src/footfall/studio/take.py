"""A take: every command that was given, and when, written as a scenario that replays it."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace

from footfall.scenario.cue_sheet import ActionEntry, Cue, Scenario
from footfall.scenario.goal_fields import goal_table
from footfall.scenario.ground_change import GroundChange

__all__ = ["Take", "scenario_text"]


@dataclass(frozen=True)
class Take:
    """Commands in order of time; frames count from the first start."""

    scenario: Scenario
    """The actions, the rate and the body; its cues are those of the take."""

    def with_cue(self, cue: Cue) -> Take:
        """Return the take with one more command at its end."""
        return Take(replace(self.scenario, cues=(*self.scenario.cues, cue)))

    def until(self, seconds: float) -> Scenario:
        """Return a scenario that lasts so long [s], at least a frame."""
        return replace(self.scenario, duration=max(seconds, 1.0 / self.scenario.fps))


def scenario_text(scenario: Scenario) -> str:
    """Return a scenario as TOML that `footfall.scenario.cue_sheet` reads back, number by number."""
    lines = [f"fps = {scenario.fps!r}", f"duration = {scenario.duration!r}"]
    if scenario.planner != "footfall":
        lines.append(f"planner = {_quoted(scenario.planner)}")
    if scenario.body is not None:
        lines.append(f"body = {_quoted(scenario.body)}")
    used = {cue.action for cue in scenario.cues}
    for number, entry in enumerate(scenario.actions):
        # The first one is the body, and how it stands that does nothing.
        if entry.name in used or number == 0:
            lines += ["", "[[action]]", *_action_lines(entry)]
    for cue in scenario.cues:
        lines += ["", "[[cue]]", f"at = {cue.at!r}"]
        if cue.goal is not None:
            lines.append(f"{cue.kind} = {goal_table(cue.goal)}")
        elif cue.kind == "ground":
            lines.append(f"ground = {_ground(cue.ground)}")
        elif cue.kind == "priority":
            assert cue.priority is not None
            lines.append(f"priority = {{ {_quoted(cue.action)} = {_priority(cue.priority)} }}")
        elif cue.kind in ("speed", "turn"):
            lines.append(f"{cue.kind} = {{ {_quoted(cue.action)} = {cue.parameter!r} }}")
        else:
            lines.append(f"{cue.kind} = {_quoted(cue.action)}")
    return "\n".join(lines) + "\n"


def _action_lines(entry: ActionEntry) -> list[str]:
    lines = [
        f"name = {_quoted(entry.name)}",
        _motion_line(entry),
        f"priority = {_priority(entry.priority)}",
        f"fade_in = {entry.fade_in!r}",
        f"fade_out = {entry.fade_out!r}",
    ]
    for key, value in (("speed", entry.speed), ("turn", entry.turn)):
        if value is not None:
            lines.append(f"{key} = {value!r}")
    if entry.cyclic is not None:
        lines.append(f"cyclic = {str(entry.cyclic).lower()}")
    if entry.supports is not None:
        lines.append(f"supports = {_quoted(entry.supports)}")
    lines += [f"{flag} = true" for flag in ("mirror", "clean") if getattr(entry, flag)]
    if entry.crop is not None:
        lines.append(f"crop = [{entry.crop[0]!r}, {entry.crop[1]!r}]")
    return lines


def _motion_line(entry: ActionEntry) -> str:
    if not entry.others:
        return f"motion = {_quoted(entry.motion)}"
    return f"motions = [{', '.join(map(_quoted, (entry.motion, *entry.others)))}]"


def _ground(change: GroundChange) -> str:
    if change == GroundChange(change.height):
        return repr(change.height)
    slope = ", ".join(map(repr, change.slope))
    return f"{{ height = {change.height!r}, slope = [{slope}], kind = {_quoted(change.kind)} }}"


def _priority(priority: float | Mapping[str, float]) -> str:
    if isinstance(priority, Mapping):
        return "{ " + ", ".join(f"{part} = {value!r}" for part, value in priority.items()) + " }"
    return repr(priority)


def _quoted(text: str) -> str:
    # A JSON string is a TOML basic string, but for characters beyond the basic plane.
    return json.dumps(text, ensure_ascii=False)
