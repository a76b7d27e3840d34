"""The part of the comparison page that asks which foot is on the ground."""

from __future__ import annotations

from collections.abc import Sequence

from benchmarks.comparison.contacts import OURS, RULES, LabeledVerdicts, Verdict, pooled
from benchmarks.comparison.page import markdown_table

TOLD = """
## Which foot is on the ground

Detection beside the fixed rules of published tools, each on ankle and toe as those use them. Wrong:
share of feet and frames. Missed / invented: landings and releases that are not found within 67 ms,
and such as are not there. The squared step is made for 20 frames a second.

On the samples, whose supports are known exactly, with 2 mm of noise on the feet:

"""

LABELED = """
On {clips} captured clips whose supports were labeled by eye (`tests/detection/labels`). With those
of the first table at hand ours was made; those of the second were labeled when it was done, and
nothing was changed for them.
"""

HEADINGS = ["", *RULES]


def contacts_section(
    samples: Sequence[tuple[float, dict[str, Verdict]]], clips: Sequence[LabeledVerdicts]
) -> str:
    """Return the tables of contact detection."""
    rows = [[f"{fps:.0f} frames a second", *_cells(each)] for fps, each in samples]
    parts = [TOLD, markdown_table(HEADINGS, rows)]
    if clips:
        parts.append(LABELED.format(clips=len(clips)))
        for at_hand in (True, False):
            some = [one for one in clips if one.at_hand == at_hand]
            rows = [[f"{one.name}, {one.fps:.0f} fps", *_cells(one.verdicts)] for one in some]
            every = {rule: pooled([one.verdicts[rule] for one in some]) for rule in RULES}
            rows.append(["**all**", *_cells(every)])
            parts.append("\n" + markdown_table(HEADINGS, rows))
        parts.append(_where_not_least(clips))
    return "".join(parts)


def _cells(each: dict[str, Verdict]) -> list[str]:
    return [
        f"{100.0 * each[rule].wrong:.1f} %, {each[rule].missed} / {each[rule].invented} "
        f"of {each[rule].there}"
        for rule in RULES
    ]


def _where_not_least(clips: Sequence[LabeledVerdicts]) -> str:
    """Return on which clips another rule is wrong less often, by which share of feet and frames."""
    told: list[str] = []
    for one in clips:
        best = min(RULES, key=lambda rule: one.verdicts[rule].wrong)
        if best != OURS:
            own, other = (100.0 * one.verdicts[rule].wrong for rule in (OURS, best))
            told.append(f"{one.name} (`{best}`: {other:.1f} %, ours {own:.1f} %)")
    least = f"\nOurs is wrong least on {len(clips) - len(told)} of {len(clips)} clips"
    return f"{least}; not on {', '.join(told)}.\n" if told else f"{least}.\n"
