"""What the page is told, as plain values for JSON."""

from __future__ import annotations

from typing import Any

import numpy as np

from footfall.detection import Interval
from footfall.engine.inspection import ActionState
from footfall.scenario.motions import SAMPLE
from footfall.studio.bands import Bands
from footfall.studio.card import Card
from footfall.studio.editor import SupportEditor
from footfall.studio.motion_list import LoadedMotion
from footfall.studio.performer import Performer
from footfall.studio.stage import Stage
from footfall.support import Support

__all__ = ["bands_json", "card_json", "clip_json", "edit_json", "symbol", "tick_json"]

HELD_RATE = 0.9
"""A phase that is held, or runs slower than this, is told as held."""

Json = dict[str, Any]


def card_json(card: Card, loaded: LoadedMotion, stage: Stage) -> Json:
    """Return a card's settings."""
    supports, others = loaded.motion.supports, loaded.entry.others
    names = [name.removeprefix(SAMPLE) for name in (loaded.entry.motion, *others)]
    return {
        "name": card.name,
        "priority": card.priority,
        "fadeIn": card.fades[0],
        "fadeOut": card.fades[1],
        "supports": ", ".join(names) if others else str(supports),
        "cyclic": supports.cyclic,
        "gait": _gait(card, stage),
    }


def _gait(card: Card, stage: Stage) -> Json | None:
    """Return from where to where a gait goes; None: it is one motion."""
    spans = stage.pair()[0].reach(card.action)
    return None if spans is None else {"speeds": spans[0], "turns": spans[1]}


def tick_json(stage: Stage) -> Json:
    """Return what the stage does now."""
    performer, ghost = stage.performer, stage.ghost
    assert performer is not None
    assert ghost is not None
    states = performer.states()
    actions = [
        _action(card, states[stage.action_index(card)]) | _going(card, stage)
        for card in stage.cards
    ]
    # A motion whose fades were changed while it played is still there under its old name.
    for index, state in enumerate(states):
        if state.activity == "idle" or index in {stage.action_index(c) for c in stage.cards}:
            continue
        name = stage.motion_name(index)
        for action in actions:
            if action["name"] == name and action["activity"] == "idle":
                action |= _state(state, "")
    return {
        "kind": "tick",
        "clock": round(performer.clock, 4),
        "begun": stage.begun,
        "support": symbol(performer.support),
        "actions": actions,
        "ahead": _ahead(stage, performer),
        "slip": [round(1000.0 * float(value), 1) for value in performer.slip.slid],
        "slipTotal": round(1000.0 * performer.slip.total, 1),
        "ghostSlip": round(1000.0 * ghost.slip.total, 1),
        "lift": round(stage.ground.height, 3),
        "tilt": [round(100.0 * value, 1) for value in stage.tilt],
    }


def _action(card: Card, state: ActionState) -> Json:
    return {"name": card.name} | _state(state, card.reason)


def _going(card: Card, stage: Stage) -> Json:
    """Return the speed and the turn of a gait, and those it was asked for."""
    performer = stage.pair()[0]
    if performer.reach(card.action) is None:
        return {}
    values = (*performer.gait(card.action), *stage.gait(card).values())
    return {"gait": [round(value, 3) for value in values]}


def _state(state: ActionState, reason: str) -> Json:
    slow = 0.0 < state.rate < HELD_RATE
    return {
        "activity": state.activity,
        "weight": round(state.weights[0], 3),
        "most": round(max(state.weights), 3),
        "progress": round(state.progress, 3),
        "rate": round(state.rate, 3),
        "phase": state.phase,
        "support": None if state.support is None else symbol(state.support),
        "held": state.held or slow,
        "reason": state.reason or (reason if state.activity == "waiting" else ""),
    }


def _ahead(stage: Stage, performer: Performer) -> list[Json]:
    cards = [stage.action_index(card) for card in stage.cards]
    return [
        {
            "start": round(slot.start, 4),
            "duration": round(slot.duration, 4),
            "support": symbol(slot.result),
            "lanes": [
                None if slot.supports[i] is None else symbol(slot.supports[i]) for i in cards
            ],
            "held": [slot.held[i] for i in cards],
        }
        for slot in performer.planned()
    ]


def symbol(support: Support | None) -> str:
    """Return one of R L D -; a conflict is told as an exclamation mark."""
    return "" if support is None else support.symbol.replace("Err", "!")


def clip_json(editor: SupportEditor) -> Json:
    """Return the curves of the clip that is edited: what never changes while it is."""
    opinion, clip = editor.opinion, editor.clip
    return {
        "kind": "clip",
        "name": editor.name,
        "duration": clip.duration,
        "fps": clip.fps,
        "cyclic": clip.cyclic,
        "file": editor.file,
        "restored": editor.restored,
        "heights": np.round(opinion.heights.T, 4).tolist(),
        "speeds": np.round(opinion.speeds.T, 3).tolist(),
        "ownHeight": round(float(opinion.height_limits.max()), 3),
        "ownSpeed": round(float(opinion.speed_limits.max()), 3),
    }


def edit_json(editor: SupportEditor) -> Json:
    """Return what edits change: bands, thresholds, the detector's opinion."""
    opinion = editor.opinion
    height, speed = float(opinion.height_limits.max()), float(opinion.speed_limits.max())
    return {
        "kind": "edit",
        "name": editor.name,
        "bands": bands_json(editor.bands),
        "opinion": [[_interval(one) for one in foot] for foot in opinion.intervals],
        "height": round(height if editor.height is None else editor.height, 4),
        "speed": round(speed if editor.speed is None else editor.speed, 3),
        "own": editor.height is None and editor.speed is None,
        "sequence": str(editor.sequence),
        "detected": str(editor.detected),
        "changed": editor.changed,
        "canUndo": editor.can_undo,
        "canRedo": editor.can_redo,
    }


def bands_json(bands: Bands) -> list[list[list[float]]]:
    """Return the bands of both feet."""
    return [[[round(one.start, 5), round(one.end, 5)] for one in foot] for foot in bands.feet]


def _interval(one: Interval) -> list[float]:
    values = (one.start, one.end, one.start_confidence, one.end_confidence)
    return [round(float(value), 4) for value in values]
