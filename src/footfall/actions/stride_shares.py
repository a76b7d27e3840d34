"""How much of each cycle belongs to a speed and a turn: shares that go and turn exactly as asked.

In a mix of cycles that share out its *time* as a_i, speed and turn are the means of the cycles',
weighted with a_i. Among all a_i whose means are the speed and the turn asked for, those are taken
that stay nearest to it, evened out a little (local maximum entropy: M. Arroyo and M. Ortiz, *Int.
J. Numerical Methods in Engineering* 65, 2006). So each cycle is whole where it was made, far ones
have no part in it, and shares never leap.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from footfall.arrays import Floats, Seconds, Weights

__all__ = ["Strides", "stride_shares"]

TURN_UNIT = 1.0
"""A turn of so many rad/s is as far apart as a speed of 1 m/s."""

SPREAD = 0.06
"""How far shares are evened out, against the square of the least distance of two cycles."""

LEAST = 1e-3
"""A share that would be smaller is none; the others fall by as much, so that nothing leaps."""

RIDGE = 1e-6
"""Keeps what is solved for finite at a speed and a turn that no shares have."""

ROUNDS = 60
"""Of Newton's method, at most; some eight are needed."""


class Strides(NamedTuple):
    """What each cycle does in one stride."""

    ways: Floats
    """How far it goes forward [m], shape (cycles,)."""

    turns: Floats
    """How far it turns to the left [rad], shape (cycles,)."""

    durations: Seconds
    """How long it takes [s], shape (cycles,)."""


def stride_shares(strides: Strides, speed: float, turn: float) -> Weights:
    """Return how much of each cycle a stride has, summing to one, shape (cycles,).

    Between the cycles the mix, each lasting as long as by itself, goes and turns as asked for; at
    what lies beyond them all, as nearly as shares can.

    Args:
        strides: The cycles, no two alike in speed and turn.
        speed: Forward [m/s].
        turn: To the left [rad/s].
    """
    rates = np.stack([strides.ways, strides.turns / TURN_UNIT]) / strides.durations
    apart = rates - np.array([[speed], [turn / TURN_UNIT]])
    between = ((rates[:, :, np.newaxis] - rates[:, np.newaxis]) ** 2).sum(axis=0)
    others = between[~np.eye(len(between), dtype=bool)]
    if not len(others):
        return np.ones(1)
    size = np.sqrt(others.min())
    parts = _balanced(-((apart / size) ** 2).sum(axis=0) / SPREAD, apart / size)
    shares = parts / strides.durations
    shares = np.maximum(shares / shares.sum() - LEAST, 0.0)
    return shares / shares.sum()


def _balanced(logarithms: Floats, rows: Floats) -> Weights:
    """Return the parts of one, nearest to given ones in relative entropy, that balance.

    They are the given ones times the exponential of a weighted sum of the rows; the weights are
    where a convex function is lowest, which Newton's method finds.

    Args:
        logarithms: Of what is given, shape (cycles,).
        rows: The mean of each is to be zero, shape (rows, cycles).
    """

    def leaned_by(weights: Floats) -> tuple[float, Weights]:
        powers = logarithms + weights @ rows
        most = float(powers.max())
        parts = np.exp(powers - most)
        total = float(parts.sum())
        height = most + np.log(total) + 0.5 * RIDGE * float(weights @ weights)
        return height, parts / total

    weights = np.zeros(len(rows))
    height, parts = leaned_by(weights)
    for _ in range(ROUNDS):
        mean = rows @ parts
        slope = mean + RIDGE * weights
        if np.abs(slope).max() < 1e-9:
            break
        bend = (rows * parts) @ rows.T - np.outer(mean, mean) + RIDGE * np.eye(len(rows))
        step = np.linalg.solve(bend, slope)
        # A step that is too long is halved; so short a one changes nothing any more.
        while True:
            lower, tried = leaned_by(weights - step)
            if lower <= height - 1e-4 * float(slope @ step) or np.abs(step).max() < 1e-9:
                break
            step *= 0.5
        weights, height, parts = weights - step, lower, tried
    return parts
