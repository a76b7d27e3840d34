"""A cue sheet: what starts and stops when, read from TOML and checked once.

Every message names the file and the key, what is wrong with it, and what would be right.
"""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, cast

from footfall.errors import FileFormatError, FootfallError, ScenarioError
from footfall.scenario.cue_sheet_fields import Fields
from footfall.scenario.cue_sheet_layers import layer_cues, read_layers
from footfall.scenario.entries import ActionEntry, Cue, LayerEntry
from footfall.scenario.ground_change import (
    GROUND_KINDS,
    HIGHEST,
    STEEPEST,
    GroundChange,
    GroundKind,
)
from footfall.sync.tables import Planner

__all__ = ["ActionEntry", "Cue", "LayerEntry", "Scenario", "load_scenario", "parse_scenario"]

LONGEST = 3600.0
"""Greatest duration of a scenario [s]."""

FASTEST = 1000.0
"""Greatest frame rate."""

FASTEST_GAIT = 20.0
"""Greatest speed [m/s], and turn [rad/s], of a gait."""

COMMANDS = ("start", "stop", "priority", "speed", "turn", "layer", "ground")
"""The keys of a cue, one of which it has."""

WHERE = 'a file beside the scenario or "sample:walk"'


@dataclass(frozen=True, slots=True)
class Scenario:
    """Motions, and commands in order of time."""

    path: Path
    """The file; its folder is where motions are looked for."""

    actions: tuple[ActionEntry, ...]
    """At least one."""

    cues: tuple[Cue, ...]
    """In order of time; those of one time in the order of the file."""

    fps: float = 60.0
    """Frames per second."""

    duration: float = 10.0
    """How long it is performed [s]."""

    planner: Planner = "footfall"
    """The default planner, or the paper's rule."""

    body: str | None = None
    """The motion whose skeleton performs; None: the first action's."""

    layers: tuple[LayerEntry, ...] = ()
    """What can be laid over the actions."""


def load_scenario(path: Path | str) -> Scenario:
    """Read a scenario.

    Raises:
        FileFormatError: If the file cannot be read or is no TOML.
        ScenarioError: If a key is unknown or not what it must be.
    """
    path = Path(path)
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise FileFormatError("there is no such file; check the name", path=path) from None
    except UnicodeDecodeError as error:
        raise FileFormatError(f"not UTF-8 text at byte {error.start}", path=path) from None
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise FileFormatError(f"cannot be read: {reason}", path=path) from None
    return parse_scenario(text, path)


def parse_scenario(text: str, path: Path | str = "scenario.toml") -> Scenario:
    """Read a scenario from its text; errors as of `load_scenario`.

    Args:
        text: The TOML.
        path: Its file, for messages and to find motions beside it.
    """
    path = Path(path)
    try:
        table: dict[str, Any] = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise _not_toml(str(error), path) from None
    try:
        return _scenario(Fields(table, ""), path)
    except FootfallError as error:
        raise ScenarioError(f"{path}: {error}") from error


def _not_toml(message: str, path: Path) -> FileFormatError:
    where = re.search(r" \(at line (\d+), column (\d+)\)$", message)
    if where is None:
        return FileFormatError(f"not TOML: {message[:1].lower() + message[1:]}", path=path)
    told = message[: where.start()]
    told = f"not TOML at column {where[2]}: {told[:1].lower() + told[1:]}"
    return FileFormatError(told, path=path, line=int(where[1]))


def _scenario(fields: Fields, path: Path) -> Scenario:
    fields.know("fps", "duration", "body", "planner", "action", "layer", "cue")
    duration = fields.number("duration", least=0.0, most=LONGEST, default=10.0, above=True)
    actions = tuple(_action(entry) for entry in fields.tables("action"))
    layers = read_layers(fields)
    names = [action.name for action in actions]
    laid = [layer.name for layer in layers]
    known = [*names, *laid]
    labels = [
        *(f"action[{i}]" for i in range(len(names))),
        *(f"layer[{i}]" for i in range(len(laid))),
    ]
    for index, name in enumerate(known):
        if name in known[:index]:
            raise ScenarioError(
                f"{labels[index]}.name is {name!r}, as is that of "
                f"{labels[known.index(name)]}; names must differ"
            )
    cues = [cue for entry in fields.tables("cue") for cue in _cues(entry, names, laid, duration)]
    return Scenario(
        path=path,
        actions=actions,
        cues=tuple(sorted(cues, key=lambda cue: cue.at)),
        fps=fields.number("fps", least=0.0, most=FASTEST, default=60.0, above=True),
        duration=duration,
        planner=cast(Planner, fields.choice("planner", ("footfall", "paper"))),
        body=fields.text("body", None),
        layers=layers,
    )


