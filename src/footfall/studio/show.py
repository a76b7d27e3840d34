"""A character of a program or a notebook, steered in a studio of its own."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from footfall.engine import Character
from footfall.engine.action import Action
from footfall.errors import ArgumentError
from footfall.scenario.cue_sheet import ActionEntry
from footfall.scenario.motions import Motion
from footfall.studio.opening import open_studio

if TYPE_CHECKING:
    from footfall.studio.launch import Studio
    from footfall.studio.motion_list import LoadedMotion

__all__ = ["show_character"]


def show_character(character: Character) -> Studio:
    """Open a studio in which the motions and the body of a character are steered.

    What is steered performs beside the character, which itself stays as it is. In a notebook
    the studio that is returned shows itself.

    Raises:
        MissingViewerError: If the extra is not installed.
        ArgumentError: If the character has no action yet.
    """
    if not character.library.actions:
        raise ArgumentError("the character has no action yet; add one first")
    motions = [_loaded(action) for action in character.library.actions]
    studio = open_studio(port=0, motions=motions)
    with studio.session.lock:
        studio.session.motions.body = character.skeleton
        studio.session.restart()
    return studio


def _loaded(action: Action) -> LoadedMotion:
    """Return an action of a program as one that was loaded; its motions are in no file yet."""
    from footfall.studio.card import PARTS
    from footfall.studio.motion_list import LoadedMotion

    clips = action.gait or ((action.clip, action.supports),)
    first, *others = (Motion(clip, supports) for clip, supports in clips)
    speed, turn = action.parameters if action.gait else (None, None)
    entry = ActionEntry(
        action.name,
        f"{action.name}.npz",
        dict(zip(PARTS, action.priority.tolist(), strict=True)),
        action.fade_in,
        action.fade_out,
        others=tuple(f"{action.name} {number}.npz" for number in range(2, len(clips) + 1)),
        speed=speed,
        turn=turn,
    )
    return LoadedMotion(entry, replace(first, others=tuple(others)))
