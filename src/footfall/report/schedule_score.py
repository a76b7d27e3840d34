"""How good a schedule is: motions off their own speed, feet in disagreement, taps.

Two planners are compared by playing the same pairs of sequences with both.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import groupby

import numpy as np

from footfall.arrays import Floats
from footfall.report.schedule_play import PlayedPair, pairs_of, play_pair
from footfall.support import Support, SupportSequence

__all__ = ["ScheduleScore", "score_pairs", "score_table"]

SHORT = 0.1
"""A support that carries for less is a tap [s]."""


@dataclass(frozen=True, slots=True)
class ScheduleScore:
    """The score of many pairs together."""

    cases: int
    """How many pairs were played."""

    octaves: float
    """Mean |log2| of how many times as long as at its own speed each phase was played."""

    percentiles: tuple[float, float, float, float]
    """How many times as long: the 5th, 95th, 99th percentile and the greatest."""

    flight_p95: float
    """The 95th percentile over flights alone; 1 where nobody flies."""

    disagreement: float
    """Mean over time of the sum over both feet of 4 a (1 - a), a the share that plants it."""

    taps: float
    """Share of the supports of the blend that carry for less than `SHORT`."""

    holds: float
    """Weight of those who wait for another slot, summed over the slots, per case."""

    muted: float
    """Share of the time of all actions for which they are muted."""


def score_pairs(pairs: Iterable[PlayedPair]) -> ScheduleScore:
    """Score some pairs together; phases cut off by the end are left out."""
    stretches: list[float] = []
    flights: list[float] = []
    supports: list[float] = []
    doubt = seconds = holds = muted = playing = 0.0
    cases = 0
    for pair in pairs:
        cases += 1
        for action in range(2):
            for stretch, support, columns in _stretches(pair, action):
                stretches.append(stretch)
                flights += [stretch] if support is Support.FLIGHT else []
                holds += pair.weights[action] * (columns - 1)
        supports += _supports(pair)
        doubts = _disagreement(pair)
        doubt += float(doubts @ pair.durations)
        seconds += float(pair.durations.sum())
        muted += float(pair.muted.sum(axis=0) @ pair.durations)
        playing += 2.0 * float(pair.durations.sum())
    low, high, highest = np.percentile(stretches, [5.0, 95.0, 99.0])
    return ScheduleScore(
        cases=cases,
        octaves=float(np.abs(np.log2(stretches)).mean()),
        percentiles=(float(low), float(high), float(highest), max(stretches)),
        flight_p95=float(np.percentile(flights or [1.0], 95.0)),
        disagreement=doubt / seconds,
        taps=sum(lasting < SHORT - 1e-9 for lasting in supports) / max(len(supports), 1),
        holds=holds / cases,
        muted=muted / playing,
    )


def _stretches(pair: PlayedPair, action: int) -> Iterator[tuple[float, Support, int]]:
    """Return how many times as long each whole phase was played, its support, its slots."""
    slots = [slot for slot in range(len(pair.durations)) if pair.plays(action, slot)]
    runs = [list(run) for _, run in groupby(slots, lambda slot: pair.phases[action, slot])]
    for run in runs:
        if run[-1] + 1 < len(pair.durations):
            phase = pair.sequences[action].at(int(pair.phases[action, run[0]]))
            lasted = float(pair.durations[run].sum())
            yield lasted / phase.duration, phase.support, len(run)


def _supports(pair: PlayedPair) -> list[float]:
    """Return how long the blend stands on each support, but for the last one."""
    runs = groupby(range(len(pair.results)), pair.results.__getitem__)
    return [float(pair.durations[list(run)].sum()) for _, run in runs][:-1]


def _disagreement(pair: PlayedPair) -> Floats:
    """Return the sum over both feet of 4 a (1 - a) in each slot, shape (slots,)."""
    doubts = np.zeros(len(pair.durations))
    for slot in range(len(doubts)):
        total = left = right = 0.0
        for action, weight in enumerate(pair.weights):
            if pair.plays(action, slot):
                support = pair.sequences[action].at(int(pair.phases[action, slot])).support
                total += weight
                left += weight * support.left
                right += weight * support.right
        if total > 0.0:
            left, right = left / total, right / total
            doubts[slot] = 4.0 * (left * (1.0 - left) + right * (1.0 - right))
    return doubts


def score_table(
    sequences: Mapping[str, SupportSequence],
    weights: Iterable[tuple[float, float]] = ((0.7, 0.3), (0.5, 0.5)),
) -> tuple[str, dict[tuple[float, float], tuple[ScheduleScore, ScheduleScore]]]:
    """Play all pairs with both planners; return a table as text, and the scores behind it.

    Args:
        sequences: Sequences with their seconds, by name.
        weights: Leg weights of the pairs.

    Returns:
        The text, and by weights the score of the paper's rule and that of the default planner.
    """
    lines = [
        "weights  planner   |log2|      p5   p95   p99   max  flights p95  disagreement"
        "     taps  holds  muted"
    ]
    scores: dict[tuple[float, float], tuple[ScheduleScore, ScheduleScore]] = {}
    for shares in weights:
        paper, ours = (
            score_pairs(play_pair(*pair, shares, planner) for pair in pairs_of(sequences))
            for planner in ("paper", "footfall")
        )
        scores[shares] = paper, ours
        for name, score in (("paper", paper), ("footfall", ours)):
            low, high, highest, most = score.percentiles
            lines.append(
                f"{shares[0]:g}/{shares[1]:g}  {name:8}  {score.octaves:.3f} "
                f"{score.octaves / paper.octaves:4.2f}x  {low:.2f}  {high:.2f}  {highest:.2f}  "
                f"{most:.2f}         {score.flight_p95:.2f}   {score.disagreement:.3f} "
                f"{score.disagreement / paper.disagreement:4.2f}x  {score.taps:7.1%}  "
                f"{score.holds:5.2f}  {score.muted:5.1%}"
            )
    return "\n".join(lines), scores
