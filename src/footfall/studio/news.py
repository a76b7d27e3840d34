"""What tabs are told of the whole session: when they open, and after a command."""

from __future__ import annotations

from typing import Any

from footfall.studio.bodies import GROUNDS, HIGHEST, LOWEST, STEEPEST, bodies_of
from footfall.studio.crowd_stage import GROUP_NAMES
from footfall.studio.session import Session
from footfall.studio.telling import card_json, clip_json, edit_json

__all__ = ["greet", "news", "state_json"]

Json = dict[str, Any]


def greet(session: Session) -> list[Json]:
    """Return what a new tab is told."""
    with session.lock:
        return [*news(session, "select"), session.crowd_json(), session.jobs_json()]


def news(session: Session, word: object) -> list[Json]:
    """Return what all tabs are told after a command."""
    told = [state_json(session)]
    if session.editor is not None and word in ("select", "view", "save", "option"):
        told += [clip_json(session.editor), edit_json(session.editor)]
    return told


def state_json(session: Session) -> Json:
    """Return everything but what changes from frame to frame."""
    loaded = {one.name: one for one in session.motions.motions}
    family = {one.name for one in session.motions.family}
    return {
        "kind": "state",
        "folder": str(session.folder.root),
        "files": session.motions.folder.motions(),
        "scenarios": session.motions.folder.scenarios(),
        "view": session.view,
        "paused": session.paused,
        "speed": session.speed,
        "ghost": session.ghost,
        "recording": session.stage.begun,
        "cards": [
            card_json(card, loaded[card.name], session.stage) for card in session.stage.cards
        ],
        "motions": [
            {
                "name": one.name,
                "motion": one.entry.motion,
                "mixes": one.name in family,
                "gait": bool(one.motion.others),
                "duration": round(one.motion.clip.duration, 3),
                "cyclic": one.motion.clip.cyclic,
                "clean": one.entry.clean,
                "mirror": one.entry.mirror,
            }
            for one in session.motions.motions
        ],
        "bodies": [*_body_names(session), *session.folder.bodies()],
        "body": session.body,
        "grounds": list(GROUNDS),
        "ground": session.stage.asked.kind,
        "lift": session.stage.asked.height,
        "lifts": [LOWEST, HIGHEST],
        "tilt": list(session.tilt),
        "tilts": [-STEEPEST, STEEPEST],
        "editing": None if session.editor is None else session.editor.name,
        "groups": list(GROUP_NAMES),
    }


def _body_names(session: Session) -> list[str]:
    """Return the bodies that need no file; that of a scenario only as long as it performs."""
    names = [body.name for body in bodies_of(session.motions.skeletons)]
    known = session.body in names or session.skin is not None
    return names if known or not names else [*names, session.body]
