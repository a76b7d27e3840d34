"""The default planner against the paper's rule, on the same pairs in the same run."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from footfall.report.schedule_play import pairs_of, play_pair
from footfall.report.schedule_score import score_pairs, score_table
from footfall.support import Support, SupportPhase, SupportSequence

CASES = Path(__file__).parents[3] / "shared" / "cases" / "realistic.json"
WALK = SupportSequence.parse("R.4 D.1 L.4 D.1*")


def realistic() -> dict[str, SupportSequence]:
    return {
        name: SupportSequence(
            tuple(SupportPhase(Support.from_symbol(s), d) for s, d in case["phases"]),
            case["cyclic"],
        )
        for name, case in json.loads(CASES.read_text()).items()
    }


@pytest.mark.parametrize("planner", ["paper", "footfall"])
def test_two_alike_are_perfect(planner: str) -> None:
    score = score_pairs([play_pair(WALK, WALK, 0, (0.7, 0.3), planner)])  # pyright: ignore[reportArgumentType]
    assert score.octaves == pytest.approx(0.0, abs=1e-9)
    assert (score.disagreement, score.taps, score.holds, score.muted) == (0.0, 0.0, 0.0, 0.0)


def test_the_paper_stretches_a_walk_to_a_long_stand() -> None:
    # S-21: each double support of two seconds votes in full beside every phase of the walk.
    stand = SupportSequence.parse("D2")
    pair = play_pair(WALK, stand, 0, (0.5, 0.5), "paper")
    assert pair.durations == pytest.approx([1.2])
    ours = play_pair(WALK, stand, 0, (0.5, 0.5), "footfall")
    assert ours.durations[:3] == pytest.approx([0.4, 0.1, 0.4])


def test_disagreement_counts_the_even_split_of_a_foot() -> None:
    right = SupportSequence.parse("R1 D1")
    score = score_pairs([play_pair(right, SupportSequence.parse("D1 R1"), 0, (0.5, 0.5), "paper")])
    # The left foot is planted by one of the two all the time.
    assert score.disagreement == pytest.approx(1.0)


@pytest.mark.skipif(not CASES.is_file(), reason="the realistic cases lie outside the project")
def test_the_default_planner_beats_the_rule_of_the_paper(
    capsys: pytest.CaptureFixture[str],
) -> None:
    sequences = realistic()
    assert len(list(pairs_of(sequences))) == 1_191
    text, scores = score_table(sequences)
    with capsys.disabled():
        print("\n" + text)
    paper, ours = scores[0.7, 0.3]
    assert paper.octaves == pytest.approx(0.404, abs=0.001)
    assert paper.disagreement == pytest.approx(0.676, abs=0.001)
    assert ours.octaves <= 0.5 * paper.octaves
    assert ours.disagreement <= 0.62 * paper.disagreement
    assert ours.flight_p95 <= 1.45
    assert ours.taps <= 0.02
    assert ours.muted == 0.0
