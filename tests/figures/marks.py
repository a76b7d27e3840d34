"""Whether two pictures show the same, where two processors may have rounded differently.

A corner more or less of an outline, two outlines in another order, a limb a pixel beside: none of
it is another picture. So a picture is compared mark by mark: what each is, exactly, and where.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from collections import defaultdict
from importlib import import_module
from typing import Any

import numpy as np

from footfall.arrays import Floats

optimize: Any = import_module("scipy.optimize")

NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
PLACES = ("x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "width", "height", "viewBox", "points")


def others(one: str, other: str, tolerance: float) -> int:
    """Return how many marks of one picture have no counterpart within a tolerance [pixels]."""
    ours, theirs = _marks(one), _marks(other)
    kinds = set(ours) | set(theirs)
    return sum(_unmatched(ours.get(kind), theirs.get(kind), tolerance) for kind in kinds)


def count(svg: str) -> int:
    return sum(len(places) for places in _marks(svg).values())


def _marks(svg: str) -> dict[tuple[str, ...], Floats]:
    """Return where the marks of each kind are: numbers that a pixel may change, a row a mark."""
    found: dict[tuple[str, ...], list[list[float]]] = defaultdict(list)
    for element in ElementTree.fromstring(svg).iter():
        text = element.text or ""
        says = NUMBER.sub("#", text)
        looks = sorted(pair for pair in element.attrib.items() if pair[0] not in PLACES)
        kind = (element.tag, says, *(f"{name}={value}" for name, value in looks))
        found[kind].append([float(n) for n in NUMBER.findall(text)] + _place(element))
    return {kind: np.array(places, dtype=np.float64) for kind, places in found.items()}


def _place(element: ElementTree.Element) -> list[float]:
    place: list[float] = []
    for name in PLACES:
        numbers = np.array(NUMBER.findall(element.attrib.get(name, "")), dtype=np.float64)
        if name == "points" and len(numbers):
            corners = numbers.reshape(-1, 2)
            place += [*corners.min(axis=0), *corners.max(axis=0)]
        else:
            place += numbers.tolist()
    return place


def _unmatched(ours: Floats | None, theirs: Floats | None, tolerance: float) -> int:
    if ours is None or theirs is None:
        present = theirs if ours is None else ours
        return 0 if present is None else len(present)
    apart = np.abs(ours[:, None] - theirs[None]).max(axis=2, initial=0.0)
    pairs = optimize.linear_sum_assignment(np.minimum(apart, 10.0 * tolerance))
    near = int(np.count_nonzero(apart[pairs] <= tolerance))
    return max(len(ours), len(theirs)) - near
