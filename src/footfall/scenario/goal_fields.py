"""The goals of a cue sheet, read strictly and written back."""

from __future__ import annotations

from typing import cast, get_args

from footfall.engine.goal_setting import GOAL_NAMES, Hand
from footfall.errors import ScenarioError
from footfall.scenario.cue_sheet_fields import Fields
from footfall.scenario.goal_change import GoalChange, GoalKind

__all__ = ["goal_change", "goal_table"]

FARTHEST = 10_000.0
"""Greatest distance of a point from the origin along each axis [m]."""

WIDEST = 2.0
"""How far apart hands that join may be held [m]."""

LONGEST_FADE = 60.0
"""Longest fade of a goal [s]."""

OWN = {
    "reach": ("hand", "point"),
    "join_hands": ("apart",),
    "look_at": ("point",),
    "sit": ("height",),
    "drop": ("goal",),
}
"""The keys of each kind, beside those of its fade."""


def goal_change(kind: GoalKind, fields: Fields) -> GoalChange:
    """Return what a cue asks for.

    Args:
        kind: Its key.
        fields: The table behind it.

    Raises:
        ScenarioError: If a key is unknown or missing, or not what it must be.
    """
    fields.know(*_keys(kind))
    change, needed = GoalChange(kind), OWN[kind]
    for key, choices in (("hand", get_args(Hand)), ("goal", GOAL_NAMES)):
        if key in needed and not fields.has(key):
            raise ScenarioError(f"{fields.label(key)} is missing; there are: {', '.join(choices)}")
    return GoalChange(
        kind,
        hand=cast(Hand, fields.choice("hand", get_args(Hand))) if "hand" in needed else "left",
        point=fields.triple("point", most=FARTHEST) if "point" in needed else change.point,
        apart=fields.number("apart", least=0.0, most=WIDEST, default=change.apart),
        height=fields.number("height", least=-FARTHEST, most=FARTHEST, default=None)
        if "height" in needed
        else change.height,
        goal=fields.choice("goal", GOAL_NAMES) if "goal" in needed else "",
        weight=fields.number("weight", least=0.0, most=1.0, default=change.weight),
        fade=fields.number("fade", least=0.0, most=LONGEST_FADE, default=change.fade),
    )


def goal_table(change: GoalChange) -> str:
    """Return the table of a goal as TOML that `goal_change` reads back, number by number."""
    told: list[str] = []
    for key in _keys(change.kind):
        value = getattr(change, key)
        if key == "point":
            told.append(f"point = [{', '.join(map(repr, value))}]")
        else:
            told.append(f'{key} = "{value}"' if isinstance(value, str) else f"{key} = {value!r}")
    return f"{{ {', '.join(told)} }}"


def _keys(kind: GoalKind) -> tuple[str, ...]:
    return (*OWN[kind], *(("fade",) if kind == "drop" else ("weight", "fade")))
