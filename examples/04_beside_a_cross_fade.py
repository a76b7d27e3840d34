"""The same cues by a plain cross-fade, by a blend tree, and by footfall.

The picture is the ground from above: red streaks are slides.
"""

import sys
from pathlib import Path

from footfall.baselines import EqualCycles
from footfall.report import performance_trace
from footfall.scenario.cue_sheet import parse_scenario
from footfall.scenario.performance import perform
from footfall.view import foot_traces_svg

CUES = """
duration = 7.0
action = [
    { name = "walk", motion = "sample:walk" },
    { name = "side", motion = "sample:side-step" },
]
cue = [
    { at = 0.0, start = "walk" },
    { at = 2.41, start = "side" },
    { at = 4.09, stop = "walk" },
]
"""


def main(folder: Path) -> None:
    """Play three times, and write the picture."""
    cues = parse_scenario(CUES)
    takes = {
        "cross-fade": perform(cues, synchronized=False),
        "cycles scaled to one length": perform(cues, pacing=EqualCycles()),
        "footfall": perform(cues),
    }
    traces = [(name, performance_trace(take)) for name, take in takes.items()]
    (folder / "04_beside_a_cross_fade.svg").write_text(foot_traces_svg(traces), encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
