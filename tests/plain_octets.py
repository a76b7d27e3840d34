"""A pytest plugin for runs without compilation: octets as NumPy arrays of eight.

What `footfall.octets` and `footfall.octet_memory` offer is made of machine code; where nothing is
compiled, the same operations stand in for it, so that the kernels that use them run as they are.
"""

from __future__ import annotations

import math
import os
import sys
from typing import Any

import numpy as np

from footfall import octet_memory, octets

EIGHT = slice(None, octets.LANES)


def _flat(array: Any) -> Any:
    return np.asarray(array).reshape(-1)


def _load(array: Any, place: int) -> Any:
    return _flat(array)[place:][EIGHT].astype(np.float32)


def _store(array: Any, place: int, value: Any) -> None:
    _flat(array)[place:][EIGHT] = value


def _transpose(array: Any, place: int, stride: int, out: Any, out_place: int) -> None:
    rows = np.stack([_load(array, place + stride * k) for k in range(octets.LANES)])
    _flat(out)[out_place : out_place + rows.size] = rows.T.reshape(-1)


def _select(condition: Any, one: Any, other: Any) -> Any:
    if np.ndim(condition):
        return np.where(condition, np.float32(one), np.float32(other))
    return one if condition else other


def _either(of_octets: Any, of_numbers: Any) -> Any:
    def chosen(*values: Any) -> Any:
        if any(isinstance(value, np.ndarray) for value in values):
            return of_octets(*(np.asarray(value, dtype=np.float32) for value in values))
        return of_numbers(*values)

    return chosen


def _spread(value: float) -> Any:
    return np.full(octets.LANES, value, dtype=np.float32)


def _fetch_ahead(records: Any, index: int, size: int) -> None:
    """Do nothing: it only makes compiled code faster."""


PLAIN: dict[str, Any] = {
    "select": _select,
    "square_root": _either(np.sqrt, math.sqrt),
    "exponential": _either(np.exp, math.exp),
    "smaller": _either(np.fmin, min),
    "greater": _either(np.fmax, max),
    "load": _load,
    "store": _store,
    "transpose": _transpose,
    "spread": _spread,
    "fetch_ahead": _fetch_ahead,
}

if os.environ.get("NUMBA_DISABLE_JIT") == "1":
    # Eight bodies may be fewer: what is worked out of nobody is never read.
    np.seterr(divide="ignore", invalid="ignore")
    # Importing the package has already handed some of them on.
    users = [module for name, module in sys.modules.items() if name.startswith("footfall")]
    for name, plain in PLAIN.items():
        compiled = getattr(octets, name, None) or getattr(octet_memory, name)
        for user in users:
            if getattr(user, name, None) is compiled:
                setattr(user, name, plain)
