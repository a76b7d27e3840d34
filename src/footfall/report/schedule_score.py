"""How good a schedule is: motions off their own speed, feet in disagreement, taps.

Two planners are compared by playing the same pairs of sequences with both.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby, permutations

import numpy as np

from footfall.arrays import Flags, Floats, Indices, Seconds
from footfall.support import Support, SupportSequence
from footfall.sync.columns import combine_column
from footfall.sync.events import enter_next_slot, reconsider
from footfall.sync.paper import synchronize_column
from footfall.sync.shares import natural_duration, spend_slot
from footfall.sync.tables import Planner, Rules, SequenceTable, Window, rules_of

__all__ = ["PlayedPair", "ScheduleScore", "pairs_of", "play_pair", "score_pairs", "score_table"]

LONGEST = 6.0
"""How long two actions that never end are played [s]."""

SHORT = 0.1
"""A support that carries for less is a tap [s]."""


@dataclass(frozen=True, eq=False)
class PlayedPair:
    """Two actions played side by side, from the moment at which the second one joins."""

    sequences: tuple[SupportSequence, SupportSequence]
    """Their supports."""

    weights: tuple[float, float]
    """Their leg weights; the first has priority, also among equals."""

    phases: Indices
    """Absolute phase index, past the end of an ended one, shape (2, slots)."""

    muted: Flags
    """Whether an action plays beside the schedule, shape (2, slots)."""

    durations: Seconds
    """How long each slot lasts, shape (slots,)."""

    results: tuple[Support, ...]
    """What the blend stands on in each slot."""

    def plays(self, action: int, slot: int) -> bool:
        """Whether an action has not ended in a slot."""
        sequence = self.sequences[action]
        return sequence.cyclic or bool(self.phases[action, slot] < len(sequence.phases))


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
    """The 95th percentile over flights alone."""

    disagreement: float
    """Mean over time of the sum over both feet of 4 a (1 - a), a the share that plants it."""

    taps: float
    """Share of the supports of the blend that carry for less than `SHORT`."""

    holds: float
    """Weight of those who wait for another slot, summed over the slots, per case."""

    muted: float
    """Share of the time of all actions for which they are muted."""


def pairs_of(
    sequences: Mapping[str, SupportSequence],
) -> Iterator[tuple[SupportSequence, SupportSequence, int]]:
    """Return each ordered pair with each phase of the first in which the second may begin."""
    for one, other in permutations(sequences.values(), 2):
        for phase, begun in enumerate(one.phases):
            if begun.support & other.phases[0].support is not Support.CONFLICT:
                yield one, other, phase


def play_pair(
    one: SupportSequence,
    other: SupportSequence,
    phase: int,
    weights: tuple[float, float],
    planner: Planner,
) -> PlayedPair:
    """Play two actions until all that can end have ended, else for `LONGEST` seconds.

    Args:
        one: The running action, at the beginning of one of its phases.
        other: The action that joins it there with its first phase.
        phase: The phase of the running one.
        weights: Their leg weights and priorities.
        planner: Who decides.
    """
    rules = rules_of(planner)
    table, window = _begin(one, other, phase, weights, rules)
    phases: list[Indices] = []
    muted: list[Flags] = []
    results: list[Support] = []
    durations: list[float] = []
    clock = 0.0
    while window.results[0] != Support.CONFLICT:
        ended = [
            not sequence.cyclic and window.phases[i, 0] >= len(sequence.phases)
            for i, sequence in enumerate((one, other))
        ]
        if clock >= LONGEST if one.cyclic and other.cyclic else _all_over(one, other, ended):
            break
        durations.append(_duration(table, window, rules, ended))
        phases.append(window.phases[:, 0].copy())
        muted.append(window.muted.copy())
        results.append(Support(int(window.results[0])))
        clock += durations[-1]
        spend_slot(table, window)
        enter_next_slot(table, window, rules)
    return PlayedPair(
        (one, other),
        weights,
        np.array(phases).T,
        np.array(muted).T,
        np.array(durations),
        tuple(results),
    )


def _begin(
    one: SupportSequence,
    other: SupportSequence,
    phase: int,
    weights: tuple[float, float],
    rules: Rules,
) -> tuple[SequenceTable, Window]:
    table = SequenceTable.of([one, other])
    window = Window.empty(2, 5)
    window.sequence[:] = window.age[:] = (0, 1)
    window.priority[:] = window.weight[:] = weights
    window.playing[:] = True
    window.phases[:, 0] = (phase, 0)
    window.remaining[:] = (one.phases[phase].duration, other.phases[0].duration)
    combine_column(table, window, rules, 0)
    if rules.replans:
        reconsider(table, window, rules)
    else:
        for column in range(1, window.lookahead + 1):
            synchronize_column(table, window, rules, column)
    return table, window


def _all_over(one: SupportSequence, other: SupportSequence, ended: Sequence[bool]) -> bool:
    return all(
        over or sequence.cyclic for over, sequence in zip(ended, (one, other), strict=True)
    )


def _duration(
    table: SequenceTable, window: Window, rules: Rules, ended: Sequence[bool]
) -> float:
    if rules.replans:
        return float(window.durations[0])
    votes = [
        (window.weight[i], natural_duration(table, i, int(window.phases[i, 0])))
        for i in range(2)
        if not ended[i]
    ]
    return float(sum(w * d for w, d in votes) / sum(w for w, _ in votes))


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
        flight_p95=float(np.percentile(flights, 95.0)),
        disagreement=doubt / seconds,
        taps=float(np.mean(np.array(supports) < SHORT - 1e-9)),
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
