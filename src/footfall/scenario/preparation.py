"""A character as a scenario begins with it: its actions, its floor, its place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from footfall.adaptation import Plane
from footfall.baselines import PacedCharacter, Pacing
from footfall.engine import Character, MotionLibrary
from footfall.motion import Clip, extract_root_path
from footfall.scenario.cue_sheet import Scenario
from footfall.scenario.entries import ActionEntry
from footfall.scenario.layer_motions import add_layers
from footfall.scenario.motions import Motion, body_of
from footfall.skeleton import Skeleton, find_anatomy
from footfall.sync.tables import Planner

__all__ = ["add_action", "prepare_character"]


def prepare_character(
    scenario: Scenario,
    motions: tuple[Motion, ...],
    leading: int,
    *,
    body: Skeleton | None = None,
    planner: Planner | None = None,
    synchronized: bool = True,
    footprints: bool = True,
    clips: Sequence[Clip] | None = None,
    pacing: Pacing | None = None,
) -> tuple[Character, float]:
    """Return a character as `perform` begins with it, and the height of its ground [m].

    Args:
        scenario: Its actions and body.
        motions: As `load_motions` returns them.
        leading: The action on whose floor, and where whose motion begins, it stands.
        body: Instead of the scenario's.
        planner: Instead of the scenario's.
        synchronized: Whether supports are synchronized at all.
        footprints: Whether planted feet are held where they came down.
        clips: The motions as the body performs them, as the library of a character made them
            before; by default it makes them.
        pacing: What keeps the clips in step instead, without synchronization or footprints.
    """
    ground = _floor(motions[leading])
    skeleton = body or body_of(scenario) or motions[0].clip.skeleton
    if pacing is not None:
        character: Character = PacedCharacter(skeleton, pacing, ground=Plane(ground))
    else:
        character = Character(
            skeleton,
            ground=Plane(ground),
            planner=planner or scenario.planner,
            synchronized=synchronized,
            footprints=footprints,
        )
    made = clips or [motion.clip for motion in motions]
    for entry, motion, clip in zip(scenario.actions, motions, made, strict=True):
        add_action(character, entry, replace(motion, clip=clip))
    add_layers(character, scenario)
    _place(character, motions[leading])
    return character, ground


def add_action(character: Character | MotionLibrary, entry: ActionEntry, motion: Motion) -> None:
    """Let a character, or a library, know one more action; errors as of `Character.add`."""
    if motion.others:
        character.add_locomotion(
            entry.name,
            [(one.clip, one.supports) for one in (motion, *motion.others)],
            speed=entry.speed,
            turn=entry.turn,
            priority=entry.priority,
            fade_in=entry.fade_in,
            fade_out=entry.fade_out,
        )
        return
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


def _floor(motion: Motion) -> float:
    """Return how high the feet of a motion rest [m]."""
    library = MotionLibrary()
    library.add("floor", motion.clip, motion.supports)
    return float(library.actions[0].packed.floor)
