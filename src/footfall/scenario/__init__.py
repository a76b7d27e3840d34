"""A cue sheet: what starts and stops when."""

from footfall.scenario.cue_sheet import ActionEntry, Cue, Scenario, load_scenario, parse_scenario
from footfall.scenario.performance import Performance, StartCue, perform

__all__ = [
    "ActionEntry",
    "Cue",
    "Performance",
    "Scenario",
    "StartCue",
    "load_scenario",
    "parse_scenario",
    "perform",
]
