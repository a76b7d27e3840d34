"""What a page may say: a function a word, each reading its own fields strictly."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from footfall.errors import ArgumentError, FootfallError
from footfall.scenario.cue_sheet import FASTEST_GAIT
from footfall.studio.bodies import GROUNDS, HIGHEST, LOWEST, STEEPEST
from footfall.studio.card import PARTS, Card, by_part
from footfall.studio.crowd_stage import GROUP_NAMES
from footfall.studio.dressing import choose_body
from footfall.studio.editor import SupportEditor
from footfall.studio.exports import export
from footfall.studio.gaits import load_own_gait
from footfall.studio.loading import load, load_from_page, set_option
from footfall.studio.news import news
from footfall.studio.replay import open_scenario
from footfall.studio.said import Said
from footfall.studio.session import SPEEDS, Session
from footfall.studio.telling import edit_json

__all__ = ["COMMANDS", "handle"]

Json = dict[str, Any]
Command = Callable[[Session, Said], None]

GREATEST_PRIORITY, LONGEST_FADE, LARGEST_CROWD = 10.0, 5.0, 2000


def handle(session: Session, message: Json) -> list[Json]:
    """Obey one message, and return what its tab is answered; nothing it says ends the session."""
    word, answers = message.get("do"), list[Json]()
    command = COMMANDS.get(word) if isinstance(word, str) else None
    try:
        if command is None:
            raise ArgumentError(f"no command {word!r}; there are: {', '.join(sorted(COMMANDS))}")
        with session.lock:
            command(session, Said(message))
            if word in EDITS and session.editor is not None:
                session.tell(edit_json(session.editor))
            elif word not in QUIET:
                for one in news(session, word):
                    session.tell(one)
    except FootfallError as error:
        answers.append({"kind": "notice", "level": "error", "text": str(error)})
    except OSError as error:
        answers.append({"kind": "notice", "level": "error", "text": f"cannot be done: {error}"})
    if "id" in message:
        answers.append({"kind": "done", "id": message["id"]})
    return answers


def _card(session: Session, said: Said) -> Card:
    card = session.stage.card(said.text("name"))
    if card is None:
        raise ArgumentError(f"no action {said.text('name')!r} on this stage")
    return card


def _editor(session: Session) -> SupportEditor:
    if session.editor is None:
        raise ArgumentError("no motion is open in the editor; choose one")
    return session.editor


def _priority(session: Session, said: Said) -> None:
    card, part = _card(session, said), said.text("part")
    value = said.number("value", 0.0, GREATEST_PRIORITY)
    if part != "all" and part not in PARTS:
        raise ArgumentError(f"no body part {part!r}; there are: all, {', '.join(PARTS)}")
    wanted = by_part(value) if part == "all" else card.priority | {part: value}
    if not any(wanted.values()):
        raise ArgumentError("an action with no priority anywhere does nothing; keep one above 0")
    session.stage.set_priority(card, wanted)


def _speed(session: Session, said: Said) -> None:
    value = said.number("value", 0.0, 1.0)
    if value not in SPEEDS:
        raise ArgumentError(f"no speed {value}; there are: {', '.join(map(str, SPEEDS))}")
    session.speed = value


def _fades(session: Session, said: Said) -> None:
    fade_in, fade_out = (said.number(key, 0.0, LONGEST_FADE) for key in ("fadeIn", "fadeOut"))
    session.stage.set_fades(_card(session, said), fade_in, fade_out)


def _steer(session: Session, said: Said) -> None:
    speed, turn = (said.number(key, -FASTEST_GAIT, FASTEST_GAIT) for key in ("speed", "turn"))
    session.stage.steer(_card(session, said), speed, turn)


def _lift(session: Session, said: Said) -> None:
    session.stage.lift_to(said.number("value", LOWEST, HIGHEST))


def _tilt(session: Session, said: Said) -> None:
    ahead, aside = (said.number(key, -STEEPEST, STEEPEST) for key in ("ahead", "aside"))
    session.tilt = (ahead, aside)
    session.stage.tilt_to(ahead, aside)


def _ground(session: Session, said: Said) -> None:
    name = said.text("name")
    if name not in GROUNDS:
        raise ArgumentError(f"no ground {name!r}; there are: {', '.join(GROUNDS)}")
    session.stage.put(GROUNDS[GROUNDS.index(name)])


def _thresholds(session: Session, said: Said) -> None:
    _editor(session).set_thresholds(
        said.number("height", 0.001, 2.0), said.number("speed", 0.001, 20.0)
    )


def _drag(session: Session, said: Said) -> None:
    side = said.text("side")
    if side not in ("start", "end"):
        raise ArgumentError(f"no side {side!r}; there are: start, end")
    _editor(session).drag(
        said.count("foot", 0, 1),
        said.count("band", 0, 10_000),
        side,
        said.number("time", -1e4, 1e4),
    )


def _split(session: Session, said: Said) -> None:
    foot, time = said.count("foot", 0, 1), said.number("time", 0.0, 1e4)
    _editor(session).edit(lambda bands: bands.with_split(foot, time))


def _delete(session: Session, said: Said) -> None:
    foot, band = said.count("foot", 0, 1), said.count("band", 0, 10_000)
    _editor(session).edit(lambda bands: bands.without(foot, band))


def _add(session: Session, said: Said) -> None:
    foot = said.count("foot", 0, 1)
    start, end = said.number("start", 0.0, 1e4), said.number("end", 0.0, 1e4)
    _editor(session).edit(lambda bands: bands.with_band(foot, start, end))


def _seek(session: Session, said: Said) -> None:
    session.clip_time = said.number("time", 0.0, 1e4)
    session.clip_plays = False


def _crowd(session: Session, said: Said, verb: str) -> None:
    crowd, name = session.crowd, said.text("name")
    group = said.count("group", 0, len(GROUP_NAMES) - 1)
    if crowd is None or name not in crowd.names:
        raise ArgumentError(f"no action {name!r} in this crowd")
    (crowd.start if verb == "start" else crowd.stop)(name, group)


def _gather(session: Session, said: Said) -> None:
    session.crowd_size = said.count("size", 1, LARGEST_CROWD)
    session.gather()


def _set(name: str) -> Command:
    def command(session: Session, said: Said) -> None:
        setattr(session, name, said.flag("on"))

    return command


COMMANDS: dict[str, Command] = {
    "view": lambda session, said: session.show(said.text("view")),
    "start": lambda session, said: session.stage.start(_card(session, said)),
    "stop": lambda session, said: session.stage.stop(_card(session, said)),
    "toggle": lambda session, said: session.stage.toggle(_card(session, said)),
    "priority": _priority,
    "fades": _fades,
    "steer": _steer,
    "gait": lambda session, _: load_own_gait(session),
    "news": lambda _session, _said: None,
    "pause": _set("paused"),
    "ghost": _set("ghost"),
    "speed": _speed,
    "restart": lambda session, _: session.restart(),
    "lift": _lift,
    "tilt": _tilt,
    "ground": _ground,
    "body": lambda session, said: choose_body(session, said.text("name")),
    "load": lambda session, said: load_from_page(session, said.text("file")),
    "load-all": lambda session, _: load(session, session.folder.motions()),
    "remove": lambda session, said: session.remove(said.text("name")),
    "option": lambda session, said: set_option(
        session, said.text("name"), said.text("option"), said.flag("on")
    ),
    "open": lambda session, said: open_scenario(session, said.text("file")),
    "export": lambda session, said: export(session, said.text("form"), said.text("name")),
    "cancel": lambda session, said: session.jobs.cancel(said.count("number", 0, 10**9)),
    "select": lambda session, said: session.select(said.text("name")),
    "drag": _drag,
    "release": lambda session, _: _editor(session).release(),
    "split": _split,
    "delete": _delete,
    "add": _add,
    "undo": lambda session, _: _editor(session).undo(),
    "redo": lambda session, _: _editor(session).redo(),
    "adopt": lambda session, _: _editor(session).adopt(),
    "discard": lambda session, _: _editor(session).discard(),
    "thresholds": _thresholds,
    "own-thresholds": lambda session, _: _editor(session).set_thresholds(None, None),
    "save": lambda session, _: session.save_supports(),
    "seek": _seek,
    "play": _set("clip_plays"),
    "gather": _gather,
    "crowd-start": lambda session, said: _crowd(session, said, "start"),
    "crowd-stop": lambda session, said: _crowd(session, said, "stop"),
}
"""Every word a page may say."""

EDITS = frozenset(
    {"drag", "release", "split", "delete", "add", "undo", "redo", "adopt", "discard",
     "thresholds", "own-thresholds"}
)  # fmt: skip
"""Those that change what the editor shows, and nothing else."""

QUIET = frozenset(
    {"seek", "steer", "crowd-start", "crowd-stop", "cancel", "load", "load-all", "gait"}
)
"""Those after which nothing else is to be told."""
