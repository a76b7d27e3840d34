"""A smooth curve that is nowhere below another one."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats

__all__ = ["covered", "spread"]


def covered(needed: Floats, reach: int, cyclic: bool) -> Floats:
    """Return a smooth curve that is nowhere below another one, shape (frames,).

    Args:
        needed: That other one, >= 0.
        reach: Over how many frames before and after it builds up and fades, >= 1.
        cyclic: Whether the last frame is the first one again.
    """
    ring = needed[:-1] if cyclic else needed
    padded = np.pad(ring, 2 * reach, mode="wrap" if cyclic else "edge")
    windows = np.lib.stride_tricks.sliding_window_view(padded, 2 * reach + 1)
    smooth = np.convolve(windows.max(axis=-1), _weights(reach), mode="valid")
    return np.append(smooth, smooth[0]) if cyclic else smooth


def spread(values: Floats, reach: int, cyclic: bool) -> Floats:
    """Return the weighted sum of values over twice `reach` frames before and after.

    Args:
        values: Shape (frames, components).
        reach: >= 1.
        cyclic: Whether the last frame is the first one again.
    """
    ring = values[:-1] if cyclic else values
    padded = np.pad(ring, [(2 * reach, 2 * reach), (0, 0)], mode="wrap" if cyclic else "edge")
    windows = np.lib.stride_tricks.sliding_window_view(padded, 4 * reach + 1, axis=0)
    smooth = windows @ _weights(2 * reach)
    return np.concatenate([smooth, smooth[:1]]) if cyclic else smooth


def _weights(reach: int) -> Floats:
    weights = np.hanning(2 * reach + 3)[1:-1]
    return weights / weights.sum()