def _action(fields: Fields) -> ActionEntry:
    known = [slot for slot in ActionEntry.__slots__ if slot != "others"]
    fields.know(*known[:2], "motions", *known[2:])
    name = fields.needed_text("name", 'a name for cues, such as "walk"')
    if not fields.has("motions"):
        for key in ("speed", "turn"):
            if fields.has(key):
                raise ScenarioError(
                    f"{fields.label(key)} needs motions: a list of gaits that go at different "
                    f"ones, instead of motion"
                )
        motion, others = fields.needed_text("motion", WHERE), ()
    elif fields.has("motion"):
        raise ScenarioError(f"{fields.where} has motion and motions; give one of them")
    else:
        motion, *others = fields.texts("motions", WHERE)
        if not others:
            raise ScenarioError(f"{fields.label('motions')} is one; a gait needs two or more")
    return ActionEntry(
        name=name,
        motion=motion,
        others=tuple(others),
        speed=fields.maybe_number("speed", least=-FASTEST_GAIT, most=FASTEST_GAIT),
        turn=fields.maybe_number("turn", least=-FASTEST_GAIT, most=FASTEST_GAIT),
        priority=fields.priority("priority", 1.0),
        fade_in=fields.number("fade_in", least=0.0, most=60.0, default=0.3),
        fade_out=fields.number("fade_out", least=0.0, most=60.0, default=0.3),
        cyclic=fields.flag("cyclic", None),
        supports=fields.text("supports", None),
        mirror=bool(fields.flag("mirror", False)),
        crop=fields.stretch("crop"),
        clean=bool(fields.flag("clean", False)),
    )


def _cues(fields: Fields, names: list[str], laid: list[str], duration: float) -> list[Cue]:
    fields.know("at", *COMMANDS)
    at = fields.number("at", least=0.0, most=duration, default=None)
    commands = [key for key in COMMANDS if fields.has(key)]
    if len(commands) != 1:
        told = " and ".join(commands) or "no command"
        raise ScenarioError(
            f"{fields.where} has {told}; it must have one of {', '.join(COMMANDS[:-1])} "
            f"and {COMMANDS[-1]}"
        )
    if commands[0] == "priority":
        changes = fields.table("priority")
        return [
            Cue(at, "priority", changes.one_of(name, names), changes.priority(name, 1.0))
            for name in changes.names
        ]
    if commands[0] in ("speed", "turn"):
        kind = commands[0]
        changes = fields.table(kind)
        limit = FASTEST_GAIT
        return [
            Cue(
                at,
                kind,
                changes.one_of(name, names),
                parameter=changes.number(name, least=-limit, most=limit, default=None),
            )
            for name in changes.names
        ]
    if commands[0] == "layer":
        return layer_cues(fields, at, laid)
    if commands[0] == "ground":
        return [Cue(at, "ground", ground=_ground(fields))]
    kind = cast(Literal["start", "stop"], commands[0])
    action = fields.choice(kind, tuple(names))
    return [Cue(at, kind, action)]


def _ground(fields: Fields) -> GroundChange:
    """Return what a cue asks of the ground: a height [m] alone, or a table."""
    if not fields.is_table("ground"):
        height = fields.number("ground", least=-HIGHEST, most=HIGHEST, default=None)
        return GroundChange(height)
    asked = fields.table("ground")
    asked.know("height", "slope", "kind")
    kind = asked.choice("kind", GROUND_KINDS)
    return GroundChange(
        height=asked.number("height", least=-HIGHEST, most=HIGHEST, default=0.0),
        slope=asked.pair("slope", most=STEEPEST),
        kind=cast(GroundKind, kind),
    )
