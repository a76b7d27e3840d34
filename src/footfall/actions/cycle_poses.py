"""Poses and roots of one cycle at times that differ from leg to leg."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Indices, SmallFloats
from footfall.skeleton.normalized import EFFECTORS

__all__ = ["channel_clocks", "posed", "root_steps", "root_way", "root_ways", "turned_steps"]


def posed(keys: SmallFloats, clock: Floats, legs: Indices) -> tuple[Floats, Floats]:
    """Return rotations (frames, joints + 2, 4) and lengths (frames, 7) of one cycle.

    Args:
        keys: Normalized poses.
        clock: Fractional frames of the left leg, the right leg and the rest, shape (3, frames).
        legs: Which of these clocks each channel follows, shape (channels,).
    """
    before = np.minimum(clock.astype(np.int64), len(keys) - 2)
    share = (clock - before)[legs].T
    columns: Indices = np.arange(keys.shape[1], dtype=np.int64)
    one = keys[before[legs].T, columns].astype(np.float64)
    other = keys[before[legs].T + 1, columns].astype(np.float64)
    count = keys.shape[1] - EFFECTORS
    turns = one[:, :count].reshape(len(one), -1, 4), other[:, :count].reshape(len(one), -1, 4)
    # Where a cycle starts over, a quaternion may go on as its opposite.
    same = np.einsum("fji,fji->fj", *turns)[..., np.newaxis] >= 0.0
    along = share[:, :count].reshape(turns[0].shape)
    rotations = turns[0] + along * (np.where(same, turns[1], -turns[1]) - turns[0])
    rotations /= np.linalg.norm(rotations, axis=-1, keepdims=True)
    return rotations, one[:, count:] + share[:, count:] * (other[:, count:] - one[:, count:])


def channel_clocks(leg_sides: Indices) -> Indices:
    """Return which clock each channel of a pose follows: a leg's, 0 and 1, or the body's, 2."""
    joints = np.where(leg_sides < 0, 2, leg_sides)
    return np.concatenate([np.repeat(joints, 4), np.repeat([0, 1], 4), [2], np.repeat([0, 1], 3)])


def root_steps(roots: Floats, place: Floats) -> Floats:
    """Return the root's way from each fractional frame to the next, seen from there, (n - 1, 3)."""
    frames = np.arange(len(roots), dtype=np.float64)
    return root_ways(
        np.stack([np.interp(place, frames, roots[:, column]) for column in range(3)], axis=-1)
    )


def root_ways(roots: Floats) -> Floats:
    """Return the way from each root to the next, seen from the first: x, z, turn, (n - 1, 3)."""
    moved = np.diff(roots, axis=0)
    moved[:, :2] = _turned(moved[:, :2], -roots[:-1, 2])
    return moved


def root_way(steps: Floats, begin: Floats | None = None) -> Floats:
    """Return where a root is that makes these steps, shape (n + 1, 3).

    Args:
        steps: As of `root_ways`, shape (n, 3).
        begin: Where it is at first, shape (3,); by default at the origin.
    """
    first = np.zeros(3) if begin is None else begin
    headings = first[2] + np.concatenate([[0.0], np.cumsum(steps[:, 2])])
    moved = _turned(steps[:, :2], headings[:-1])
    places = first[:2] + np.concatenate([np.zeros((1, 2)), np.cumsum(moved, axis=0)])
    return np.column_stack([places, headings])


def turned_steps(steps: Floats, pivots: Floats, turn: float) -> Floats:
    """Return steps that turn by so much altogether, what is missing being shared out evenly.

    Args:
        steps: As of `root_ways`, shape (n, 3).
        pivots: What each is turned about, so that it stays where it is: x and z as seen from where
            the step begins, shape (n, 2).
        turn: To the left [rad].
    """
    missing = np.full(len(steps), (turn - float(steps[:, 2].sum())) / len(steps))
    places = pivots + _turned(steps[:, :2] - pivots, missing)
    return np.column_stack([places, steps[:, 2] + missing])


def _turned(places: Floats, headings: Floats) -> Floats:
    """Return x and z turned about the vertical, shape (n, 2)."""
    cosine, sine = np.cos(headings), np.sin(headings)
    x, z = places[:, 0], places[:, 1]
    return np.stack([cosine * x + sine * z, cosine * z - sine * x], axis=-1)
