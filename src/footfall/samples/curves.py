"""Curves through a few numbers: how the samples' parts move between what is known of them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from importlib import import_module
from typing import Any

import numpy as np

from footfall.arrays import Floats, Seconds

__all__ = ["GRAVITY", "Knot", "ballistic_speeds", "keyed", "quintic", "wave", "waypoints"]

GRAVITY = 9.81
"""Acceleration of free fall [m/s²]."""

Knot = tuple[float, float, float, float]
"""A time [s], and there the value, its first and its second derivative."""

_SMOOTHING = 0.05
"""Half the width of the window over which keyed curves are averaged [s]."""


def _interpolate() -> Any:
    """Return SciPy's splines, imported when first needed."""
    return import_module("scipy.interpolate")


def quintic(times: Seconds, knots: Sequence[Knot]) -> Floats:
    """Return the curve through knots with given derivatives, shape of `times`.

    Quintic between neighbors, so twice differentiable; between two knots that lie on one
    parabola it is that parabola, as a flight needs. Before the first and after the last knot
    it stays on their values.
    """
    nodes = [knot[0] for knot in knots]
    curve = _interpolate().BPoly.from_derivatives(nodes, [list(knot[1:]) for knot in knots])
    return np.asarray(curve(np.clip(times, nodes[0], nodes[-1])), dtype=np.float64)


def ballistic_speeds(rise: float, duration: float) -> tuple[float, float]:
    """Return the vertical speeds [m/s] at the start and the end of a flight.

    Args:
        rise: How much higher it ends than it begins [m].
        duration: How long it lasts [s].
    """
    start = rise / duration + 0.5 * GRAVITY * duration
    return start, start - GRAVITY * duration


def waypoints(
    times: Seconds,
    knots: Sequence[tuple[float, float]],
    slopes: tuple[float, float] = (0.0, 0.0),
) -> Floats:
    """Return the cubic spline through (time, value) knots, with given slopes at its ends."""
    nodes, values = zip(*knots, strict=True)
    curve = _interpolate().CubicSpline(nodes, values, bc_type=((1, slopes[0]), (1, slopes[1])))
    return np.asarray(curve(times), dtype=np.float64)


def keyed(times: Seconds, nodes: Sequence[float], values: Floats) -> Floats:
    """Return the curves through keys that never overshoot them, shape (times, ...).

    Monotone cubics (Fritsch and Carlson), averaged over a short window: the average of a once
    differentiable curve is twice differentiable. Before the first and after the last key they
    stay on its values.

    Args:
        times: Where to evaluate [s].
        nodes: Times of the keys [s], rising.
        values: Their values, shape (keys, ...).
    """
    far = 10.0
    padded = np.concatenate([[nodes[0] - far], nodes, [nodes[-1] + far]])
    held = np.concatenate([values[:1], values, values[-1:]])
    integral = _interpolate().PchipInterpolator(padded, held, axis=0).antiderivative()
    width = 2.0 * _SMOOTHING
    return np.asarray(
        (integral(times + _SMOOTHING) - integral(times - _SMOOTHING)) / width, dtype=np.float64
    )


def wave(phases: Floats, amplitude: float, peak: float, *, harmonic: int = 1) -> Floats:
    """Return a cosine over the cycle.

    Args:
        phases: Share of the cycle; any real numbers.
        amplitude: Greatest value.
        peak: Phase at which it is reached.
        harmonic: How often a cycle.
    """
    return amplitude * np.cos(2.0 * math.pi * harmonic * (phases - peak))
