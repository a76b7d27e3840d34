"""A cue sheet played: who plays which phase when, and who was held.

The picture is its schedule: a lane an action, an arrow a command.
"""

import sys
from pathlib import Path

from footfall.scenario.cue_sheet import parse_scenario
from footfall.scenario.performance import perform
from footfall.view import performance_timeline, timeline_svg

CUES = """
fps = 60
duration = 8.0
action = [
    { name = "walk", motion = "sample:walk" },
    { name = "kick", motion = "sample:kick", priority = 3.0 },
    { name = "punch", motion = "sample:punch", priority = { trunk = 3.0, arms = 4.0 } },
]
cue = [
    { at = 0.0, start = "walk" },
    { at = 1.37, start = "punch" },
    { at = 3.71, start = "kick" },
    { at = 4.03, stop = "walk" },
    { at = 5.91, start = "walk" },
]
"""


def main(folder: Path) -> None:
    """Play, and write the picture."""
    performance = perform(parse_scenario(CUES))
    for start in performance.starts:
        print(start)
    picture = timeline_svg(performance_timeline(performance))
    (folder / "03_cue_sheet.svg").write_text(picture, encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
