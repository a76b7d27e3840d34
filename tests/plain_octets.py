"""A pytest plugin for runs without compilation: octets as NumPy arrays of eight.

What `footfall.octets` and `footfall.octet_memory` offer is made of machine code; where nothing is
compiled, the same operations stand in for it, so that the kernels that use them run as they are.
"""

from __future__ import annotations

import math
import sys
from typing import Any

import numpy as np
from numba.core import config  # pyright: ignore[reportMissingTypeStubs]

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
    if isinstance(condition, np.ndarray):
        return np.where(condition, np.float32(one), np.float32(other))
    return one if condition else other


def _either(of_octets: Any, of_numbers: Any) -> Any:
    def chosen(*values: Any) -> Any:
        if any(isinstance(value, np.ndarray) for value in values):
            return of_octets(*(np.asarray(value, dtype=np.float32) for value in values))
        return of_numbers(*values)

    return chosen


if config.DISABLE_JIT:
    for _module, _parts in (
        (
            octets,
            {
                "select": _select,
                "square_root": _either(np.sqrt, math.sqrt),
                "exponential": _either(np.exp, math.exp),
                "smaller": _either(np.fmin, min),
                "greater": _either(np.fmax, max),
            },
        ),
        (
            octet_memory,
            {
                "load": _load,
                "store": _store,
                "transpose": _transpose,
                "spread": lambda value: np.full(octets.LANES, value, dtype=np.float32),
                "fetch_ahead": lambda *_: None,
            },
        ),
    ):
        for _name, _part in _parts.items():
            _compiled = getattr(_module, _name)
            # Importing the package has already handed some of them on.
            for _user in [m for name, m in sys.modules.items() if name.startswith("footfall")]:
                if getattr(_user, _name, None) is _compiled:
                    setattr(_user, _name, _part)
