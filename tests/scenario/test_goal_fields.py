"""Goals in a cue sheet: played as a character alone meets them, and replayed bit for bit."""

from __future__ import annotations

import numpy as np
import pytest

import footfall as ff
from footfall.scenario.cue_sheet import parse_scenario
from footfall.scenario.goal_change import GOAL_KINDS, GoalChange
from footfall.scenario.performance import load_motions, perform
from footfall.scenario.preparation import prepare_character
from footfall.studio.take import scenario_text

SHEET = """
duration = 3.0
[[action]]
name = "idle"
motion = "sample:idle"
[[cue]]
at = 0.0
start = "idle"
[[cue]]
at = 0.25
reach = { hand = "left", point = [0.3, 1.2, 0.35], weight = 0.9, fade = 0.5 }
[[cue]]
at = 0.4
look_at = { point = [2.0, 1.0, 3.0] }
[[cue]]
at = 1.0
sit = { height = 0.6 }
[[cue]]
at = 1.5
drop = { goal = "left hand" }
[[cue]]
at = 2.0
join_hands = { apart = 0.1 }
[[cue]]
at = 2.5
drop = { goal = "gaze", fade = 0.0 }
"""


def by_hand() -> ff.Character:
    """Return the character that the sheet is about, at its end."""
    scenario = parse_scenario(SHEET)
    hero, _ = prepare_character(scenario, load_motions(scenario), 0)
    hero.start("idle")
    hero.advance(0.0)
    tasks = {
        15: lambda: hero.goals.reach("left", (0.3, 1.2, 0.35), weight=0.9, fade=0.5),
        24: lambda: hero.goals.look_at((2.0, 1.0, 3.0)),
        60: lambda: hero.goals.sit(0.6),
        90: lambda: hero.goals.drop("left hand"),
        120: lambda: hero.goals.join_hands(0.1),
        150: lambda: hero.goals.drop("gaze", fade=0.0),
    }
    clock = 0.0
    for frame in range(1, 181):
        hero.advance(frame / 60.0 - clock)
        clock = frame / 60.0
        if frame in tasks:
            tasks[frame]()
    return hero


def test_cues_set_the_goals_of_the_character() -> None:
    recording = perform(parse_scenario(SHEET)).recording
    hero = by_hand()
    assert np.array_equal(recording.world_positions[-1], hero.crowd.world_positions[0])
    arm = hero.library.anatomy.arms[0]
    assert arm is not None
    wrist = recording.world_positions[:, arm.wrist]
    assert np.linalg.norm(wrist[55] - (0.3, 1.2, 0.35)) < np.linalg.norm(wrist[14] - wrist[55])
    hips = [leg.hip for leg in hero.library.anatomy.legs]
    assert recording.world_positions[118][hips, 1].mean() == pytest.approx(0.6, abs=1e-3)


def test_a_sheet_with_goals_is_replayed_bit_for_bit() -> None:
    scenario = parse_scenario(SHEET)
    again = parse_scenario(scenario_text(scenario))
    assert again.cues == scenario.cues
    one, other = perform(scenario).recording, perform(again).recording
    assert np.array_equal(one.world_positions, other.world_positions)
    assert np.array_equal(one.world_rotations, other.world_rotations)


@pytest.mark.parametrize("kind", GOAL_KINDS)
def test_every_kind_of_goal_is_written_as_it_is_read(kind: str) -> None:
    cues = parse_scenario(SHEET).cues
    goals = [cue.goal for cue in cues if cue.kind == kind]
    assert goals
    assert all(isinstance(goal, GoalChange) and goal.kind == kind for goal in goals)
