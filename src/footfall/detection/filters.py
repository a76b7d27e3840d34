"""Filters along the first axis."""

from __future__ import annotations

import math

import numpy as np

from footfall.arrays import Floats

__all__ = ["gaussian", "moving_mean", "moving_minimum"]


def _padded(values: Floats, radius: int, *, cyclic: bool) -> Floats:
    rows = np.arange(-radius, len(values) + radius)
    rows = rows % len(values) if cyclic else np.clip(rows, 0, len(values) - 1)
    return values[rows]


def moving_minimum(values: Floats, radius: int, *, cyclic: bool) -> Floats:
    """Return the least of the values up to `radius` samples away, shape (samples, ...).

    Args:
        values: One row a sample, shape (samples, ...).
        radius: >= 0.
        cyclic: Whether the last sample is followed by the first; else the end values go on.
    """
    least = _padded(values, radius, cyclic=cyclic)
    width = 2 * radius + 1
    span = 1
    while 2 * span <= width:
        least = np.minimum(least[:-span], least[span:])
        span *= 2
    rest = width - span
    return np.minimum(least[: len(values)], least[rest : rest + len(values)])


def moving_mean(values: Floats, radius: int, *, cyclic: bool) -> Floats:
    """Return the mean of the values up to `radius` samples away; see `moving_minimum`."""
    padded = _padded(values, radius, cyclic=cyclic)
    sums = np.concatenate([np.zeros((1, *values.shape[1:])), np.cumsum(padded, axis=0)])
    width = 2 * radius + 1
    return (sums[width:] - sums[:-width]) / width


def gaussian(values: Floats, deviation: float, *, cyclic: bool = False) -> Floats:
    """Return the values through a Gaussian low-pass without delay, shape (samples, ...).

    Args:
        values: One row a sample, shape (samples, ...).
        deviation: Of the Gaussian [samples], >= 0.
        cyclic: Whether the last sample is followed by the first; else the end values go on.
    """
    radius = math.ceil(3.5 * deviation) if deviation > 0.05 else 0
    if radius == 0:
        return values
    weights = np.exp(-0.5 * (np.arange(-radius, radius + 1) / deviation) ** 2)
    weights /= weights.sum()
    padded = _padded(values, radius, cyclic=cyclic)
    smooth = np.zeros_like(values)
    for index, weight in enumerate(weights):
        smooth += weight * padded[index : index + len(values)]
    return smooth
